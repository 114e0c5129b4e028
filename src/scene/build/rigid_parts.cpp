// SPDX-License-Identifier: Apache-2.0
#include "scene/build/rigid_parts.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "core/excerpt.hpp"
#include "mesh/topology.hpp"
#include "scene/build/select.hpp"
#include "scene/reported.hpp"

namespace brunt::scene {
namespace {

/// The body of each node, by the block of the part that leads it; the first node of two bodies is reported.
class BodyOfNode {
 public:
  BodyOfNode(const Input& input, std::span<const std::string> part_of_block, const mesh::CanonicalMesh& whole)
      : part_(part_of_block), body_(whole.mesh.coordinates.size(), none) {
    size_.assign(part_of_block.size(), 0);
    for (std::size_t b = 0; b < part_of_block.size(); ++b) {
      if (!names_rigid_part(input, part_of_block[b])) continue;
      const std::size_t lead = find(lead_of(input, part_of_block[b]));
      for (const LocalIndex node : whole.mesh.blocks[b].nodes) {
        std::size_t& body = nth(body_, node);
        if (body == lead) continue;
        if (body != none) {
          shared_ = {body, lead, static_cast<std::size_t>(node)};
          continue;
        }
        body = lead;
        ++size_[lead];
      }
    }
  }
  static constexpr std::size_t none = static_cast<std::size_t>(-1);
  struct Shared {
    std::size_t first, second, node;
  };

  [[nodiscard]] std::size_t of(LocalIndex node) const { return nth(body_, node); }
  [[nodiscard]] const std::string& part(std::size_t body) const { return part_[body]; }
  /// The body led by this part.
  [[nodiscard]] std::size_t find(const std::string& part) const {
    const auto found = std::ranges::find(part_, part);
    return found == part_.end() ? none : static_cast<std::size_t>(found - part_.begin());
  }
  [[nodiscard]] std::size_t size(std::size_t body) const { return size_[body]; }
  [[nodiscard]] const std::optional<Shared>& shared() const { return shared_; }
  [[nodiscard]] std::vector<LocalIndex> nodes_of(std::size_t body) const {
    std::vector<LocalIndex> nodes;
    for (std::size_t i = 0; i < body_.size(); ++i)
      if (body_[i] == body) nodes.push_back(static_cast<LocalIndex>(i));
    return nodes;
  }
  /// The number of nodes of each body among these.
  [[nodiscard]] std::vector<std::size_t> count(const std::vector<LocalIndex>& nodes) const {
    std::vector<std::size_t> counts(size_.size(), 0);
    for (const LocalIndex node : nodes)
      if (of(node) != none) ++counts[of(node)];
    return counts;
  }

 private:
  std::span<const std::string> part_;
  std::vector<std::size_t> body_, size_;
  std::optional<Shared> shared_;
};

/// Supports of single nodes of a body are faults, since it moves as a whole.
void refuse_node_supports(const Input& input, const BodyOfNode& bodies, const mesh::CanonicalMesh& whole,
                          std::vector<std::string>& faults) {
  const auto look = [&](const char* list, std::size_t k, const std::string& where) {
    if (names_rigid_part(input, where)) return;
    const auto set = whole.mesh.node_sets.find(selection_name(list, k));
    if (set == whole.mesh.node_sets.end()) return;
    for (const LocalIndex node : set->second) {
      const std::size_t body = bodies.of(node);
      if (body == BodyOfNode::none) continue;
      faults.push_back(reported(input, fmt::format("{}.{}", list, k),
                                "invalid selection: node {} of '{}' belongs to the rigid part '{}', which moves as a "
                                "whole; expected part: {}, or nodes of deformable parts only",
                                nth(whole.mesh.node_id, node), excerpt(where), excerpt(bodies.part(body)),
                                excerpt(bodies.part(body))));
      return;
    }
  };
  for (std::size_t k = 0; k < input.fixed.size(); ++k) look("fixed", k, input.fixed[k].where);
  for (std::size_t k = 0; k < input.prescribed.size(); ++k) look("prescribed", k, input.prescribed[k].where);
}

/// The supports of a body act on the whole of it: single nodes have no reaction, and 0 would be wrong.
void refuse_node_reactions(const Input& input, const BodyOfNode& bodies, const mesh::CanonicalMesh& whole,
                           std::vector<std::string>& faults) {
  for (std::size_t k = 0; k < input.probes.size(); ++k) {
    const Probe& probe = input.probes[k];
    const auto set = whole.mesh.node_sets.find(selection_name("probe", k));
    if (probe.kind != Probe::Kind::set || probe.field != "reaction" || set == whole.mesh.node_sets.end()) continue;
    const auto node = std::ranges::find_if(set->second, [&](LocalIndex n) { return bodies.of(n) != BodyOfNode::none; });
    if (node == set->second.end()) continue;
    faults.push_back(
        reported(input, fmt::format("probes.{}", k),
                 "invalid field 'reaction': node {} of '{}' belongs to the rigid part '{}', whose supports "
                 "act on the whole body; expected part: {}, or nodes of deformable parts only",
                 nth(whole.mesh.node_id, *node), excerpt(probe.where), excerpt(bodies.part(bodies.of(*node))),
                 excerpt(bodies.part(bodies.of(*node)))));
  }
}

/// An entry of `initial` defines the motion of a body if it names the body or selects all of its nodes. Another part
/// may share some of them.
void select_motions(const Input& input, const BodyOfNode& bodies, mesh::CanonicalMesh& whole,
                    std::vector<std::string>& faults) {
  const auto is_part = [&](const std::string& where) {
    return std::ranges::find(input.parts, where, &Part::name) != input.parts.end();
  };
  for (std::size_t k = 0; k < input.initial.size(); ++k) {
    const auto set = whole.mesh.node_sets.find(selection_name("initial", k));
    if (set == whole.mesh.node_sets.end()) continue;
    const std::vector<std::size_t> counts = bodies.count(set->second);
    for (std::size_t body = 0; body < counts.size(); ++body)
      if (counts[body] > 0 && counts[body] < bodies.size(body) && !is_part(input.initial[k].where))
        faults.push_back(reported(input, fmt::format("initial.{}", k),
                                  "invalid selection: '{}' has {} of the {} nodes of the rigid part '{}', which moves "
                                  "as a whole; expected all of these nodes, or none",
                                  excerpt(input.initial[k].where), counts[body], bodies.size(body),
                                  excerpt(bodies.part(body))));
    std::vector<LocalIndex> moved;
    if (names_rigid_part(input, input.initial[k].where))
      moved = bodies.nodes_of(bodies.find(input.initial[k].where));
    else
      for (const LocalIndex node : set->second) {
        const std::size_t body = bodies.of(node);
        if (body != BodyOfNode::none && counts[body] == bodies.size(body)) moved.push_back(node);
      }
    whole.mesh.node_sets[body_motion_set(k)] = std::move(moved);
  }
}

/// Nodes of bodies on which deformable elements or loads act.
std::vector<LocalIndex> forced_nodes(const Input& input, const BodyOfNode& bodies,
                                     std::span<const std::string> part_of_block, const mesh::CanonicalMesh& whole) {
  std::vector<LocalIndex> nodes;
  const auto add = [&](LocalIndex node) {
    if (node != no_index && bodies.of(node) != BodyOfNode::none) nodes.push_back(node);
  };
  const auto add_sides = [&](const std::string& set) {
    if (const auto sides = whole.mesh.side_sets.find(set); sides != whole.mesh.side_sets.end())
      for (const mesh::Side& side : sides->second) {
        const mesh::Block& block = nth(whole.mesh.blocks, side.block);
        for (const LocalIndex node : mesh::face_nodes(block.shape, block.element(side.element), side.face)) add(node);
      }
  };
  for (std::size_t b = 0; b < part_of_block.size(); ++b)
    if (!names_rigid_part(input, part_of_block[b]))
      for (const LocalIndex node : whole.mesh.blocks[b].nodes) add(node);
  for (std::size_t k = 0; k < input.pressure.size(); ++k) add_sides(selection_name("pressure", k));
  for (std::size_t k = 0; k < input.traction.size(); ++k) add_sides(selection_name("traction", k));
  for (std::size_t k = 0; k < input.forces.size(); ++k) {
    add_sides(selection_name("forces", k));
    if (const auto set = whole.mesh.node_sets.find(selection_name("forces", k)); set != whole.mesh.node_sets.end())
      for (const LocalIndex node : set->second) add(node);
  }
  std::ranges::sort(nodes);
  nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
  return nodes;
}

/// The given mass properties, relative to the origin of the mesh.
model::GivenMass given_mass(const Part& part, const Vec3& origin) {
  if (!part.rigid) return {};
  model::GivenMass given{part.rigid->mass, part.rigid->centre, part.rigid->inertia, part.rigid->reference};
  if (given.centre) *given.centre -= origin;
  if (given.reference) *given.reference -= origin;
  return given;
}

/// The last entry of `initial` that applies to the body's nodes here.
model::StartMotion start_motion(const Input& input, const mesh::LocalMesh& mesh, const model::RigidBody& body) {
  model::StartMotion start;
  if (body.nodes.empty()) return start;
  for (std::size_t k = 0; k < input.initial.size(); ++k) {
    const std::vector<LocalIndex>& moved = mesh.node_sets.at(body_motion_set(k));
    if (!std::ranges::binary_search(moved, body.nodes.front())) continue;
    const InitialMotion& entry = input.initial[k];
    start.spin = entry.spin_rate * entry.spin_axis.normalized();
    start.velocity = entry.velocity - start.spin.cross(entry.spin_point - mesh.origin);
  }
  return start;
}

/// Of the centre of mass, and of rotations. Shifts of a reference point are supports of their own (build/joints).
void build_supports(const Input& input, const mesh::LocalMesh& mesh, model::RigidBody& body) {
  const bool of_centre = !body.given.reference;
  for (const Fixed& entry : input.fixed) {
    if (entry.where != body.part) continue;
    for (int c = 0; c < 3; ++c) {
      if (of_centre && nth(entry.dofs, c)) body.held_shift.push_back(Vec3::Unit(c));
      if (nth(entry.turns, c)) body.held_turn.push_back(Vec3::Unit(c));
    }
  }
  for (std::size_t k = 0; k < input.prescribed.size(); ++k) {
    const Prescribed& entry = input.prescribed[k];
    if (entry.where != body.part || (entry.dof < 3 && !of_centre)) continue;
    (entry.dof < 3 ? body.held_shift : body.held_turn).push_back(Vec3::Unit(entry.dof % 3));
    nth(body.drive, entry.dof) = static_cast<std::int32_t>(k);
  }
  for (std::size_t k = 0; k < input.symmetry.size(); ++k) {
    const std::vector<LocalIndex>& plane = mesh.node_sets.at(selection_name("symmetry", k));
    const bool touches =
        std::ranges::any_of(body.nodes, [&](LocalIndex node) { return std::ranges::binary_search(plane, node); });
    body.mirrors.push_back({input.symmetry[k].normal.normalized(), touches});
  }
}

}  // namespace

bool is_rigid(const Input& input, const Part& part) {
  const auto law = input.materials.find(part.material);
  return law != input.materials.end() && material::is_rigid(law->second);
}

bool names_rigid_part(const Input& input, const std::string& where) {
  const auto part = std::ranges::find(input.parts, where, &Part::name);
  return part != input.parts.end() && is_rigid(input, *part);
}

std::string body_set(std::size_t block) {
  return selection_name("body", block);
}

std::string body_motion_set(std::size_t initial_entry) {
  return selection_name("body_motion", initial_entry);
}

std::vector<std::string> select_bodies(const Input& input, std::span<const std::string> part_of_block,
                                       mesh::CanonicalMesh& whole) {
  std::vector<std::string> faults;
  if (std::ranges::none_of(part_of_block, [&](const std::string& part) { return names_rigid_part(input, part); }))
    return faults;
  const BodyOfNode bodies(input, part_of_block, whole);
  if (const auto& shared = bodies.shared())
    faults.push_back(reported(input, "parts." + bodies.part(shared->second),
                              "invalid mesh: node {} is shared with '{}', which is also rigid; expected rigid: "
                              "{{joins: {}}} for one body, or bodies without common nodes",
                              whole.mesh.node_id[shared->node], excerpt(bodies.part(shared->first)),
                              excerpt(bodies.part(shared->first))));
  for (std::size_t b = 0; b < part_of_block.size(); ++b)
    if (bodies.size(b) > 0) whole.mesh.node_sets[body_set(b)] = bodies.nodes_of(b);
  whole.mesh.node_sets[forced_set] = forced_nodes(input, bodies, part_of_block, whole);
  refuse_node_supports(input, bodies, whole, faults);
  refuse_node_reactions(input, bodies, whole, faults);
  select_motions(input, bodies, whole, faults);
  return faults;
}

std::vector<LocalIndex> rigid_nodes(const mesh::LocalMesh& mesh) {
  std::vector<LocalIndex> nodes;
  for (std::size_t b = 0; b < mesh.blocks.size(); ++b)
    if (const auto set = mesh.node_sets.find(body_set(b)); set != mesh.node_sets.end())
      nodes.insert(nodes.end(), set->second.begin(), set->second.end());
  return nodes;
}

void build_bodies(const Input& input, model::Model& model) {
  for (std::size_t b = 0; b < model.blocks.size(); ++b) {
    const model::ElementBlock& block = model.blocks[b];
    if (!material::is_rigid(block.law) || lead_of(input, block.part) != block.part) continue;
    model::RigidBody body;
    body.part = block.part;
    body.blocks = {static_cast<std::int32_t>(b)};
    for (std::size_t other = 0; other < model.blocks.size(); ++other)
      if (other != b && are_one_body(input, block.part, model.blocks[other].part))
        body.blocks.push_back(static_cast<std::int32_t>(other));
    body.given = given_mass(*std::ranges::find(input.parts, block.part, &Part::name), model.mesh.origin);
    body.nodes = model.mesh.node_sets.at(body_set(b));
    const std::vector<LocalIndex>& forced = model.mesh.node_sets.at(forced_set);
    for (std::size_t k = 0; k < body.nodes.size(); ++k)
      if (std::ranges::binary_search(forced, body.nodes[k])) body.forced.push_back(static_cast<LocalIndex>(k));
    body.start = start_motion(input, model.mesh, body);
    build_supports(input, model.mesh, body);
    model.bodies.push_back(std::move(body));
  }
}

}  // namespace brunt::scene
