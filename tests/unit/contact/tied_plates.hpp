// SPDX-License-Identifier: Apache-2.0
// Two tied meshes of unlike faces, for tests of ties with integrated weights.
#pragma once
#include <Eigen/Geometry>
#include <functional>
#include <numeric>

#include "contact/anchors/mortar_ties.hpp"
#include "contact/data/tolerances.hpp"
#include "contact/mortar_rows/tie_weights.hpp"

namespace brunt::test {

/// A slave of n x n faces of edge 1/n that look down on a master of m x m, of edge `size` and turned by `angle` about
/// the middle.
struct TiedPlates {
  std::vector<contact::NodeMotion> motion;
  std::vector<GlobalIndex> gid;
  std::vector<contact::MasterFace> faces;
  contact::MortarCandidates candidates;
  LocalIndex slaves = 0;  ///< nodes with lower numbers
  contact::MortarTies ties;
  std::vector<LocalIndex> places;
  std::vector<contact::Arm> arms;
  std::vector<contact::Mobility> mobility;  ///< free masses of 1

  /// bend: where nodes of the plane are.
  TiedPlates(
      int n, int m, double size, double angle, double gap,
      const std::function<Vec3(const Vec3&)>& bend = [](const Vec3& x) { return x; }) {
    const auto node = [&](const Vec3& place) {
      motion.push_back({bend(place), Vec3::Zero(), Vec3::Zero()});
      gid.push_back(static_cast<GlobalIndex>(gid.size()));
    };
    for (int j = 0; j <= n; ++j)
      for (int i = 0; i <= n; ++i) node({double(i) / n, double(j) / n, gap});
    slaves = static_cast<LocalIndex>(gid.size());
    const Eigen::AngleAxisd turn(angle, Vec3::UnitZ());
    for (int j = 0; j <= m; ++j)
      for (int i = 0; i <= m; ++i)
        node(Vec3(0.5, 0.5, 0) + turn * (size * Vec3(double(i) / m - 0.5, double(j) / m - 0.5, 0)));
    add_faces(n, m);
    integrate();
  }

  [[nodiscard]] contact::MortarScene scene() const {
    return {candidates, faces, gid, motion, contact::standard_tolerances};
  }
  [[nodiscard]] const Vec3& place(LocalIndex node) const { return nth(motion, node).position; }

  std::vector<contact::Row> rows(double recovery = 0.1, double dt = 0.5) {
    std::vector<contact::Row> made;
    contact::append_mortar_ties({ties, places, motion, mobility, {}, recovery, dt}, arms, made);
    return made;
  }
  /// On each node by a traction of 1 in all rows [length^2].
  [[nodiscard]] std::vector<double> forces() const {
    std::vector<double> force(gid.size(), 0.0);
    for (std::size_t k = 0; k < places.size(); ++k) {
      const auto row = std::ranges::upper_bound(ties.nodes.offsets, static_cast<LocalIndex>(k)) - 1;
      nth(force, places[k]) += nth(ties.rows, row - ties.nodes.offsets.begin()).area * ties.weights[k];
    }
    return force;
  }

 private:
  void add_faces(int n, int m) {
    const auto quad = [](LocalIndex start, int columns, int i, int j) {
      const LocalIndex a = start + i + (columns + 1) * j, b = a + columns + 1;
      return std::array<LocalIndex, 4>{a, a + 1, b + 1, b};
    };
    for (int j = 0; j < m; ++j)
      for (int i = 0; i < m; ++i)
        faces.push_back({.key = 1000 + static_cast<GlobalIndex>(faces.size()),
                         .nodes = quad(slaves, m, i, j),
                         .body = 1,
                         .element_depth = 1});
    std::vector<LocalIndex> all(faces.size());
    std::iota(all.begin(), all.end(), 0);
    std::vector<std::vector<LocalIndex>> around(static_cast<std::size_t>(slaves));
    for (int j = 0; j < n; ++j)
      for (int i = 0; i < n; ++i) {
        auto [a, b, c, d] = quad(0, n, i, j);
        const auto facet = static_cast<LocalIndex>(candidates.facets.size());
        candidates.facets.push_back({.key = facet, .nodes = {a, d, c, b}, .element_depth = 1});
        for (const LocalIndex corner : {a, b, c, d}) nth(around, corner).push_back(facet);
        candidates.masters.values.insert(candidates.masters.values.end(), all.begin(), all.end());
        candidates.masters.close_row();
      }
    for (LocalIndex s = 0; s < slaves; ++s) {
      candidates.slave.push_back(s);
      candidates.around.values.insert(candidates.around.values.end(), nth(around, s).begin(), nth(around, s).end());
      candidates.around.close_row();
    }
  }
  void integrate() {
    contact::TieCovers covers = contact::find_tie_covers(scene());
    const std::vector<Vec3> sides = contact::tied_sides(scene(), covers);
    contact::settle_functions(scene(), sides, covers);
    ties = contact::tie_weights(scene(), sides, covers);
    for (const GlobalIndex node : ties.nodes.values) places.push_back(static_cast<LocalIndex>(node));
    arms.resize(places.size());
    mobility.assign(motion.size(), {1, Mat3::Identity()});
  }
};

}  // namespace brunt::test
