// SPDX-License-Identifier: Apache-2.0
#include "move_overlaps.hpp"

#include <fmt/core.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "brunt/geometry/closest_point.hpp"
#include "brunt/scene/select.hpp"
#include "slave_choice.hpp"

namespace brunt::app {
namespace {

constexpr int most_passes = 20, most_rounds = 200;
constexpr double least_share = 0.2;  // of its volume that an element must keep at each corner
constexpr double held_share = 1e-6;  // of a move along a held direction that is rounding

bool is_moved(const InitialOverlap& overlap) {
  return overlap.rule == OverlapRule::move;
}

/// One overlap as the coordinates now have it: the node onto the face, or the corners of the face onto the node.
/// Returns the depth as a share of the face's longest edge.
double push_out(const InitialOverlap& overlap, bool node_moves, std::vector<Vec3>& x) {
  std::array<Vec3, 4> corners;
  std::size_t count = 0;
  for (const LocalIndex node : overlap.face)
    if (node != no_index) corners[count++] = x[static_cast<std::size_t>(node)];
  Vec3& node = x[static_cast<std::size_t>(overlap.node)];
  const auto closest = geometry::closest_point(node, {corners.data(), count});
  if (!closest) return 0;
  const Vec3 normal = geometry::face_normal({corners.data(), count}, closest->xi, closest->eta);
  const double depth = (closest->point - node).dot(normal);
  if (!(depth > 0)) return 0;  // an earlier move has done it
  const double share = depth / geometry::longest_edge({corners.data(), count});
  if (node_moves) {
    node += depth * normal;
    return share;
  }
  double squares = 0;
  for (const double weight : closest->weights) squares += weight * weight;
  for (std::size_t i = 0; i < count; ++i)
    x[static_cast<std::size_t>(overlap.face[i])] -= closest->weights[i] / squares * depth * normal;
  return share;
}

/// Volumes of the tetrahedra at the corners of an element, six times.
std::vector<double> corner_volumes(const std::vector<Vec3>& x, const mesh::Block& block, LocalIndex element) {
  constexpr int around[8][3] = {{1, 3, 4}, {2, 0, 5}, {3, 1, 6}, {0, 2, 7}, {7, 5, 0}, {4, 6, 1}, {5, 7, 2}, {6, 4, 3}};
  const LocalIndex* nodes = block.element(element);
  const auto corner = [&](int c) -> const Vec3& { return x[static_cast<std::size_t>(nodes[c])]; };
  const auto volume = [&](int c, int p, int q, int r) {
    return (corner(p) - corner(c)).cross(corner(q) - corner(c)).dot(corner(r) - corner(c));
  };
  if (block.shape == mesh::Shape::tet4) return {volume(0, 1, 2, 3)};
  std::vector<double> volumes;
  volumes.reserve(8);
  for (int c = 0; c < 8; ++c) volumes.push_back(volume(c, around[c][0], around[c][1], around[c][2]));
  return volumes;
}

/// What of its volume the worst corner keeps.
double kept_share(const std::vector<Vec3>& before, const std::vector<Vec3>& after, const mesh::Block& block,
                  LocalIndex element) {
  const std::vector<double> old = corner_volumes(before, block, element), now = corner_volumes(after, block, element);
  const double largest = std::ranges::max(old);
  double least = 1;
  for (std::size_t c = 0; c < old.size(); ++c)
    if (old[c] > 1e-6 * largest) least = std::min(least, now[c] / old[c]);  // corners of wedges may be flat
  return least;
}

class Judge {
 public:
  Judge(const scene::Input& input, const mesh::Mesh& mesh, const std::vector<Vec3>& before)
      : input_(input), mesh_(mesh), before_(before) {}

  std::vector<std::string> faults;

  void look_at_held_nodes() {
    for (std::size_t k = 0; k < input_.fixed.size(); ++k)
      for (int c = 0; c < 3; ++c)
        if (input_.fixed[k].dofs[static_cast<std::size_t>(c)]) look_at_set("fixed", k, Vec3::Unit(c));
    for (std::size_t k = 0; k < input_.symmetry.size(); ++k)
      look_at_set("symmetry", k, input_.symmetry[k].normal.normalized());
    for (std::size_t k = 0; k < input_.prescribed.size(); ++k)
      look_at_set("prescribed", k, Vec3::Unit(input_.prescribed[k].dof));
  }

  void look_at_elements() {
    double least = least_share;
    const mesh::Block* worst = nullptr;
    LocalIndex element = 0;
    for (const mesh::Block& block : mesh_.blocks)
      for (LocalIndex e = 0; e < block.count(); ++e) {
        if (!has_moved(block, e)) continue;
        const double share = kept_share(before_, mesh_.coordinates, block, e);
        if (share >= least) continue;
        least = share;
        worst = &block;
        element = e;
      }
    if (worst == nullptr) return;
    const auto number = worst->element_id[static_cast<std::size_t>(element)];
    const std::size_t block = static_cast<std::size_t>(worst - mesh_.blocks.data());
    const std::string& part = input_.parts[scene::parts_of_blocks(input_, mesh_)[block]].name;
    faults.push_back(fmt::format(
        "{}: initial_overlap: move would {} element {} of part '{}' (a corner keeps {:.3g} of its volume, at "
        "least {:g} is wanted); move the parts apart, or keep the overlap with offset",
        input_.at("contact"), least > 0 ? "flatten" : "invert", number, part, least, least_share));
  }

 private:
  [[nodiscard]] Vec3 move_of(LocalIndex node) const {
    return mesh_.coordinates[static_cast<std::size_t>(node)] - before_[static_cast<std::size_t>(node)];
  }

  [[nodiscard]] bool has_moved(const mesh::Block& block, LocalIndex element) const {
    const LocalIndex* nodes = block.element(element);
    return std::any_of(nodes, nodes + mesh::nodes_per_element(block.shape),
                       [&](LocalIndex node) { return !move_of(node).isZero(0); });
  }

  void look_at_set(const std::string& kind, std::size_t entry, const Vec3& direction) {
    std::size_t count = 0;
    LocalIndex first = no_index;
    for (const LocalIndex node : mesh_.node_sets.at(scene::selection_name(kind, entry))) {
      const Vec3 move = move_of(node);
      if (std::abs(move.dot(direction)) <= held_share * move.norm()) continue;
      if (count++ == 0) first = node;
    }
    if (count == 0) return;
    faults.push_back(fmt::format(
        "{}: initial_overlap: move would move {} node{} that {}.{} holds (first: node {}, by {:.4g}); let the "
        "other part move with `slave`, or keep the overlap with offset",
        input_.at("contact"), count, count == 1 ? "" : "s", kind, entry, mesh_.node_id[static_cast<std::size_t>(first)],
        move_of(first).norm()));
  }

  const scene::Input& input_;
  const mesh::Mesh& mesh_;
  const std::vector<Vec3>& before_;
};

/// Pass after pass; returns the overlaps that are left.
std::vector<InitialOverlap> push_all_out(const scene::Input& input, mesh::Mesh& mesh, const InitialGaps& before) {
  const SlaveChoice choice(input, mesh);
  InitialGaps gaps = before;
  for (int pass = 0;; ++pass) {
    std::erase_if(gaps.overlaps, [](const InitialOverlap& overlap) { return !is_moved(overlap); });
    if (gaps.overlaps.empty() || pass == most_passes) return gaps.overlaps;
    const auto is_slave = [&](const InitialOverlap& o) {
      return choice.is_slave(o.block, o.body, o.other_block, o.other_body);
    };
    const bool slaves_first = std::ranges::any_of(gaps.overlaps, is_slave);
    std::erase_if(gaps.overlaps,
                  [&](const InitialOverlap& o) { return is_slave(o) != slaves_first || o.face[0] == no_index; });
    double deepest = 1;  // nodes behind one face push the same corners: they agree in some rounds
    for (int round = 0; round < most_rounds && deepest > 0.1 * touching; ++round) {
      deepest = 0;
      for (const InitialOverlap& overlap : gaps.overlaps)
        deepest = std::max(deepest, push_out(overlap, slaves_first, mesh.coordinates));
    }
    gaps = initial_gaps(input, mesh);
  }
}

}  // namespace

MoveReport move_overlaps(const scene::Input& input, mesh::CanonicalMesh& whole, const InitialGaps& gaps) {
  MoveReport report;
  mesh::Mesh& mesh = whole.mesh;
  const std::vector<Vec3> before = mesh.coordinates;
  const std::vector<InitialOverlap> left = push_all_out(input, mesh, gaps);
  Judge judge(input, mesh, before);
  judge.look_at_held_nodes();
  judge.look_at_elements();
  report.faults = std::move(judge.faults);
  if (!left.empty() && report.faults.empty())
    report.faults.push_back(
        fmt::format("{}: initial_overlap: move leaves {} nodes overlapping after {} passes (the deepest: node {}, by "
                    "{:.4g}); move the parts apart, or keep the overlap with offset",
                    input.at("contact"), left.size(), most_passes, mesh.node_id[static_cast<std::size_t>(left[0].node)],
                    left[0].depth));
  if (!report.faults.empty()) {
    mesh.coordinates = before;
    return report;
  }
  for (std::size_t i = 0; i < before.size(); ++i) {
    const double move = (mesh.coordinates[i] - before[i]).norm();
    if (move > 0) ++report.nodes;
    report.largest = std::max(report.largest, move);
  }
  return report;
}

}  // namespace brunt::app
