// SPDX-License-Identifier: Apache-2.0
// Sections of generated bodies in the x-y plane.
#pragma once
#include <array>
#include <vector>

#include "mesh/division.hpp"
#include "mesh/mesh.hpp"
#include "mesh/round_form.hpp"
#include "rounded_core.hpp"

namespace brunt::mesh {

/// Quadrilaterals in the x-y plane, each counter-clockwise seen from z+.
struct Section {
  std::vector<std::array<double, 2>> points;
  std::vector<std::array<LocalIndex, 4>> quads;
};

/// Between these places along x and along y; points in rows, x fastest.
Section rectangle(const std::vector<double>& x, const std::vector<double>& y);

/// So many elements from the axis outwards rings are circles.
int round_from(const Division& across);

/// The map of a solid round body whose radius is divided so.
RoundedCore rounded_core(double radius, const Division& across);

/// A disk: core cells in rows, then rings from the core outwards; the last `elements_around` points are on its circle.
Section butterfly(const RoundedCore& core);

/// The cells on the sides that are kept, with their points in the same order; `tag` of each point stays with it.
void keep_half(Section& section, std::vector<char>& tag, const Half& half);

/// Points on rays from the axis, ray by ray outwards. A ring that is closed has as many rays as elements around.
struct Rays {
  std::vector<double> radius;                  ///< ascending; 0 first: all rays begin in one point
  std::vector<std::array<double, 2>> cosines;  ///< of each ray: cosine, sine
  bool closed = true;

  [[nodiscard]] bool solid() const { return radius.front() == 0; }
  [[nodiscard]] int cells() const { return static_cast<int>(cosines.size()) - (closed ? 0 : 1); }
  [[nodiscard]] LocalIndex point(int ray, int place) const;
};

/// `around`: of the whole, or of the sector.
std::vector<std::array<double, 2>> ray_directions(int around, const RoundForm& form, bool& closed);

Section annulus(const Rays& rays);

}  // namespace brunt::mesh
