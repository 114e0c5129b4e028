// SPDX-License-Identifier: Apache-2.0
#include "constraints.hpp"

#include <fmt/core.h>

#include <Eigen/Geometry>
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

enum class Motion { shift, turn };

/// What a plane of symmetry holds: motion along its normal, rotation about the axes in it.
void hold_symmetric(const Input& input, const model::Model& model, HeldNodes& held, std::size_t entry, Motion motion,
                    std::vector<std::string>& faults) {
  const Vec3 normal = input.symmetry[entry].normal.normalized();
  const std::string source = fmt::format("symmetry.{}", entry);
  const std::vector<LocalIndex>& nodes = model.mesh.node_sets.at(selection_name("symmetry", entry));
  if (motion == Motion::shift) return hold(input, model, held, nodes, {normal, -1, source}, faults);
  const Vec3 across = normal.unitOrthogonal();
  hold(input, model, held, nodes, {across, -1, source}, faults);
  hold(input, model, held, nodes, {normal.cross(across), -1, source}, faults);
}

/// Supports of the displacements of nodes, or of their rotations.
void hold_nodes(const Input& input, const model::Model& model, Motion motion, model::Supports& supports,
                std::vector<std::string>& faults) {
  HeldNodes held;
  const auto nodes = [&](const char* kind, std::size_t k) -> const std::vector<LocalIndex>& {
    return model.mesh.node_sets.at(selection_name(kind, k));
  };
  const auto of_entry = [&](const Fixed& entry) { return motion == Motion::shift ? entry.dofs : entry.turns; };
  for (std::size_t k = 0; k < input.fixed.size(); ++k)
    for (int c = 0; c < 3; ++c)
      if (!names_rigid_part(input, input.fixed[k].where) && nth(of_entry(input.fixed[k]), c))
        hold(input, model, held, nodes("fixed", k), {Vec3::Unit(c), -1, fmt::format("fixed.{}", k)}, faults);
  for (std::size_t k = 0; k < input.symmetry.size(); ++k) hold_symmetric(input, model, held, k, motion, faults);
  for (std::size_t k = 0; k < input.prescribed.size(); ++k) {
    const Prescribed& entry = input.prescribed[k];
    const int c = entry.dof - (motion == Motion::shift ? 0 : 3);
    if (names_rigid_part(input, entry.where) || c < 0 || c > 2) continue;
    hold(input, model, held, nodes("prescribed", k),
         {Vec3::Unit(c), static_cast<std::int32_t>(k), fmt::format("prescribed.{}", k)}, faults);
  }
  for (const LocalIndex node : rigid_nodes(model.mesh)) held.erase(node);  // in planes of symmetry
  for (const auto& [node, directions] : held) add_node(node, directions, supports);
}

}  // namespace

void build_constraints(const Input& input, model::Model& model) {
  std::vector<std::string> faults;
  for (std::size_t k = 0; k < input.prescribed.size(); ++k) {
    const Prescribed& entry = input.prescribed[k];
    model.supports.drives.push_back(
        {entry.curve.empty() ? model::Curve{} : input.curves.at(entry.curve), entry.scale, entry.gives});
  }
  hold_nodes(input, model, Motion::shift, model.supports, faults);
  if (model.turns()) hold_nodes(input, model, Motion::turn, model.rotation_supports, faults);
  if (!faults.empty()) throw InputError(std::move(faults));
}

}  // namespace brunt::scene
