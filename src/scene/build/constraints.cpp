// SPDX-License-Identifier: Apache-2.0
#include "constraints.hpp"

#include <fmt/core.h>

#include <cmath>
#include <map>

#include "core/error.hpp"
#include "scene/build/rigid_parts.hpp"
#include "scene/build/select.hpp"

namespace brunt::scene {
namespace {

/// A constrained direction of a node.
struct Held {
  Vec3 direction;
  std::int32_t drive = -1;  ///< its prescribed velocity; none: at rest
  std::string source;
};
using HeldNodes = std::map<LocalIndex, std::vector<Held>>;

void hold(const Input& input, const model::Model& model, HeldNodes& held, const std::vector<LocalIndex>& nodes,
          const Held& what, std::vector<std::string>& faults) {
  bool reported = false;  // one line for each entry, even if thousands of nodes are in conflict
  for (const LocalIndex node : nodes) {
    for (const Held& other : held[node]) {
      const bool both_at_rest = what.drive < 0 && other.drive < 0;
      if (both_at_rest || std::abs(what.direction.dot(other.direction)) < 1e-12 || reported) continue;
      faults.push_back(
          fmt::format("{}: invalid constraint: node {} is also constrained in the same direction by {}; expected one "
                      "constraint for each direction of a node",
                      input.at(what.source), nth(model.mesh.node_id, node), other.source));
      reported = true;
    }
    held[node].push_back(what);
  }
}

void add_node(LocalIndex node, const std::vector<Held>& held, model::Supports& supports) {
  contact::ConstrainedNode constrained{.node = node};
  std::array<std::int32_t, 3> drive{-1, -1, -1};
  for (const Held& one : held) {
    const Vec3 rest = constrained.free * one.direction;  // component not covered by earlier directions
    if (rest.norm() > 1e-9) constrained.free -= rest.normalized() * rest.normalized().transpose();
    if (one.drive >= 0)
      for (int c = 0; c < 3; ++c)
        if (one.direction[c] != 0) nth(drive, c) = one.drive;
  }
  if (constrained.free.cwiseAbs().maxCoeff() < 1e-9) constrained.free.setZero();
  supports.nodes.push_back(constrained);
  supports.drive.push_back(drive);
}

}  // namespace

void build_constraints(const Input& input, model::Model& model) {
  HeldNodes held;
  std::vector<std::string> faults;
  const auto nodes = [&](const char* kind, std::size_t k) -> const std::vector<LocalIndex>& {
    return model.mesh.node_sets.at(selection_name(kind, k));
  };
  for (std::size_t k = 0; k < input.fixed.size(); ++k)
    for (int c = 0; c < 3; ++c)
      if (!names_rigid_part(input, input.fixed[k].where) && nth(input.fixed[k].dofs, c))
        hold(input, model, held, nodes("fixed", k), {Vec3::Unit(c), -1, fmt::format("fixed.{}", k)}, faults);
  for (std::size_t k = 0; k < input.symmetry.size(); ++k)
    hold(input, model, held, nodes("symmetry", k),
         {input.symmetry[k].normal.normalized(), -1, fmt::format("symmetry.{}", k)}, faults);
  for (std::size_t k = 0; k < input.prescribed.size(); ++k) {
    const Prescribed& entry = input.prescribed[k];
    model.supports.drives.push_back(
        {entry.curve.empty() ? model::Curve{} : input.curves.at(entry.curve), entry.scale, entry.gives});
    if (names_rigid_part(input, entry.where)) continue;
    hold(input, model, held, nodes("prescribed", k),
         {Vec3::Unit(entry.dof), static_cast<std::int32_t>(k), fmt::format("prescribed.{}", k)}, faults);
  }
  if (!faults.empty()) throw InputError(std::move(faults));
  for (const LocalIndex node : rigid_nodes(model.mesh)) held.erase(node);  // in planes of symmetry
  for (const auto& [node, directions] : held) add_node(node, directions, model.supports);
}

}  // namespace brunt::scene
