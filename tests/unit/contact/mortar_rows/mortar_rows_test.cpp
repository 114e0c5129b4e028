// SPDX-License-Identifier: Apache-2.0
// Weights of mortar rows between two plane meshes of unlike faces: consistent nodal forces of a uniform pressure, exact
// for linear motions, also after a slip.
#include "contact/mortar_rows/mortar_rows.hpp"

#include <Eigen/Geometry>
#include <catch2/catch.hpp>
#include <cmath>
#include <numeric>

#include "contact/data/tolerances.hpp"

using namespace brunt;
using namespace brunt::contact;

namespace {

/// A slave of n x n faces of edge 1/n that look down on a master of m x m, which is turned by `angle` about the middle.
struct TwoPlates {
  std::vector<NodeMotion> motion;
  std::vector<GlobalIndex> gid;
  std::vector<MasterFace> faces;
  MortarCandidates candidates;

  TwoPlates(int n, int m, double size, double angle, double gap) {
    const auto node = [&](const Vec3& place) {
      motion.push_back({place, Vec3::Zero(), Vec3::Zero()});
      gid.push_back(static_cast<GlobalIndex>(gid.size()));
    };
    for (int j = 0; j <= n; ++j)
      for (int i = 0; i <= n; ++i) node({double(i) / n, double(j) / n, gap});
    const LocalIndex first = static_cast<LocalIndex>(gid.size());
    const Eigen::AngleAxisd turn(angle, Vec3::UnitZ());
    for (int j = 0; j <= m; ++j)
      for (int i = 0; i <= m; ++i)
        node(Vec3(0.5, 0.5, 0) + turn * (size * Vec3(double(i) / m - 0.5, double(j) / m - 0.5, 0)));
    const auto quad = [](LocalIndex start, int columns, int i, int j) {
      const LocalIndex a = start + i + (columns + 1) * j, b = a + columns + 1;
      return std::array<LocalIndex, 4>{a, a + 1, b + 1, b};
    };
    for (int j = 0; j < m; ++j)
      for (int i = 0; i < m; ++i)
        faces.push_back(
            {.key = 1000 + static_cast<GlobalIndex>(faces.size()), .nodes = quad(first, m, i, j), .body = 1});
    std::vector<LocalIndex> all(faces.size());
    std::iota(all.begin(), all.end(), 0);
    std::vector<std::vector<LocalIndex>> around(static_cast<std::size_t>(first));
    for (int j = 0; j < n; ++j)
      for (int i = 0; i < n; ++i) {
        auto [a, b, c, d] = quad(0, n, i, j);
        const auto facet = static_cast<LocalIndex>(candidates.facets.size());
        candidates.facets.push_back({.key = facet, .nodes = {a, d, c, b}, .element_depth = 1});
        for (const LocalIndex corner : {a, b, c, d}) nth(around, corner).push_back(facet);
        candidates.masters.values.insert(candidates.masters.values.end(), all.begin(), all.end());
        candidates.masters.close_row();
      }
    for (LocalIndex s = 0; s < first; ++s) {
      candidates.slave.push_back(s);
      candidates.around.values.insert(candidates.around.values.end(), nth(around, s).begin(), nth(around, s).end());
      candidates.around.close_row();
    }
    candidates.any = true;
  }
  [[nodiscard]] MortarScene scene() const { return {candidates, faces, gid, motion, standard_tolerances}; }
};

struct Kept {
  MortarHistory history;
  std::vector<LocalIndex> places;
  MortarScratch scratch;
  std::vector<Row> rows;

  void step(const TwoPlates& plates, const DetectionSettings& settings) {
    renew_weights(plates.scene(), history, places, scratch);
    rows.clear();
    append_mortar_rows({plates.gid, plates.motion, 1e-3, settings}, plates.scene(), places, history, scratch, rows);
  }
  /// On each node by a pressure of 1 in all rows [length^2].
  [[nodiscard]] std::vector<double> forces(std::size_t nodes) const {
    std::vector<double> force(nodes, 0.0);
    for (const Row& row : rows) {
      const auto head = std::ranges::find(history.heads, row.key, &MortarHead::key);
      for (std::size_t i = 0; i < row.points().size(); ++i) nth(force, row.points()[i]) += head->area * row.shares()[i];
    }
    return force;
  }
};

double tributary(int i, int j, int n) {
  const auto half = [&](int k) { return k == 0 || k == n ? 0.5 : 1.0; };
  return half(i) * half(j) / (n * n);
}

}  // namespace

TEST_CASE("a uniform pressure has consistent forces on both sides of unlike meshes") {
  const DetectionSettings settings;
  for (const auto& [n, m] : {std::pair{4, 3}, {3, 4}, {5, 2}, {6, 6}}) {
    const TwoPlates plates(n, m, 1, 0, -1e-6);
    Kept kept;
    kept.step(plates, settings);
    REQUIRE(kept.rows.size() == static_cast<std::size_t>((n + 1) * (n + 1)));
    const std::vector<double> force = kept.forces(plates.gid.size());
    std::size_t at = 0;
    for (int j = 0; j <= n; ++j)
      for (int i = 0; i <= n; ++i) CHECK(std::abs(force[at++] - tributary(i, j, n)) < 1e-13);
    for (int j = 0; j <= m; ++j)
      for (int i = 0; i <= m; ++i) CHECK(std::abs(force[at++] + tributary(i, j, m)) < 1e-13);
  }
}

TEST_CASE("rows of partly covered facets transmit force and moment of a uniform pressure") {
  const DetectionSettings settings;
  const TwoPlates plates(5, 4, 0.73, 0.4, -1e-6);  // the master lies within the slave, turned
  Kept kept;
  kept.step(plates, settings);
  const std::vector<double> force = kept.forces(plates.gid.size());
  Vec3 sum = Vec3::Zero();  // force, and moments about x and y
  const std::size_t first = 36;
  for (std::size_t i = first; i < force.size(); ++i) {
    const Vec3& x = plates.motion[i].position;
    sum += force[i] * Vec3(1, x[0], x[1]);
  }
  CHECK(std::abs(sum[0] + 0.73 * 0.73) < 1e-12);
  CHECK(std::abs(sum[1] - 0.5 * sum[0]) < 1e-12);
  CHECK(std::abs(sum[2] - 0.5 * sum[0]) < 1e-12);
  for (int j = 0; j <= 4; ++j)
    for (int i = 0; i <= 4; ++i)
      CHECK(std::abs(force[first + static_cast<std::size_t>(5 * j + i)] + 0.73 * 0.73 * tributary(i, j, 4)) < 1e-12);
}

TEST_CASE("rows follow a slip without a moment, and know linear motions") {
  const DetectionSettings settings;
  TwoPlates plates(4, 3, 1.4, 0.3, -1e-5);
  Kept kept;
  kept.step(plates, settings);
  for (std::size_t i = 0; i < 25; ++i) plates.motion[i].position += Vec3(0.009, -0.005, 0);  // less than 5 % of an edge
  kept.step(plates, settings);
  REQUIRE(kept.history.heads.front().age == 1);
  REQUIRE(kept.rows.size() == 25);
  for (const Row& row : kept.rows) {
    Vec3 apart = Vec3::Zero();
    double sum = 0, linear = 0;
    for (std::size_t i = 0; i < row.points().size(); ++i) {
      const Vec3& x = nth(plates.motion, row.points()[i]).position;
      apart += row.shares()[i] * x;
      sum += row.shares()[i];
      linear += row.shares()[i] * (3 - 2 * x[0] + x[1]);
    }
    CHECK(std::abs(sum) < 1e-13);
    CHECK((apart - Vec3(0, 0, -1e-5)).norm() < 1e-13);
    CHECK(std::abs(linear) < 1e-13);
    CHECK(std::abs(row.gap) < 1e-13);  // the depth of a new row is born with it
    CHECK((row.normal - Vec3::UnitZ()).norm() < 1e-13);
  }
  for (std::size_t i = 0; i < 25; ++i) plates.motion[i].position += Vec3(0.009, 0, 0);
  kept.step(plates, settings);
  CHECK(kept.history.heads.front().age == 0);  // integrated anew
}

TEST_CASE("a ridge across a slave's facets leaves its nodes to other rows") {
  const DetectionSettings settings;
  TwoPlates plates(4, 2, 1, 0, -1e-5);
  for (std::size_t i = 25; i < plates.motion.size(); ++i) {  // slopes of 17 degrees
    Vec3& x = plates.motion[i].position;
    x[2] -= 0.3 * std::abs(x[0] - 0.5);
  }
  Kept kept;
  kept.step(plates, settings);
  for (const MortarHead& head : kept.history.heads)
    CHECK(std::abs(nth(plates.motion, static_cast<LocalIndex>(head.key.slave)).position[0] - 0.5) > 0.2);
}
