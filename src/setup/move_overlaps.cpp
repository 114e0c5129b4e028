// SPDX-License-Identifier: Apache-2.0
#include "setup/move_overlaps.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "contact/data/tolerances.hpp"
#include "core/cells.hpp"
#include "geometry/closest_point.hpp"
#include "setup/slave_choice.hpp"

namespace brunt::setup {
namespace {

constexpr int most_rounds = 200;

/// Resolves one overlap at the current coordinates: moves the node onto the face, or the corners of the face onto the
/// node. Returns the depth as a share of the face's longest edge.
double push_out(const InitialOverlap& overlap, bool node_moves, std::vector<Vec3>& x) {
  std::array<Vec3, 4> corners;
  std::size_t count = 0;
  for (const LocalIndex node : overlap.face)
    if (node != no_index) corners[count++] = nth(x, node);
  Vec3& node = nth(x, overlap.node);
  const auto closest = geometry::closest_point(node, {corners.data(), count});
  if (!closest) return 0;
  const Vec3 normal = geometry::face_normal({corners.data(), count}, closest->xi, closest->eta);
  const double depth = (closest->point - node).dot(normal);
  if (!(depth > 0)) return 0;  // resolved by a previous move
  const double share = depth / geometry::longest_edge({corners.data(), count});
  if (node_moves) {
    node += depth * normal;
    return share;
  }
  double squares = 0;
  for (const double weight : closest->weights) squares += weight * weight;
  for (std::size_t i = 0; i < count; ++i) nth(x, overlap.face[i]) -= closest->weights[i] / squares * depth * normal;
  return share;
}

/// Six times the volumes of the tetrahedra at the corners of an element.
std::vector<double> corner_volumes(const std::vector<Vec3>& x, const mesh::Block& block, LocalIndex element) {
  const LocalIndex* nodes = block.element(element);
  const auto corner = [&](int c) -> const Vec3& { return nth(x, nodes[c]); };
  const auto volume = [&](int c, int p, int q, int r) {
    return (corner(p) - corner(c)).cross(corner(q) - corner(c)).dot(corner(r) - corner(c));
  };
  if (block.shape == mesh::Shape::tet4) return {volume(0, 1, 2, 3)};
  std::vector<double> volumes;
  volumes.reserve(8);
  for (int c = 0; c < 8; ++c) {
    const auto& [p, q, r] = nth(cells::hex_neighbours, c);
    volumes.push_back(volume(c, p, q, r));
  }
  return volumes;
}

/// Smallest ratio of the new to the old volume at a corner.
double kept_share(const std::vector<Vec3>& before, const std::vector<Vec3>& after, const mesh::Block& block,
                  LocalIndex element, const contact::Tolerances& tolerances) {
  const std::vector<double> old = corner_volumes(before, block, element), now = corner_volumes(after, block, element);
  const double largest = std::ranges::max(old);
  double least = 1;
  for (std::size_t c = 0; c < old.size(); ++c)
    if (old[c] > tolerances.rounding * largest)
      least = std::min(least, now[c] / old[c]);  // corners of wedges may be flat
  return least;
}

/// Inadmissible effects of the moves from `before`.
class Judge {
 public:
  Judge(const mesh::Mesh& mesh, const std::vector<Vec3>& before, const contact::Tolerances& tolerances)
      : mesh_(mesh), before_(before), tolerances_(tolerances) {}

  [[nodiscard]] std::vector<HeldMove> moves_of_held(std::span<const HeldNodes> held) const {
    std::vector<HeldMove> moves;
    for (std::size_t k = 0; k < held.size(); ++k) {
      HeldMove found{.held = k};
      for (const LocalIndex node : held[k].nodes) {
        const Vec3 move = move_of(node);
        if (std::abs(move.dot(held[k].direction)) <= tolerances_.rounding * move.norm()) continue;
        if (found.count++ == 0) found.first = node;
      }
      if (found.count == 0) continue;
      found.distance = move_of(found.first).norm();
      moves.push_back(found);
    }
    return moves;
  }

  [[nodiscard]] std::optional<SpoiledElement> worst_element() const {
    std::optional<SpoiledElement> worst;
    double least = tolerances_.kept_volume;
    for (std::size_t b = 0; b < mesh_.blocks.size(); ++b) {
      const mesh::Block& block = mesh_.blocks[b];
      for (LocalIndex e = 0; e < block.count(); ++e) {
        if (!has_moved(block, e)) continue;
        const double share = kept_share(before_, mesh_.coordinates, block, e, tolerances_);
        if (share >= least) continue;
        least = share;
        worst = {b, e, share, tolerances_.kept_volume};
      }
    }
    return worst;
  }

 private:
  [[nodiscard]] Vec3 move_of(LocalIndex node) const { return nth(mesh_.coordinates, node) - nth(before_, node); }

  [[nodiscard]] bool has_moved(const mesh::Block& block, LocalIndex element) const {
    const LocalIndex* nodes = block.element(element);
    return std::any_of(nodes, nodes + mesh::nodes_per_element(block.shape),
                       [&](LocalIndex node) { return !move_of(node).isZero(0); });
  }

  const mesh::Mesh& mesh_;
  const std::vector<Vec3>& before_;
  const contact::Tolerances& tolerances_;
};

/// Iterates; returns the remaining overlaps.
std::vector<InitialOverlap> push_all_out(mesh::Mesh& mesh, const StartRules& rules, const InitialGaps& before) {
  const SlaveChoice choice(mesh, rules);
  InitialGaps gaps = before;
  for (int pass = 0;; ++pass) {
    std::erase_if(gaps.overlaps, [](const InitialOverlap& overlap) { return !overlap.is_moved(); });
    if (gaps.overlaps.empty() || pass == most_moving_passes) return gaps.overlaps;
    const auto is_slave = [&](const InitialOverlap& o) {
      return choice.is_slave(o.block, o.body, o.other_block, o.other_body);
    };
    const bool slaves_first = std::ranges::any_of(gaps.overlaps, is_slave);
    std::erase_if(gaps.overlaps,
                  [&](const InitialOverlap& o) { return is_slave(o) != slaves_first || o.face[0] == no_index; });
    const contact::Tolerances& tolerances = *rules.contact.tolerances;
    double deepest = 1;  // nodes behind one face move the same corners: some iterations are needed
    for (int round = 0; round < most_rounds && deepest > tolerances.slight * tolerances.touching; ++round) {
      deepest = 0;
      for (const InitialOverlap& overlap : gaps.overlaps)
        deepest = std::max(deepest, push_out(overlap, slaves_first, mesh.coordinates));
    }
    gaps = initial_gaps(mesh, rules);
  }
}

}  // namespace

OverlapMoves move_overlaps(mesh::Mesh& mesh, const StartRules& rules, std::span<const HeldNodes> held,
                           const InitialGaps& gaps) {
  OverlapMoves moves;
  const std::vector<Vec3> before = mesh.coordinates;
  moves.left = push_all_out(mesh, rules, gaps);
  const Judge judge(mesh, before, *rules.contact.tolerances);
  moves.held = judge.moves_of_held(held);
  moves.spoiled = judge.worst_element();
  if (moves.refused()) {
    mesh.coordinates = before;
    return moves;
  }
  for (std::size_t i = 0; i < before.size(); ++i) {
    const double move = (mesh.coordinates[i] - before[i]).norm();
    if (move > 0) ++moves.nodes;
    moves.largest = std::max(moves.largest, move);
  }
  return moves;
}

}  // namespace brunt::setup
