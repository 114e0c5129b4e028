// SPDX-License-Identifier: Apache-2.0
// Bodies that supports drive through each other or through walls, where contact cannot act and only reports it.
#include <algorithm>

#include "implicit/data/nodal.hpp"
#include "implicit/driven_apart.hpp"

namespace brunt::implicit {
namespace {

constexpr double held = 1e-6;       // sine below which a direction is constrained: as `redundant` of wall_node.cpp
constexpr double of_carried = 1e4;  // likewise of tied nodes: a hundredth of an edge, the gap of non-matching meshes
                                    // along a curved seam
constexpr double of_touching = 10;  // a node is behind a wall from this multiple of the distance at which it touches

/// Largest penetration of rows of this rank whose nodes are all constrained [length].
double depth_of(const ContactNodes& nodes, const Interface& face) {
  double deepest = 0;
  for (std::size_t row = 0; row < face.count(); ++row) {
    const double depth = -face.mean_gap(row);
    if (!(depth > agreed * face.topology.edge && depth > deepest)) continue;
    const Vec3& normal = face.iterate.rows.normals[row];
    const auto moves = [&](LocalIndex node) { return (nth(nodes.free, node) * normal).norm() > held; };
    if (std::ranges::none_of(face.iterate.rows.weights.nodes.row(static_cast<LocalIndex>(row)), moves)) deepest = depth;
  }
  return deepest;
}

struct AtWall {
  double depth = 0;               ///< [length]
  std::int32_t block = no_index;  ///< of the deepest node
};

std::int32_t block_of(const model::Model& model, LocalIndex node) {
  for (std::size_t b = 0; b < model.blocks.size(); ++b)
    if (std::ranges::find(model.blocks[b].node, node) != model.blocks[b].node.end())
      return static_cast<std::int32_t>(b);
  return no_index;
}

/// Whether supports or ties leave the node no motion along the direction; through its body, if that is rigid.
bool is_held(const model::Model& model, const Solver& solver, const WallNode& node, const Vec3& direction) {
  const auto i = static_cast<std::size_t>(solver.unknowns.node[node.own]);
  if (node.springs) {
    const RigidBodies::Place& place = solver.bodies.place[node.own];
    const auto b = static_cast<std::size_t>(place.body);
    const rigid::Support& support = model.bodies[b].support;
    const Vec3 arm = solver.bodies.trial[b].turn_now * place.arm;
    return (support.free_shift * direction).norm() <= held &&
           (support.free_turn * arm.cross(direction)).norm() <= held * solver.bodies.radius[b];
  }
  Mat3 free = Mat3::Identity() - node.tied;
  if (solver.held[i] != no_index) free = nth(model.supports.nodes, solver.held[i]).free * free;
  return (free * direction).norm() <= held;
}

/// For each wall: the deepest node of this rank with a support along its normal.
std::vector<AtWall> held_behind_walls(const Scene& scene, const Solver& solver) {
  std::vector<AtWall> found(scene.model.touching.walls.size());
  const WallContact& walls = solver.walls;
  for (const WallNode& node : walls.nodes) {
    const auto i = static_cast<std::size_t>(solver.unknowns.node[node.own]);
    const bool carried = !node.tied.isZero(0);
    if (solver.held[i] == no_index && !carried && !node.springs) continue;
    const Vec3 x = of(scene.model.reference[i]) + of(scene.state.displacement[i]);
    for (std::int32_t k = 0; k < node.looked_at; ++k) {
      const auto w = static_cast<std::size_t>(nth(walls.wall, node.kept[k]));
      const Vec3& normal = scene.model.touching.walls[w].normal;
      const double depth = walls.place[w] - normal.dot(x);
      const double least = carried ? of_carried : of_touching;
      if (!(depth > least * walls.touching && depth > found[w].depth) || !is_held(scene.model, solver, node, normal))
        continue;
      found[w] = {depth, block_of(scene.model, solver.unknowns.node[node.own])};
    }
  }
  return found;
}

/// Updates the depth of a pair in the memory; returns whether it is new.
bool deepen(double depth, double time, double* since_and_depth) {
  if (!(depth > since_and_depth[1])) return false;
  const bool fresh = since_and_depth[1] == 0;
  if (fresh) since_and_depth[0] = time;
  since_and_depth[1] = depth;
  return fresh;
}

}  // namespace

bool yields_to_walls(const model::Model& model, const Solver& solver, const WallNode& node) {
  for (std::int32_t k = 0; k < node.looked_at; ++k) {
    const auto w = static_cast<std::size_t>(nth(solver.walls.wall, node.kept[k]));
    if (!is_held(model, solver, node, model.touching.walls[w].normal)) return true;
  }
  return false;
}

std::vector<DrivenThrough> watch_driven(const Scene& scene, Solver& solver) {
  std::vector<DrivenThrough> fresh;
  if (!scene.links.ranks.any(!scene.model.supports.nodes.empty()) && scene.model.bodies.empty()) return fresh;
  double* next = solver.driven.data();
  const auto take = [&](std::int32_t block, std::int32_t other, double depth) {
    if (deepen(depth, scene.state.time, next)) fresh.push_back({block, other, next[0], depth});
    next += 2;
  };
  std::vector<double> depths(scene.model.touching.mortar.size(), 0.0);
  std::vector<const contact::MortarPair*> pairs(depths.size());
  for (const Interface& face : solver.contact.interfaces) {
    if (face.first_of_pair) pairs[face.of_pair] = &face.pair;
    if (!face.pair.tied) depths[face.of_pair] = std::max(depths[face.of_pair], depth_of(solver.contact.nodes, face));
  }
  if (!depths.empty()) scene.links.ranks.max(depths);
  for (std::size_t k = 0; k < depths.size(); ++k) take(pairs[k]->slave, pairs[k]->master, depths[k]);
  const std::vector<AtWall> here = held_behind_walls(scene, solver);
  for (std::size_t w = 0; w < here.size(); ++w) {
    const double depth = scene.links.ranks.max(here[w].depth);
    const GlobalIndex block = scene.links.ranks.max(GlobalIndex{here[w].depth == depth ? here[w].block : no_index});
    take(static_cast<std::int32_t>(block), static_cast<std::int32_t>(-1 - static_cast<std::ptrdiff_t>(w)), depth);
  }
  return fresh;
}

double driven_penetration(const Solver& solver) {
  double deepest = 0;
  for (std::size_t k = 1; k < solver.driven.size(); k += 2) deepest = std::max(deepest, solver.driven[k]);
  return deepest;
}

}  // namespace brunt::implicit
