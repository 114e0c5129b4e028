// SPDX-License-Identifier: Apache-2.0
// A few master faces of one body and one slave node of another, for tests of detection.
#pragma once
#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "contact/detection/detection.hpp"
#include "support/tolerances.hpp"

namespace brunt::support {

struct FewFaces {
  std::vector<contact::MasterFace> faces;
  std::vector<GlobalIndex> gid;
  std::vector<contact::NodeMotion> motion;   ///< of the corners; the slave is the last
  std::vector<Vec3> facets{Vec3(0, 0, -1)};  ///< area vectors of the slave's own surface
  contact::DetectionSettings settings{.tolerances = &brunt::test::tolerances()};
  std::vector<contact::HistoryRecord> history;  ///< what `rows` has left, taken up by the next
  double slave_thickness = 0;
  double dt = 1e-3;

  FewFaces(const std::vector<Vec3>& points, const std::vector<std::array<LocalIndex, 4>>& corners) {
    for (const Vec3& x : points) motion.push_back({.position = x});
    motion.emplace_back();
    for (std::size_t i = 0; i < motion.size(); ++i) gid.push_back(static_cast<GlobalIndex>(i));
    for (const auto& nodes : corners) faces.push_back({.key = static_cast<GlobalIndex>(faces.size()), .nodes = nodes});
  }

  std::vector<contact::Row> rows(const Vec3& position, const Vec3& velocity = Vec3::Zero()) {
    motion.back() = {position, velocity, velocity};
    contact::Candidates candidates;
    candidates.slave = {static_cast<LocalIndex>(motion.size() - 1)};
    candidates.body = {1};
    for (std::size_t f = 0; f < faces.size(); ++f) candidates.faces.values.push_back(static_cast<LocalIndex>(f));
    candidates.faces.close_row();
    for (std::size_t f = 0; f < facets.size(); ++f)
      candidates.slave_facets.values.push_back(static_cast<LocalIndex>(f));
    candidates.slave_facets.close_row();
    std::vector<contact::Row> found;
    contact::DetectionScratch scratch;
    if (std::ranges::any_of(faces, &contact::MasterFace::two_sided)) candidates.half_thickness = {slave_thickness / 2};
    detect_faces({gid, motion, dt, settings}, {candidates, faces, facets, history}, scratch, found);
    history = scratch.sides;
    return found;
  }
};

/// The unit cube, numbered as a hex8; faces: y = 0, x = 1, y = 1, x = 0, z = 0, z = 1.
inline FewFaces cube() {
  return {{Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(1, 1, 0), Vec3(0, 1, 0), Vec3(0, 0, 1), Vec3(1, 0, 1), Vec3(1, 1, 1),
           Vec3(0, 1, 1)},
          {{0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {0, 4, 7, 3}, {0, 3, 2, 1}, {4, 5, 6, 7}}};
}

/// Two unit squares that meet in the y axis and rise (valley: less than 180 degrees above them) or fall (ridge) from
/// it; `degrees`: between their upper sides. The slave's surface is the outside of a blunter wedge, or of a flat.
inline FewFaces two_slopes(double degrees) {
  const double half = 0.5 * degrees * std::numbers::pi / 180;
  const double x = std::sin(half), z = std::cos(half);
  FewFaces scene({Vec3(0, 0, 0), Vec3(0, 1, 0), Vec3(x, 0, z), Vec3(x, 1, z), Vec3(-x, 0, z), Vec3(-x, 1, z)},
                 {{0, 2, 3, 1}, {0, 1, 5, 4}});
  if (degrees < 180) scene.facets = {Vec3(z, 0, -x), Vec3(-z, 0, -x)};
  return scene;
}

/// Inside of a box: x = 0, y = 0, z = 0 seen from the positive octant; the slave is a cube's corner.
inline FewFaces box_corner() {
  FewFaces scene(
      {Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0, 0, 1), Vec3(1, 1, 0), Vec3(1, 0, 1), Vec3(0, 1, 1)},
      {{0, 2, 6, 3}, {0, 3, 5, 1}, {0, 1, 4, 2}});
  scene.facets = {Vec3(-1, 0, 0), Vec3(0, -1, 0), Vec3(0, 0, -1)};
  return scene;
}

/// Four unit squares in the plane z = 0 around the origin.
inline FewFaces flat() {
  std::vector<Vec3> points;
  for (int j = -1; j <= 1; ++j)
    for (int i = -1; i <= 1; ++i) points.emplace_back(i, j, 0);
  return {points, {{0, 1, 4, 3}, {1, 2, 5, 4}, {3, 4, 7, 6}, {4, 5, 8, 7}}};
}

}  // namespace brunt::support
