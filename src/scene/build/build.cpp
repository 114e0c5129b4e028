// SPDX-License-Identifier: Apache-2.0
#include "scene/build/build.hpp"

#include <fmt/core.h>

#include <Eigen/Geometry>
#include <algorithm>

#include "constraints.hpp"
#include "scene/build/joints.hpp"
#include "scene/build/rigid_parts.hpp"
#include "scene/build/select.hpp"
#include "select_removed.hpp"

namespace brunt::scene {
namespace {

const std::vector<LocalIndex>& selected(const mesh::LocalMesh& mesh, const std::string& kind, std::size_t entry) {
  return mesh.node_sets.at(selection_name(kind, entry));
}

model::Curve curve_of(const Input& input, const std::string& name) {
  return name.empty() ? model::Curve{} : input.curves.at(name);
}

/// Connectivity in batches, one element for each lane: [batch][corner][lane]. The last batch is filled up with copies
/// of its last element.
AlignedVector<LocalIndex> batched(const std::vector<LocalIndex>& nodes, int corners, LocalIndex count) {
  const LocalIndex batches = (count + pack_width - 1) / pack_width;
  AlignedVector<LocalIndex> result(static_cast<std::size_t>(batches) * static_cast<std::size_t>(corners * pack_width));
  for (LocalIndex batch = 0; batch < batches; ++batch)
    for (int c = 0; c < corners; ++c)
      for (int lane = 0; lane < pack_width; ++lane) {
        const std::ptrdiff_t row = std::ptrdiff_t{batch} * corners + c;
        const std::ptrdiff_t element = std::min(batch * pack_width + lane, count - 1);
        nth(result, row * pack_width + lane) = nth(nodes, element * corners + c);
      }
  return result;
}

model::ElementBlock build_block(const Part& part, const Input& input, const mesh::LocalBlock& source) {
  model::ElementBlock block;
  block.part = part.name;
  block.material = part.material;
  block.kind = kind_of(part, source.shape);
  block.section = part.section;
  block.law = input.materials.at(part.material);
  if (material::is_rigid(block.law) && source.shape == mesh::Shape::tet4) block.kind = ElementKind::tet4;
  block.hourglass = part.hourglass;
  if (block.kind != ElementKind::hex8 && block.kind != ElementKind::shell4) block.hourglass = {HourglassKind::none, 0};
  block.bulk = part.bulk;
  block.erosion = part.erosion;
  block.shape = source.shape;
  block.count = static_cast<LocalIndex>(source.gid.size());
  block.gid = source.gid;
  block.input = source.input;
  block.node = batched(source.nodes, block.corners(), block.count);
  return block;
}

void build_dead_loads(const Input& input, model::Model& model) {
  const auto add = [&](const DeadLoad& entry, const std::string& set) {
    model::DeadLoad load;
    static_cast<model::DeadForce&>(load) = entry;
    load.curve = curve_of(input, entry.curve);
    if (entry.kind == DeadLoad::Kind::each_node)
      load.nodes = model.mesh.node_sets.at(set);
    else
      load.faces = model.mesh.side_sets.at(set);
    model.loads.dead.push_back(std::move(load));
  };
  for (std::size_t k = 0; k < input.forces.size(); ++k) add(input.forces[k], selection_name("forces", k));
  for (std::size_t k = 0; k < input.traction.size(); ++k) add(input.traction[k], selection_name("traction", k));
}

/// Nodes whose corner forces probes need separately: those of sections, and those between parts whose energies are
/// recorded.
void watch_nodes(const Input& input, model::Model& model) {
  std::vector<LocalIndex>& watched = model.watched;
  for (std::size_t k = 0; k < input.probes.size(); ++k)
    if (input.probes[k].kind == Probe::Kind::section) {
      const std::vector<LocalIndex>& nodes = selected(model.mesh, "probe", k);
      watched.insert(watched.end(), nodes.begin(), nodes.end());
    }
  if (const auto set = model.mesh.node_sets.find(interface_set); set != model.mesh.node_sets.end()) {
    model.between_parts.nodes = set->second;
    watched.insert(watched.end(), set->second.begin(), set->second.end());
  }
  std::ranges::sort(watched);
  watched.erase(std::unique(watched.begin(), watched.end()), watched.end());
}

/// The blocks of these parts, ascending.
std::vector<std::int32_t> blocks_of_parts(const model::Model& model, const std::vector<std::string>& parts) {
  std::vector<std::int32_t> blocks;
  for (std::size_t b = 0; b < model.blocks.size(); ++b)
    if (std::ranges::find(parts, model.blocks[b].part) != parts.end()) blocks.push_back(static_cast<std::int32_t>(b));
  return blocks;
}

void build_loads(const Input& input, model::Model& model) {
  if (input.gravity) {
    model.loads.gravity = input.gravity->vector;
    model.loads.gravity_curve = curve_of(input, input.gravity->curve);
  }
  if (input.damping) model.loads.damping = *input.damping;
  for (std::size_t k = 0; k < input.pressure.size(); ++k)
    model.loads.pressure.push_back({model.mesh.side_sets.at(selection_name("pressure", k)), input.pressure[k].value,
                                    curve_of(input, input.pressure[k].curve)});
  build_dead_loads(input, model);
  model.relaxes = input.relaxation.has_value();
  for (const RigidWall& wall : input.rigid_walls) {
    model::RigidWall& built = model.touching.walls.emplace_back(model::RigidWall{
        {wall}, curve_of(input, wall.motion), !wall.motion.empty(), blocks_of_parts(model, wall.parts)});
    built.point -= model.mesh.origin;
    built.normal.normalize();
  }
}

/// Nodes that contact, walls or constraints may still change after the prediction. Those of rigid bodies follow.
std::vector<LocalIndex> deferred_nodes(const model::Model& model) {
  std::vector<LocalIndex> deferred;
  for (const contact::ConstrainedNode& constrained : model.supports.nodes) deferred.push_back(constrained.node);
  if (model.touching.contact.pairs.any_acts() || !model.touching.walls.empty()) {
    const std::vector<LocalIndex>& surface = model.mesh.node_sets.at(surface_set);
    deferred.insert(deferred.end(), surface.begin(), surface.end());
    deferred.insert(deferred.end(), model.losses.uncovered.begin(), model.losses.uncovered.end());
  }
  deferred.insert(deferred.end(), model.between_parts.nodes.begin(), model.between_parts.nodes.end());
  std::ranges::sort(deferred);
  deferred.erase(std::unique(deferred.begin(), deferred.end()), deferred.end());
  for (const model::RigidBody& body : model.bodies)
    std::erase_if(deferred, [&](LocalIndex node) { return std::ranges::binary_search(body.nodes, node); });
  return deferred;
}

/// Interfaces of mortar contact for each pair of its two parts, and the planes of symmetry that affect their normals.
void build_mortar(const Input& input, model::Model& model) {
  const auto block_of = [&](const std::string& part) {
    return static_cast<std::int32_t>(std::ranges::find(model.blocks, part, &model::ElementBlock::part) -
                                     model.blocks.begin());
  };
  for (std::size_t k = 0; k < input.contact.size(); ++k) {
    const ContactEntry& entry = input.contact[k];
    if (!entry.mortar) continue;
    contact::MortarPair pair{block_of(entry.between[0]), block_of(entry.between[1])};
    pair.choose_slave = entry.slave == ContactEntry::Slave::automatic;
    if (entry.slave == ContactEntry::Slave::second) std::swap(pair.slave, pair.master);
    pair.multiplier = entry.multiplier;
    pair.enforce = entry.enforce;
    pair.consistent = entry.consistent;
    pair.edges = entry.edges;
    pair.friction = entry.friction.fixed;
    pair.tied = entry.tied;
    pair.entry = input.at(fmt::format("contact.{}", k));
    const auto same = [&](const contact::MortarPair& other) {  // a later entry takes precedence
      return std::minmax(other.slave, other.master) == std::minmax(pair.slave, pair.master);
    };
    std::erase_if(model.touching.mortar, same);
    model.touching.mortar.push_back(pair);
  }
  if (model.touching.mortar.empty()) return;
  for (std::size_t k = 0; k < input.symmetry.size(); ++k)
    model.touching.symmetries.push_back({input.symmetry[k].normal.normalized(), selected(model.mesh, "symmetry", k)});
}

}  // namespace

model::Model build_model(const Input& input, std::span<const std::size_t> part_of, mesh::LocalMesh&& mesh) {
  model::Model model;
  model.mesh = std::move(mesh);
  for (std::size_t b = 0; b < model.mesh.blocks.size(); ++b)
    model.blocks.push_back(build_block(input.parts[part_of[b]], input, model.mesh.blocks[b]));
  for (const Vec3& X : model.mesh.coordinates) model.reference.push_back(Quad{X[0], X[1], X[2]});
  build_loads(input, model);
  build_constraints(input, model);
  build_bodies(input, model);
  build_joints(input, model);
  model.touching.in_symmetry_plane = in_symmetry_plane(input, model.mesh, model.mesh.faces);
  std::vector<std::string> part_of_block;
  for (const model::ElementBlock& block : model.blocks) part_of_block.push_back(block.part);
  model.touching.contact = contact_specification(input, part_of_block);
  build_mortar(input, model);
  watch_nodes(input, model);
  build_removals(input, model);
  model.deferred = deferred_nodes(model);
  return model;
}

std::vector<char> in_symmetry_plane(const Input& input, const mesh::LocalMesh& mesh,
                                    std::span<const mesh::ExteriorFace> faces) {
  std::vector<char> flags(faces.size(), 0);
  for (std::size_t k = 0; k < input.symmetry.size(); ++k) {
    const std::vector<LocalIndex>& plane = selected(mesh, "symmetry", k);
    for (std::size_t f = 0; f < faces.size(); ++f)
      if (std::ranges::all_of(faces[f].nodes, [&](LocalIndex node) {
            return node == no_index || std::ranges::binary_search(plane, node);
          }))
        flags[f] = 1;
  }
  return flags;
}

std::vector<Vec3> initial_velocities(const Input& input, std::span<const Vec3> coordinates, const Vec3& origin,
                                     const NodeSets& sets) {
  std::vector<Vec3> velocity(coordinates.size(), Vec3::Zero());
  for (std::size_t k = 0; k < input.initial.size(); ++k) {
    const InitialMotion& entry = input.initial[k];
    const Vec3 spin = entry.spin_rate * entry.spin_axis.normalized();
    const Vec3 point = entry.spin_point - origin;
    for (const LocalIndex node : sets.at(selection_name("initial", k))) {
      const auto i = static_cast<std::size_t>(node);
      velocity[i] = entry.velocity + spin.cross(coordinates[i] - point);
    }
  }
  return velocity;
}

std::vector<Vec3> initial_velocities(const Input& input, const model::Model& model) {
  return initial_velocities(input, model.mesh.coordinates, model.mesh.origin, model.mesh.node_sets);
}

std::vector<Vec3> initial_rates(const Input& input, const model::Model& model) {
  if (!model.turns()) return {};
  std::vector<Vec3> rate(static_cast<std::size_t>(model.nodes()), Vec3::Zero());
  for (std::size_t k = 0; k < input.initial.size(); ++k)
    for (const LocalIndex node : selected(model.mesh, "initial", k))
      nth(rate, node) = input.initial[k].spin_rate * input.initial[k].spin_axis.normalized();
  return rate;
}

}  // namespace brunt::scene
