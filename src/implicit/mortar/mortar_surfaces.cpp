// SPDX-License-Identifier: Apache-2.0
#include "mortar_surfaces.hpp"

#include <algorithm>

#include "comm/rendezvous.hpp"
#include "core/sorted.hpp"

namespace brunt::implicit {
namespace {

using contact::MortarPair;

template <class Record>
std::vector<Record> told_to_all(const comm::Communicator& ranks, const std::vector<Record>& mine) {
  return comm::exchange(ranks, std::vector<std::vector<Record>>(static_cast<std::size_t>(ranks.size()), mine)).values;
}

std::vector<FaceRecord> faces_of_pairs(const comm::Communicator& ranks, const model::Model& model) {
  std::vector<FaceRecord> mine;
  for (std::size_t f = 0; f < model.mesh.faces.size(); ++f) {
    const mesh::ExteriorFace& face = model.mesh.faces[f];
    const bool meets = std::ranges::any_of(model.touching.mortar, [&](const MortarPair& pair) {
      return pair.slave == face.block || pair.master == face.block;
    });
    if (!meets || (!model.touching.in_symmetry_plane.empty() && model.touching.in_symmetry_plane[f] != 0)) continue;
    FaceRecord record{face.key, {}, face.block, ranks.rank()};
    for (std::size_t k = 0; k < 4; ++k)
      record.node[k] = face.nodes[k] == no_index ? -1 : nth(model.mesh.node_gid, face.nodes[k]);
    mine.push_back(record);
  }
  std::vector<FaceRecord> all = told_to_all(ranks, mine);
  std::ranges::sort(all, {}, &FaceRecord::key);
  return all;
}

/// Directions in which supports let the body of this node move, if it has one: all if the body may rotate.
Mat3 freed_by_body(const model::Model& model, LocalIndex node) {
  for (const model::RigidBody& body : model.bodies)
    if (std::ranges::binary_search(body.nodes, node))
      return body.support.free_turn.isZero(0) ? body.support.free_shift : Mat3(Mat3::Identity());
  return Mat3::Identity();
}

std::vector<NodeRecord> nodes_of(const comm::Communicator& ranks, const model::Model& model,
                                 const std::vector<FaceRecord>& faces) {
  std::vector<GlobalIndex> gids;
  for (const FaceRecord& face : faces)
    for (const GlobalIndex gid : face.node)
      if (gid >= 0) gids.push_back(gid);
  std::ranges::sort(gids);
  std::vector<NodeRecord> mine;
  for (const LocalIndex node : model.owned) {
    const auto i = static_cast<std::size_t>(node);
    if (!std::ranges::binary_search(gids, model.mesh.node_gid[i])) continue;
    NodeRecord record{model.mesh.node_gid[i], ranks.rank(), node};
    for (int c = 0; c < 3; ++c) nth(record.reference, c) = model.reference[i][c];
    const auto held = std::ranges::lower_bound(model.supports.nodes, node, {}, &contact::ConstrainedNode::node);
    if (held != model.supports.nodes.end() && held->node == node)
      Eigen::Map<Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(record.free.data()) = held->free;
    else if (!model.bodies.empty())
      Eigen::Map<Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(record.free.data()) = freed_by_body(model, node);
    mine.push_back(record);
  }
  std::vector<NodeRecord> all = told_to_all(ranks, mine);
  std::ranges::sort(all, {}, &NodeRecord::gid);
  return all;
}

std::vector<MirrorRecord> mirrors_of(const comm::Communicator& ranks, const model::Model& model) {
  std::vector<MirrorRecord> mine;
  for (const model::SymmetryNodes& plane : model.touching.symmetries)
    for (const LocalIndex node : plane.nodes)
      if (std::ranges::binary_search(model.owned, node))
        mine.push_back({nth(model.mesh.node_gid, node), {plane.normal[0], plane.normal[1], plane.normal[2]}});
  std::vector<MirrorRecord> all = told_to_all(ranks, mine);
  std::ranges::stable_sort(all, {}, &MirrorRecord::gid);
  return all;
}

}  // namespace

Mat3 NodeRecord::free_directions() const {
  return Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(free.data());
}

WholeSurfaces tell_surfaces(const comm::Communicator& ranks, const model::Model& model) {
  WholeSurfaces whole;
  whole.faces = faces_of_pairs(ranks, model);
  whole.nodes = nodes_of(ranks, model, whole.faces);
  whole.mirrors = mirrors_of(ranks, model);
  for (const NodeRecord& node : whole.nodes) {
    whole.reference.emplace_back(node.reference.data());
    whole.free.push_back(node.free_directions());
  }
  return whole;
}

Ragged<Vec3> mirrors_at(const WholeSurfaces& whole, std::span<const LocalIndex> rows) {
  Ragged<Vec3> mirrors;
  for (const LocalIndex row : rows) {
    const GlobalIndex gid = nth(whole.nodes, row).gid;
    for (const MirrorRecord& mirror : equal_part(whole.mirrors, gid, &MirrorRecord::gid))
      mirrors.values.emplace_back(mirror.normal.data());
    mirrors.close_row();
  }
  return mirrors;
}

WholeSide side_of(const WholeSurfaces& whole, std::int32_t block) {
  WholeSide side;
  for (const FaceRecord& face : whole.faces) {
    if (face.block != block) continue;
    contact::FacetNodes facet{};
    for (std::size_t k = 0; k < 4; ++k)
      facet[k] =
          face.node[k] < 0
              ? no_index
              : static_cast<LocalIndex>(std::ranges::lower_bound(whole.nodes, face.node[k], {}, &NodeRecord::gid) -
                                        whole.nodes.begin());
    side.facets.push_back(facet);
    side.key.push_back(face.key);
    side.rank.push_back(face.rank);
  }
  return side;
}

}  // namespace brunt::implicit
