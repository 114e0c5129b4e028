// SPDX-License-Identifier: Apache-2.0
// Boxes and plates: sections extruded along z.
#include "mesh/primitives.hpp"

#include "hex_body.hpp"

namespace brunt::mesh {
namespace {

Mesh block_of_cells(const std::string& part, const std::vector<double>& x, const std::vector<double>& y,
                    const std::vector<double>& z) {
  Mesh mesh = hex_body(part, extrude(rectangle(x, y), z));
  const auto nx = static_cast<int>(x.size()) - 1, ny = static_cast<int>(y.size()) - 1,
             layers = static_cast<int>(z.size()) - 1;
  const auto i = [nx](LocalIndex n) { return n % (nx + 1); };
  const auto j = [nx, ny](LocalIndex n) { return n / (nx + 1) % (ny + 1); };
  const auto k = [nx, ny](LocalIndex n) { return n / ((nx + 1) * (ny + 1)); };
  add_surface_sets(mesh, {{part + "_xmin", [=](LocalIndex n) { return i(n) == 0; }},
                          {part + "_xmax", [=](LocalIndex n) { return i(n) == nx; }},
                          {part + "_ymin", [=](LocalIndex n) { return j(n) == 0; }},
                          {part + "_ymax", [=](LocalIndex n) { return j(n) == ny; }},
                          {part + "_zmin", [=](LocalIndex n) { return k(n) == 0; }},
                          {part + "_zmax", [=](LocalIndex n) { return k(n) == layers; }}});
  return mesh;
}

}  // namespace

Mesh box(const std::string& part, const Vec3& size, const Divisions<3>& elements) {
  ParameterCheck check("box " + part);
  for (int i = 0; i < 3; ++i) {
    check.positive("size", size[i]);
    check.divided("elements", nth(elements, i), 1);
  }
  check.fits((elements[0] + 1.0) * (elements[1] + 1.0) * (elements[2] + 1.0));
  check.finish();
  return block_of_cells(part, places(elements[0], 0, size[0]), places(elements[1], 0, size[1]),
                        places(elements[2], 0, size[2]));
}

Mesh plate(const std::string& part, const std::array<double, 2>& size, double thickness, const Divisions<3>& elements) {
  ParameterCheck check("plate " + part);
  for (const double s : size) check.positive("size", s);
  check.positive("thickness", thickness);
  for (const Division& n : elements) check.divided("elements", n, 1);
  check.fits((elements[0] + 1.0) * (elements[1] + 1.0) * (elements[2] + 1.0));
  check.finish();
  return block_of_cells(part, places(elements[0], -size[0] / 2, size[0] / 2),
                        places(elements[1], -size[1] / 2, size[1] / 2), places(elements[2], 0, thickness));
}

}  // namespace brunt::mesh
