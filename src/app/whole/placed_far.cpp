// SPDX-License-Identifier: Apache-2.0
#include "placed_far.hpp"

#include <algorithm>
#include <map>
#include <utility>

#include "depth/encounter.hpp"
#include "depth/lower_bound.hpp"

namespace brunt::app {
namespace {

using Blocks = std::pair<std::size_t, std::size_t>;

/// Of each pair of blocks, the smaller number first: the penetration of the deepest node of one inside the other.
std::map<Blocks, double> deepest_nodes(const setup::InitialGaps& gaps) {
  std::map<Blocks, double> deepest;
  for (const setup::InitialOverlap& overlap : gaps.overlaps) {
    double& most = deepest[std::minmax(overlap.block, overlap.other_block)];
    most = std::max(most, overlap.penetration);
  }
  return deepest;
}

double bound_of(const depth::Body& a, const depth::Body& b) {
  const depth::Encounter encounter{a, b, {}};
  if (!geometry::overlaps(a.tree.box, b.tree.box) || !encounter.bodies_collide({})) return 0;
  return depth::lower_bound(encounter, depth::Metric::displacement).value;
}

/// The largest displacement of a point of the surfaces.
double farthest_point(const depth::Member& member, const Placement& to) {
  double most = 0;
  for (const depth::Body* body : member.surfaces)
    for (const Vec3& y : body->shape.extremes) {
      const Vec3 x = body->shape.centroid + y;
      most = std::max(most, (to(x) - x).norm());
    }
  return most;
}

/// In the axes of the other one: of whichever of the two its points move less.
double relative_motion(const depth::Assembly& assembly, const depth::AssemblyAnswer& answer, std::size_t k,
                       std::size_t other) {
  const auto placed = [&](std::size_t m) { return depth::moved({}, answer.motions[m], assembly.members[m].centroid); };
  const auto back = [](const Placement& of, const Placement& to) {  // to, in the axes that moved by `of`
    return Placement{.rotation = of.rotation.transpose() * to.rotation, .translation = of.back(to.translation)};
  };
  const Placement here = placed(k), there = placed(other);
  return std::min(farthest_point(assembly.members[k], back(there, here)),
                  farthest_point(assembly.members[other], back(here, there)));
}

/// How far apart member k's own motion alone would bring the two: what a pair needs is divided between its members in
/// the inverse ratio of their masses, and all of it falls to one if the other one does not move.
double implied_motion(const depth::Assembly& assembly, const depth::AssemblyAnswer& answer, std::size_t k,
                      std::size_t other) {
  const depth::Member &one = assembly.members[k], &two = assembly.members[other];
  return answer.farthest[k] * (two.moves() ? 1 + one.mass / two.mass : 1);
}

}  // namespace

std::optional<FarMotion> placed_far(const SceneAssembly& scene, const setup::InitialGaps& gaps,
                                    const depth::AssemblyAnswer& answer, std::span<const char> judged) {
  const std::map<Blocks, double> nodes = deepest_nodes(gaps);
  std::map<Blocks, FarMotion> pairs;  // of members
  for (const depth::MemberPair& ends : scene.assembly.pairs) {
    if (!(answer.farthest[ends.a] > 0) && !(answer.farthest[ends.b] > 0)) continue;
    const std::size_t block = scene.blocks[ends.a][ends.a_surface], other = scene.blocks[ends.b][ends.b_surface];
    const auto deepest = nodes.find(std::minmax(block, other));
    const double overlap =
        std::max(bound_of(*scene.bodies[block], *scene.bodies[other]), deepest == nodes.end() ? 0 : deepest->second);
    FarMotion& pair = pairs[{ends.a, ends.b}];
    if (overlap > pair.overlap) pair = {ends.a, ends.b, block, other, overlap, 0};
  }
  std::map<std::size_t, FarMotion> least;  // of each member, in units of the overlap
  for (auto& [members, pair] : pairs) {
    if (!(pair.overlap > 0)) continue;
    const double relative = relative_motion(scene.assembly, answer, pair.member, pair.other);
    for (const bool swapped : {false, true}) {
      FarMotion one = pair;
      if (swapped) std::swap(one.member, one.other), std::swap(one.block, one.other_block);
      one.motion = std::min(relative, implied_motion(scene.assembly, answer, one.member, one.other));
      const auto [known, added] = least.try_emplace(one.member, one);
      if (!added && one.motion * known->second.overlap < known->second.motion * one.overlap) known->second = one;
    }
  }
  std::optional<FarMotion> worst;
  for (const auto& [member, far] : least) {
    if (!judged[member] || !(far.motion > scene::most_overlaps * far.overlap)) continue;
    const auto more = [&](const FarMotion& than) {  // of two that move apart, the one that moves more itself
      const double here = far.motion * than.overlap, there = than.motion * far.overlap;
      return here > there || (here == there && answer.farthest[member] > answer.farthest[than.member]);
    };
    if (!worst || more(*worst)) worst = far;
  }
  return worst;
}

}  // namespace brunt::app
