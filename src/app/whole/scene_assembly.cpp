// SPDX-License-Identifier: Apache-2.0
#include "scene_assembly.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <stdexcept>

#include "core/error.hpp"
#include "core/union_find.hpp"
#include "geometry/triangles/closed_surface.hpp"
#include "outer_surface.hpp"
#include "scene/build/build.hpp"
#include "scene/build/rigid_parts.hpp"
#include "scene/build/select.hpp"
#include "start_rules.hpp"

namespace brunt::app {
namespace {

using setup::OverlapRule;

/// groups: of blocks.
void join_by_nodes(const mesh::Mesh& mesh, UnionFind& groups) {
  constexpr std::size_t none = static_cast<std::size_t>(-1);
  std::vector<std::size_t> holder(mesh.coordinates.size(), none);
  for (std::size_t b = 0; b < mesh.blocks.size(); ++b) {
    const mesh::Block& block = mesh.blocks[b];
    for (LocalIndex e = 0; e < block.count(); ++e)
      for (int k = 0; k < mesh::nodes_per_element(block.shape); ++k) {
        std::size_t& first = nth(holder, block.element(e)[k]);
        if (first == none) first = b;
        if (first != b) groups.join(first, b);
      }
  }
}

/// Takes the direction out of the basis: what is left are translations across all directions taken so far.
void hold(depth::Member& member, const Vec3& direction) {
  constexpr double rounding = 1e-6;  // wider than that of unit vectors
  member.turns = false;
  const Vec3 within = member.basis * (member.basis.transpose() * direction);  // what earlier directions leave of it
  if (!(within.norm() > rounding)) return;
  const Vec3 taken = within.normalized();
  Mat3 left = Mat3::Zero();
  int count = 0;
  for (int c = 0; c < 3; ++c) {
    Vec3 v = member.basis.col(c) - taken.dot(member.basis.col(c)) * taken;
    for (int k = 0; k < count; ++k) v -= left.col(k).dot(v) * left.col(k);
    if (v.norm() > rounding) left.col(count++) = v.normalized();
  }
  member.basis = left;
}

/// What the scene holds, of each node.
void hold_members(const scene::Input& input, const mesh::Mesh& mesh, const std::vector<std::size_t>& member_of,
                  std::vector<depth::Member>& all) {
  constexpr std::size_t none = static_cast<std::size_t>(-1);
  std::vector<std::vector<std::size_t>> members(mesh.coordinates.size());
  for (std::size_t b = 0; b < mesh.blocks.size(); ++b) {
    const mesh::Block& block = mesh.blocks[b];
    for (LocalIndex e = 0; e < block.count(); ++e)
      for (int k = 0; k < mesh::nodes_per_element(block.shape); ++k) {
        auto& of_node = nth(members, block.element(e)[k]);
        if (of_node.empty() || of_node.back() != member_of[b]) of_node.push_back(member_of[b]);
      }
  }
  const auto hold_all = [&](const std::vector<LocalIndex>& nodes, const std::optional<Vec3>& direction) {
    std::size_t last = none;
    for (const LocalIndex node : nodes)
      for (const std::size_t k : nth(members, node)) {
        if (k == last) continue;
        last = k;
        all[k].turns = false;
        if (direction) hold(all[k], *direction);
      }
  };
  const auto nodes_of = [&](const char* kind, std::size_t entry) -> const std::vector<LocalIndex>& {
    return mesh.node_sets.at(scene::selection_name(kind, entry));
  };
  for (std::size_t k = 0; k < input.fixed.size(); ++k) {
    const scene::Fixed& fixed = input.fixed[k];
    if (std::ranges::find(fixed.turns, true) != fixed.turns.end()) hold_all(nodes_of("fixed", k), std::nullopt);
    for (int c = 0; c < 3; ++c)
      if (nth(fixed.dofs, c)) hold_all(nodes_of("fixed", k), Vec3(Vec3::Unit(c)));
  }
  for (std::size_t k = 0; k < input.symmetry.size(); ++k)
    hold_all(nodes_of("symmetry", k), Vec3(input.symmetry[k].normal.normalized()));
  for (std::size_t k = 0; k < input.prescribed.size(); ++k) {
    const int dof = input.prescribed[k].dof;
    hold_all(nodes_of("prescribed", k), dof < 3 ? std::optional(Vec3(Vec3::Unit(dof))) : std::nullopt);
  }
}

/// What the scene gives of a rigid body: its mass counts; a centre or an inertia is given where the body is drawn.
void heed_rigid(const scene::Part& part, depth::Member& member) {
  if (!part.rigid) return;
  if (part.rigid->mass) member.mass = *part.rigid->mass;
  if (part.rigid->centre) member.basis.setZero();
  if (part.rigid->centre || part.rigid->inertia) member.turns = false;
}

/// Pairs of blocks of different members that must not overlap after the placement.
bool must_part(const std::optional<OverlapRule>& rule) {
  return rule == OverlapRule::place || rule == OverlapRule::error;
}

}  // namespace

std::vector<std::size_t> members_of_blocks(const scene::Input& input, const mesh::Mesh& mesh,
                                           const setup::StartRules& rules) {
  const std::size_t n = mesh.blocks.size();
  const std::vector<std::size_t> part_of = scene::parts_of_blocks(input, mesh);
  UnionFind groups(n);
  join_by_nodes(mesh, groups);
  const auto name = [&](std::size_t b) -> const std::string& { return input.parts[part_of[b]].name; };
  for (std::size_t a = 0; a < n; ++a)
    for (std::size_t b = a + 1; b < n; ++b) {
      const bool tied =
          rules.contact.pairs.block_count() == n &&
          rules.contact.pairs.at(static_cast<std::int32_t>(a), static_cast<std::int32_t>(b)).tied != contact::Tied::no;
      if (tied || scene::are_one_body(input, name(a), name(b))) groups.join(a, b);
    }
  std::vector<std::size_t> member(n), number(n);
  std::size_t count = 0;
  for (std::size_t b = 0; b < n; ++b) {
    if (groups.first(b) == b) number[b] = count++;
    member[b] = number[groups.first(b)];
  }
  return member;
}

std::vector<depth::Member> freedoms_of_members(const scene::Input& input, const mesh::Mesh& mesh,
                                               const std::vector<std::size_t>& member_of) {
  std::vector<depth::Member> members(member_of.empty() ? 0 : *std::ranges::max_element(member_of) + 1);
  hold_members(input, mesh, member_of, members);
  const std::vector<std::size_t> part_of = scene::parts_of_blocks(input, mesh);
  for (std::size_t b = 0; b < member_of.size(); ++b) heed_rigid(input.parts[part_of[b]], members[member_of[b]]);
  return members;
}

depth::Body body_of_block(const mesh::Mesh& mesh, std::size_t block, const std::string& who) {
  const TriangleSurface surface = outer_surface(mesh, block);
  const geometry::SurfaceFaults faults = geometry::check_closed(surface);
  if (surface.triangles.empty()) throw InputError(who + ": missing volume; expected solid elements");
  if (!faults.sound()) throw InputError(geometry::describe(faults, surface, who));
  try {
    return depth::make_body(surface);
  } catch (const std::invalid_argument& error) {
    throw InputError(
        fmt::format("{}: invalid body: {}; expected a thickness above 1e-6 of its length", who, error.what()));
  }
}

SceneAssembly scene_assembly(const scene::Input& input, const mesh::Mesh& mesh, const setup::StartRules& rules) {
  const std::size_t n = mesh.blocks.size();
  const std::vector<std::size_t> part_of = scene::parts_of_blocks(input, mesh);
  const std::vector<std::size_t> member_of = members_of_blocks(input, mesh, rules);
  const std::size_t count = n == 0 ? 0 : *std::ranges::max_element(member_of) + 1;
  SceneAssembly result;
  result.bodies.resize(n);
  result.blocks.resize(count);
  std::vector<std::size_t> place(n);
  for (std::size_t b = 0; b < n; ++b) {
    place[b] = result.blocks[member_of[b]].size();
    result.blocks[member_of[b]].push_back(b);
  }
  std::vector<char> takes_part(count, 0), wanted(count, 0);
  for (std::size_t a = 0; a < n; ++a)
    for (std::size_t b = a + 1; b < n; ++b)
      if (member_of[a] != member_of[b] && rules.overlap_of(a, b) == OverlapRule::place)
        takes_part[member_of[a]] = takes_part[member_of[b]] = 1;
  for (std::size_t a = 0; a < n; ++a)
    for (std::size_t b = a + 1; b < n; ++b) {
      const std::size_t one = member_of[a], other = member_of[b];
      if (one == other || !must_part(rules.overlap_of(a, b)) || (!takes_part[one] && !takes_part[other])) continue;
      result.assembly.pairs.push_back({one, place[a], other, place[b]});
      wanted[one] = wanted[other] = 1;
    }
  for (std::size_t k = 0; k < count; ++k) {
    depth::Member& member = result.assembly.members.emplace_back();
    std::vector<const depth::Body*> surfaces;
    std::vector<double> densities;
    for (const std::size_t b : result.blocks[k]) {
      if (!wanted[k]) continue;
      const std::string& part = input.parts[part_of[b]].name;
      try {
        result.bodies[b] = std::make_unique<depth::Body>(body_of_block(mesh, b, "part '" + part + "'"));
      } catch (const InputError& error) {
        for (const std::string& fault : error.faults())
          result.faults.push_back(input.at("contact") + ": initial_overlap: place: " + fault);
        continue;
      }
      surfaces.push_back(result.bodies[b].get());
      densities.push_back(rules.density[b]);
    }
    if (wanted[k] && surfaces.size() == result.blocks[k].size()) member = depth::make_member(surfaces, densities);
    if (wanted[k] && takes_part[k]) continue;
    member.basis.setZero();
    member.turns = false;
  }
  hold_members(input, mesh, member_of, result.assembly.members);
  for (std::size_t b = 0; b < n; ++b) heed_rigid(input.parts[part_of[b]], result.assembly.members[member_of[b]]);
  return result;
}

}  // namespace brunt::app
