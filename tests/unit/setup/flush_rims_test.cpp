// SPDX-License-Identifier: Apache-2.0
// Half spheres on cylinders of the same radius: rims of coincident nodes touch, and are no edges that pierce. Edges
// that do pierce beside a sharp rim are found all the same.
#include <catch2/catch.hpp>

#include "mesh/assemble.hpp"
#include "mesh/primitives.hpp"
#include "setup/initial_gaps.hpp"
#include "setup/piercings.hpp"
#include "unit/setup/rules.hpp"

using namespace brunt;

namespace {

constexpr double degree = 0.017453292519943295;  // [rad]

struct Placing {
  double scale = 1;
  Vec3 axis{0, 0, 1};
  double degrees = 0;
  Vec3 at = Vec3::Zero();
};

/// The half sphere over z = 0 (turned about z by `turn`) and the cylinder under it, both then placed alike.
struct NoseAndRod {
  double radius = 5;
  int elements = 6, along = 4;
  double turn = 0;
  Vec3 shift = Vec3::Zero();  ///< of the half sphere alone
  int half = 2;               ///< axis of the half sphere as it is made
  bool flipped = false;       ///< the half sphere and the cylinder change sides by half a turn about x
};

mesh::Mesh nose_on_rod(const NoseAndRod& form, const Placing& placing, bool rod_first) {
  mesh::SphereForm sphere;
  sphere.half[static_cast<std::size_t>(form.half)] = true;
  mesh::Mesh nose = mesh::sphere("nose", form.radius, form.elements, sphere);
  if (form.half == 0) mesh::place(nose, 1, {0, 1, 0}, -90, Vec3::Zero());
  if (form.half == 1) mesh::place(nose, 1, {1, 0, 0}, 90, Vec3::Zero());
  mesh::place(nose, 1, {0, 0, 1}, form.turn, form.shift);
  const double length = form.radius * form.along / form.elements;
  mesh::Mesh rod = mesh::cylinder("rod", form.radius, length, {form.elements, form.along});
  mesh::place(rod, 1, {0, 0, 1}, 0, {0, 0, -length});
  for (mesh::Mesh* body : {&nose, &rod}) {
    if (form.flipped) mesh::place(*body, 1, {1, 0, 0}, 180, Vec3::Zero());
    mesh::place(*body, placing.scale, placing.axis, placing.degrees, placing.at);
  }
  mesh::Mesh mesh;
  mesh::append(mesh, std::move(rod_first ? rod : nose));
  mesh::append(mesh, std::move(rod_first ? nose : rod));
  return mesh;
}

/// Do nodes, edges or elements of the two lie in each other?
bool overlap(const mesh::Mesh& mesh) {
  const setup::InitialGaps gaps = setup::initial_gaps(mesh, test::all_touch(2, setup::OverlapRule::error, true));
  return !gaps.overlaps.empty() || !gaps.piercings.empty() || !gaps.shared.empty();
}

}  // namespace

TEST_CASE("flush rims: a half sphere on a cylinder of its radius touches it") {
  const int elements = GENERATE(2, 3, 5, 6, 8);
  const int half = GENERATE(0, 1, 2);
  const bool flipped = GENERATE(false, true), rod_first = GENERATE(false, true);
  CAPTURE(elements, half, flipped, rod_first);
  const NoseAndRod form{.elements = elements, .half = half, .flipped = flipped};
  CHECK_FALSE(overlap(nose_on_rod(form, {}, rod_first)));
}

TEST_CASE("flush rims: of any radius, turned, scaled, far from the origin") {
  const double radius = GENERATE(5e-4, 1.0, 5.0, 137.3), turn = GENERATE(0.0, 6.0, 45.0, 57.3);
  const bool rod_first = GENERATE(false, true);
  const auto placing = GENERATE(Placing{}, Placing{.scale = 1e-3, .axis = {1, 0.3, -0.2}, .degrees = 23},
                                Placing{.axis = {0, 1, 0.1}, .degrees = 120, .at = {300, -200, 500}});
  CAPTURE(radius, turn, rod_first, placing.scale);
  const NoseAndRod form{.radius = radius, .elements = 6, .turn = turn};
  Placing placed = placing;
  placed.at *= radius;
  CHECK_FALSE(overlap(nose_on_rod(form, placed, rod_first)));
}

TEST_CASE("flush rims: two half spheres, two cylinders end to end, a cylinder on a tube") {
  const double turn = GENERATE(0.0, 11.25, 180.0), radius = GENERATE(0.7, 5.0);
  const int pair = GENERATE(0, 1, 2), elements = GENERATE(3, 6);
  mesh::SphereForm half;
  half.half[2] = true;
  mesh::Mesh upper = pair == 0 ? mesh::sphere("nose", radius, elements, half)
                               : mesh::cylinder("nose", radius, radius, {elements, elements});
  mesh::Mesh lower = pair == 0 ? mesh::sphere("rod", radius, elements, half)
                     : pair == 1
                         ? mesh::cylinder("rod", radius, radius, {elements, elements})
                         : mesh::tube("rod", 0.6 * radius, radius, radius, {2, mesh::elements_around(elements), 3});
  mesh::place(lower, 1, {1, 0, 0}, 180, Vec3::Zero());
  mesh::place(lower, 1, {0, 0, 1}, turn, Vec3::Zero());
  mesh::append(upper, std::move(lower));
  mesh::place(upper, 1, {3, 1, 2}, 35, Vec3::Zero());
  CAPTURE(pair, turn, radius, elements);
  CHECK_FALSE(overlap(upper));
}

TEST_CASE("flush rims: shifted sideways or apart by a little they touch or are apart") {
  const double share = GENERATE(1e-3, 1e-2, 0.1);
  const NoseAndRod form{.radius = 6, .elements = 6, .shift = share * Vec3(GENERATE(-1.0, 0.6, 1.0), 0.8, 0)};
  CHECK_FALSE(overlap(nose_on_rod(form, {}, false)));
  NoseAndRod apart = form;
  apart.shift = {0, 0, share};
  CHECK_FALSE(overlap(nose_on_rod(apart, {}, false)));
}

TEST_CASE("flush rims: pushed into each other by a share of an element they overlap") {
  const double share = GENERATE(1e-3, 1e-2, 0.1);
  const NoseAndRod form{.radius = 6, .elements = 6, .shift = {0, 0, -share}};
  CHECK(overlap(nose_on_rod(form, {}, GENERATE(false, true))));
}

namespace {

/// The half sphere of unit elements at the rim, and a rod as thin as a hundredth of one that stands across its flat
/// face, with its nearest edge `inside` of the rim, where the rim is straight between two nodes.
std::size_t rod_edges_through_rim(double inside, double degrees) {
  mesh::SphereForm form;
  form.half[2] = true;
  mesh::Mesh mesh = mesh::sphere("nose", 6, 6, form);
  Vec3 a = Vec3::Zero(), b = Vec3::Zero();  // the rim's nodes next to the axis x
  for (const Vec3& x : mesh.coordinates) {
    if (x.z() != 0 || std::abs(x.norm() - 6) > 1e-9) continue;
    const double angle = std::atan2(x.y(), x.x());
    if (std::abs(angle) < 1e-9) a = x;
    if (angle > 1e-9 && (b.norm() == 0 || angle < std::atan2(b.y(), b.x()))) b = x;
  }
  const Vec3 along = (b - a).normalized(), inwards(-along.y(), along.x(), 0);
  const Vec3 place = 0.4 * a + 0.6 * b + inside * inwards;
  mesh::Mesh rod = mesh::box("rod", {0.01, 0.01, 8}, {1, 1, 1});
  mesh::place(rod, 1, {0, 0, 1}, std::atan2(inwards.y(), inwards.x()) / degree, {place.x(), place.y(), -4});
  mesh::append(mesh, std::move(rod), "");
  mesh::place(mesh, 1, {1, 2, 3}, degrees, Vec3::Zero());
  const std::vector<setup::Solid> solids = setup::solids_of(mesh);
  const std::vector<char> none(mesh.coordinates.size(), 0);
  return setup::piercing_edges(mesh, solids[1], solids[0], none).size();
}

}  // namespace

TEST_CASE("flush rims: an edge that pierces a hair inside a sharp rim is found, and none outside of it") {
  const double share = GENERATE(1e-3, 1e-2, 0.1), degrees = GENERATE(0.0, 17.0, 97.0);
  CAPTURE(share, degrees);
  CHECK(rod_edges_through_rim(share, degrees) == 4);
  CHECK(rod_edges_through_rim(-share - 0.02, degrees) == 0);
}
