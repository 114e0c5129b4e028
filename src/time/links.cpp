// SPDX-License-Identifier: Apache-2.0
#include "time/links.hpp"

#include "comm/exact_sum.hpp"
#include "core/cells.hpp"
#include "force/dead_loads.hpp"
#include "force/watched.hpp"
#include "time/bodies.hpp"

namespace brunt::time {
namespace {

/// Gives a slot to each corner on a node that is shared with other ranks or used by probes, in canonical element order.
std::vector<comm::Contribution> number_slots(model::Model& model) {
  std::vector<char> shared(model.mesh.node_gid.size(), 0);
  for (const LocalIndex node : model.mesh.shared) nth(shared, node) = 1;
  for (const LocalIndex node : model.watched) nth(shared, node) = 1;
  std::vector<comm::Contribution> contributions;
  for (model::ElementBlock& block : model.blocks) {
    block.border.clear();
    for (LocalIndex batch = 0; batch < block.batches(); ++batch) {
      for (int lane = 0; lane < std::min(pack_width, block.count - batch * pack_width); ++lane)
        for (int c = 0; c < block.corners(); ++c) {
          const LocalIndex element = batch * pack_width + lane, node = block.corner_node(element, c);
          if (!nth(shared, node)) continue;
          block.border.values.push_back({static_cast<std::int8_t>(lane), static_cast<std::int8_t>(c),
                                         static_cast<LocalIndex>(contributions.size())});
          contributions.push_back({cells::key_of(nth(block.gid, element), c), nth(model.mesh.node_gid, node), node});
        }
      block.border.close_row();
    }
  }
  return contributions;
}

/// Corner moments have the slots of corner forces. Corners of solids have none: they belong to no shared node.
std::vector<comm::Contribution> corners_of_shells(const model::Model& model, std::vector<comm::Contribution> corners) {
  for (const model::ElementBlock& block : model.blocks)
    if (!block.turns())
      for (const model::BorderCorner& corner : block.border.values) nth(corners, corner.slot).node_gid = -1;
  return corners;
}

/// The corners on nodes between parts, whose work is recorded element by element.
void find_interface(model::Model& model) {
  model.between_parts.corners.clear();
  for (const model::ElementBlock& block : model.blocks)
    model.between_parts.corners.push_back(force::watched_corners(block, model.between_parts.nodes));
}

/// Distribution of a total or a traction: every face gives equal shares of its reference area to its corners. Sums at a
/// node are in the order of faces, the area of all faces is exact: the same bits on any number of ranks. Collective.
void weigh_dead_load(const comm::Communicator& ranks, model::DeadLoad& load, const model::Model& model,
                     std::span<const GlobalIndex> shared_gid) {
  const mesh::LocalMesh& mesh = model.mesh;
  std::vector<comm::Contribution> corners;
  std::vector<double> shares, areas, at_node(mesh.node_gid.size(), 0.0);
  for (const mesh::ExteriorFace& face : load.faces) {
    areas.push_back(force::reference_area(model, face));
    const int count = static_cast<int>(cells::corner_count(face.nodes));
    for (int k = 0; k < count; ++k) {
      const LocalIndex node = nth(face.nodes, k);
      corners.push_back({cells::key_of_face_corner(face.key, k), nth(mesh.node_gid, node), node});
      shares.push_back(areas.back() / count);
      nth(at_node, node) += shares.back();
    }
  }
  comm::OrderedSum sum(ranks, corners, mesh.shared, shared_gid, mesh.sharers);
  sum.begin(shares, 1);
  sum.end(shares, 1, at_node, 1);
  const double whole = load.kind == model::DeadLoad::Kind::total ? comm::exact_sum(ranks, areas) : 1.0;
  for (std::size_t i = 0; i < at_node.size(); ++i) {
    if (at_node[i] == 0) continue;
    load.nodes.push_back(static_cast<LocalIndex>(i));
    load.weight.push_back(at_node[i] / whole);
  }
}

void weigh_dead_loads(const comm::Communicator& ranks, model::Model& model, std::span<const GlobalIndex> shared_gid) {
  for (model::DeadLoad& load : model.loads.dead)
    if (load.kind == model::DeadLoad::Kind::each_node)
      load.weight.assign(load.nodes.size(), 1.0);
    else
      weigh_dead_load(ranks, load, model, shared_gid);
}

}  // namespace

Links link_ranks(const comm::Communicator& ranks, model::Model& model) {
  const mesh::LocalMesh& mesh = model.mesh;
  std::vector<GlobalIndex> shared_gid;
  for (const LocalIndex node : mesh.shared) shared_gid.push_back(nth(mesh.node_gid, node));

  const std::vector<comm::Contribution> corners = number_slots(model);
  Links links{.ranks = ranks, .corner_forces = comm::OrderedSum(ranks, corners, mesh.shared, shared_gid, mesh.sharers)};

  if (model.turns())
    links.corner_moments =
        comm::OrderedSum(ranks, corners_of_shells(model, corners), mesh.shared, shared_gid, mesh.sharers);
  link_bodies(ranks, model);
  find_interface(model);
  weigh_dead_loads(ranks, model, shared_gid);
  if (const auto faces = mesh.side_sets.find(mesh::inner_faces); faces != mesh.side_sets.end())
    links.inner_faces = surface::join_faces(ranks, mesh, faces->second);
  links.pressure_corners = force::pressure_corners(model);
  if (!model.loads.pressure.empty()) {
    std::vector<comm::Contribution> faces;
    for (const force::PressureCorner& corner : links.pressure_corners)
      faces.push_back({corner.key, nth(mesh.node_gid, corner.node), corner.node});
    links.pressure = comm::OrderedSum(ranks, faces, mesh.shared, shared_gid, mesh.sharers);
    links.pressure_slots.resize(faces.size());
    links.pressure_sum.resize(mesh.node_gid.size());
  }
  return links;
}

}  // namespace brunt::time
