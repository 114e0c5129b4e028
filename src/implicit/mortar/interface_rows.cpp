// SPDX-License-Identifier: Apache-2.0
#include "interface_rows.hpp"

#include "contact/mortar/points.hpp"

namespace brunt::implicit {

void find_rows_at(Interface& face, std::span<const Vec3> x) {
  if (face.of_points)
    contact::point_rows(face.surfaces, face.topology, face.search.candidates, x, face.iterate.rows);
  else
    contact::mortar_rows(face.surfaces, face.topology, face.search.candidates, x, *face.scratch, face.iterate.rows);
}

void find_slopes_at(Interface& face, std::span<const Vec3> x, std::span<const Vec3> tractions,
                    std::span<const Vec3> fixed, std::span<const Vec3> transposed) {
  if (face.of_points)
    contact::point_rows_and_slopes(face.surfaces, face.topology, face.search.candidates, x, tractions,
                                   face.iterate.rows, face.iterate.slopes, fixed, transposed);
  else
    contact::mortar_rows_and_slopes(face.surfaces, face.topology, face.search.candidates, x, tractions, *face.scratch,
                                    face.iterate.rows, face.iterate.slopes, fixed, transposed);
}

}  // namespace brunt::implicit
