// SPDX-License-Identifier: Apache-2.0
// Random rows between rigid boxes and free nodes, with wrong impulses to start from: what an iteration that ends early
// may leave.
#pragma once
#include <algorithm>
#include <cmath>
#include <random>

#include "boxes.hpp"

namespace brunt::contact {

struct RandomRows : BoxProblem {
  std::mt19937 random;
  std::vector<int> cluster_of_box, cluster_of_node, cluster_of_row;

  /// clusters: of rows that share nothing that moves. recovers: some rows require that depth or slip is recovered.
  explicit RandomRows(unsigned seed, int clusters = 1, bool recovers = false) : random(seed) {
    for (int c = 0; c < clusters; ++c) add_cluster(c, recovers);
    for (const Row& row : rows) impulses.push_back(20 * size_of_impulses * some_impulse(row));
  }
  [[nodiscard]] double part(double low = -1, double high = 1) {
    return std::uniform_real_distribution<double>(low, high)(random);
  }
  [[nodiscard]] Vec3 vector() { return {part(), part(), part()}; }
  /// Of what moves in a cluster, before or after the solution.
  [[nodiscard]] double energy_of(int cluster, bool after) const {
    double sum = 0;
    for (std::size_t n = 0; n < motion.size(); ++n)
      if (mobility[n].inverse_mass > 0 && cluster_of_node[n] == cluster)
        sum += 0.5 / mobility[n].inverse_mass * (after ? velocity[n] : motion[n].predicted).squaredNorm();
    for (std::size_t b = 0; b < boxes.size(); ++b) {
      if (cluster_of_box[b] != cluster) continue;
      const auto body = static_cast<LocalIndex>(b);
      const Vec3 v = after ? velocity_of(body) : boxes[b].velocity, w = after ? spin_of(body) : boxes[b].spin;
      sum += 0.5 * boxes[b].mass * v.squaredNorm() + 0.5 * w.dot(boxes[b].inertia() * w);
    }
    return sum;
  }
  /// By compliant rows: before the solution the part of the impulses of the last step that they keep.
  [[nodiscard]] double stored_in(int cluster, bool after) const {
    double sum = 0;
    for (std::size_t q = 0; q < rows.size(); ++q)
      if (const double c = scratch.compliance[q]; c > 0 && cluster_of_row[q] == cluster)
        sum += after ? 0.5 * c * impulses[q].squaredNorm() : 0.5 * scratch.borne[q].squaredNorm() / c;
    return sum;
  }
  /// What recovery may have supplied.
  [[nodiscard]] double recovered_in(int cluster) const {
    double sum = 0;
    for (std::size_t q = 0; q < rows.size(); ++q)
      if (cluster_of_row[q] == cluster)
        sum += std::max(0.0, push(q) * rows[q].required) + std::max(0.0, impulses[q].dot(rows[q].drift));
    return sum;
  }
  /// Of everything, less what rows with an immovable partner have supplied.
  [[nodiscard]] Vec3 momentum_error() const {
    Vec3 sum = Vec3::Zero();
    for (std::size_t n = 0; n < motion.size(); ++n)
      if (mobility[n].inverse_mass > 0) sum += (velocity[n] - motion[n].predicted) / mobility[n].inverse_mass;
    for (std::size_t b = 0; b < boxes.size(); ++b)
      sum += boxes[b].mass * answer(static_cast<LocalIndex>(b)).change.head<3>();
    for (std::size_t q = 0; q < rows.size(); ++q)
      if (rows[q].node_count == 1) sum -= impulses[q];
    return sum;
  }

 private:
  static constexpr double size_of_impulses = 0.3;

  void add_cluster(int cluster, bool recovers) {
    const auto first_box = static_cast<LocalIndex>(boxes.size());
    const int count = 2 + static_cast<int>(part(0, 4));
    for (int b = 0; b < count; ++b) {
      add_box({.centre = vector(),
               .size = Vec3::Constant(0.7) + 0.4 * vector(),
               .mass = std::pow(10.0, part(-2, 2)),
               .velocity = vector(),
               .spin = vector()});
      cluster_of_box.push_back(cluster);
    }
    std::vector<LocalIndex> nodes;
    for (int n = 0; n < 6; ++n) {
      nodes.push_back(add_node(std::pow(10.0, part(-2, 2)), vector()));
      cluster_of_node.push_back(cluster);
    }
    const int wanted = 10 + static_cast<int>(part(0, 30));
    for (int q = 0; q < wanted; ++q) {
      const auto some_point = [&] {
        if (part() < -0.4) return nodes[static_cast<std::size_t>(part(0, 6))];
        const auto body = first_box + static_cast<LocalIndex>(part(0, count));
        cluster_of_node.push_back(cluster);
        return add_point(body, boxes[static_cast<std::size_t>(body)].centre + 0.5 * vector());
      };
      add_some_row(some_point(), some_point(), part() < -0.5, recovers);
      cluster_of_row.push_back(cluster);
    }
  }
  void add_some_row(LocalIndex slave, LocalIndex master, bool with_floor, bool recovers) {
    const Vec3 normal = vector().normalized();
    Row& row =
        with_floor || slave == master ? add_row({{slave, 1}}, normal) : add_row({{slave, 1}, {master, -1}}, normal);
    row.required = part(-1, recovers ? 0.5 : 0);
    const double kind = part();
    if (kind < -0.9) {
      row.holds = true;
      row.cone = Cone::free;
    } else if (kind < 0) {
      row.friction = part(0, 1.5);
    }
    if (recovers && (row.holds || row.friction > 0)) row.drift = 0.1 * normal.cross(vector());
    if (!recovers && row.holds) row.required = 0;
    if (!row.holds && part() < 0) {
      row.softness = 0.05;
      row.gap_share = 0.05;
    }
  }
  Vec3 some_impulse(const Row& row) {
    const Vec3 push = part(row.holds ? -1 : 0, 1) * row.normal;
    const Vec3 across =
        (row.holds ? 1.0 : part(0, row.friction) * push.norm()) * row.normal.cross(vector()).normalized();
    return row.holds || row.friction > 0 ? Vec3(push + across) : push;
  }
};

}  // namespace brunt::contact
