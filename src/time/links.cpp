// SPDX-License-Identifier: Apache-2.0
#include "brunt/time/links.hpp"

namespace brunt::time {
namespace {

/// Gives each corner on a shared node a slot, in canonical element order.
std::vector<comm::Contribution> number_slots(model::Model& model) {
  std::vector<char> shared(model.mesh.node_gid.size(), 0);
  for (const LocalIndex node : model.mesh.shared) shared[static_cast<std::size_t>(node)] = 1;
  std::vector<comm::Contribution> contributions;
  for (model::ElementBlock& block : model.blocks) {
    block.border.clear();
    for (LocalIndex batch = 0; batch < block.batches(); ++batch) {
      for (int lane = 0; lane < std::min(pack_width, block.count - batch * pack_width); ++lane)
        for (int c = 0; c < block.corners; ++c) {
          const LocalIndex element = batch * pack_width + lane, node = block.corner_node(element, c);
          if (!shared[static_cast<std::size_t>(node)]) continue;
          block.border.values.push_back({static_cast<std::int8_t>(lane), static_cast<std::int8_t>(c),
                                         static_cast<LocalIndex>(contributions.size())});
          contributions.push_back({block.gid[static_cast<std::size_t>(element)] * 8 + c,
                                   model.mesh.node_gid[static_cast<std::size_t>(node)], node});
        }
      block.border.close_row();
    }
  }
  return contributions;
}

}  // namespace

Links link_ranks(const comm::Communicator& ranks, model::Model& model) {
  const mesh::LocalMesh& mesh = model.mesh;
  std::vector<GlobalIndex> shared_gid;
  for (const LocalIndex node : mesh.shared) shared_gid.push_back(mesh.node_gid[static_cast<std::size_t>(node)]);

  const std::vector<comm::Contribution> corners = number_slots(model);
  Links links{ranks, comm::OrderedSum(ranks, corners, mesh.shared, shared_gid, mesh.sharers), {}, {}, {}, {}, {}, {}};

  links.pressure_corners = force::pressure_corners(model);
  if (!model.pressure.empty()) {
    std::vector<comm::Contribution> faces;
    for (const force::PressureCorner& corner : links.pressure_corners)
      faces.push_back({corner.key, mesh.node_gid[static_cast<std::size_t>(corner.node)], corner.node});
    links.pressure = comm::OrderedSum(ranks, faces, mesh.shared, shared_gid, mesh.sharers);
    links.pressure_slots.resize(faces.size());
    links.pressure_sum.resize(mesh.node_gid.size());
  }
  return links;
}

}  // namespace brunt::time
