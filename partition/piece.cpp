// SPDX-License-Identifier: Apache-2.0
#include "partition/piece.hpp"

#include <algorithm>

#include "core/cells.hpp"
#include "core/error.hpp"
#include "core/sorted.hpp"
#include "mesh/topology.hpp"
#include "partition/dual_graph.hpp"

namespace brunt::partition {

namespace {

template <class Index>
std::size_t at(Index i) {
  return static_cast<std::size_t>(i);
}

std::vector<LocalIndex> nodes_without_element(const mesh::Mesh& mesh) {
  std::vector<bool> touched(mesh.coordinates.size(), false);
  for_each_element(mesh, [&](std::span<const LocalIndex> nodes, mesh::Shape) {
    for (const LocalIndex node : nodes) touched[at(node)] = true;
  });
  std::vector<LocalIndex> untouched;
  for (std::size_t i = 0; i < touched.size(); ++i)
    if (!touched[i]) untouched.push_back(static_cast<LocalIndex>(i));
  return untouched;
}

}  // namespace

Cutter::Cutter(const mesh::CanonicalMesh& whole, std::span<const Rank> part, int parts)
    : whole_(whole),
      first_(first_of_block(whole.mesh)),
      body_(mesh::bodies(whole.mesh)),
      untouched_(nodes_without_element(whole.mesh)),
      element_(at(parts)),
      local_(whole.mesh.coordinates.size(), no_index) {
  demand(part.size() == at(first_.back()), "each element has a part");
  demand(std::ranges::all_of(part, [&](Rank r) { return r >= 0 && r < parts; }), "each part is a rank");
  sharing_ = share_nodes(whole.mesh, part);
  std::vector<std::size_t> count(at(parts), 0);
  for (const Rank rank : part) ++count[at(rank)];
  for (std::size_t r = 0; r < count.size(); ++r) element_[r].reserve(count[r]);
  for (std::size_t e = 0; e < part.size(); ++e) element_[at(part[e])].push_back(static_cast<LocalIndex>(e));
  exterior_ = by_rank(mesh::exterior_sides(whole.mesh), part, parts);
  for (const auto& [name, sides] : whole.mesh.side_sets) side_sets_[name] = by_rank(sides, part, parts);
}

mesh::LocalMesh Cutter::piece(Rank rank) {
  const mesh::Mesh& mesh = whole_.mesh;
  mesh::LocalMesh piece;
  piece.global_nodes = static_cast<GlobalIndex>(mesh.coordinates.size());
  piece.global_elements = first_.back();
  piece.origin = whole_.origin;
  const std::vector<LocalIndex> nodes = nodes_of(rank);
  for (std::size_t i = 0; i < nodes.size(); ++i) local_[at(nodes[i])] = static_cast<LocalIndex>(i);
  cut_nodes(piece, nodes, rank);
  cut_blocks(piece, rank);
  cut_sets(piece, rank);
  for (const LocalIndex node : nodes) local_[at(node)] = no_index;
  return piece;
}

std::size_t Cutter::gid(const mesh::Side& side) const {
  return at(first_[at(side.block)] + side.element);
}

Cutter::RankSides Cutter::by_rank(const std::vector<mesh::Side>& sides, std::span<const Rank> part, int parts) const {
  RankSides sorted(at(parts));
  for (const mesh::Side& side : sides) sorted[at(part[gid(side)])].push_back(side);
  const auto key = [&](const mesh::Side& side) {
    return cells::key_of(static_cast<GlobalIndex>(gid(side)), side.face);
  };
  const auto same = [&](const mesh::Side& a, const mesh::Side& b) { return key(a) == key(b); };
  for (std::vector<mesh::Side>& row : sorted) {
    std::ranges::sort(row, {}, key);
    row.erase(std::unique(row.begin(), row.end(), same), row.end());
  }
  return sorted;
}

std::vector<LocalIndex> Cutter::nodes_of(Rank rank) {
  std::vector<LocalIndex> nodes;
  const auto add = [&](LocalIndex node) {
    if (local_[at(node)] != no_index) return;
    local_[at(node)] = 0;
    nodes.push_back(node);
  };
  for (std::size_t b = 0; b < whole_.mesh.blocks.size(); ++b) {
    const mesh::Block& block = whole_.mesh.blocks[b];
    const auto& elements = element_[at(rank)];
    for (auto e = std::ranges::lower_bound(elements, first_[b]); e != elements.end() && *e < first_[b + 1]; ++e) {
      const LocalIndex* corner = block.element(static_cast<LocalIndex>(*e) - first_[b]);
      std::for_each_n(corner, mesh::nodes_per_element(block.shape), add);
    }
  }
  if (rank == 0) std::ranges::for_each(untouched_, add);
  std::ranges::sort(nodes);
  return nodes;
}

void Cutter::cut_nodes(mesh::LocalMesh& piece, const std::vector<LocalIndex>& nodes, Rank rank) const {
  const mesh::Mesh& mesh = whole_.mesh;
  auto row = sharing_.shared.begin();
  piece.coordinates.reserve(nodes.size());
  for (auto* gids : {&piece.node_gid, &piece.input_node, &piece.node_id}) gids->reserve(nodes.size());
  piece.owner.reserve(nodes.size());
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    const LocalIndex node = nodes[i];
    piece.coordinates.push_back(mesh.coordinates[at(node)]);
    piece.node_gid.push_back(node);
    piece.input_node.push_back(whole_.input_node[at(node)]);
    piece.node_id.push_back(mesh.node_id[at(node)]);
    piece.owner.push_back(sharing_.owner[at(node)]);
    row = std::lower_bound(row, sharing_.shared.end(), node);
    if (row == sharing_.shared.end() || *row != node) continue;
    piece.shared.push_back(static_cast<LocalIndex>(i));
    for (const Rank holder : sharing_.holders.row(static_cast<LocalIndex>(row - sharing_.shared.begin())))
      if (holder != rank) piece.sharers.values.push_back(holder);
    piece.sharers.close_row();
  }
}

void Cutter::cut_blocks(mesh::LocalMesh& piece, Rank rank) const {
  const auto& elements = element_[at(rank)];
  auto e = elements.begin();
  for (std::size_t b = 0; b < whole_.mesh.blocks.size(); ++b) {
    const mesh::Block& block = whole_.mesh.blocks[b];
    piece.block_name.push_back(block.name);
    piece.block_id.push_back(block.id);
    mesh::LocalBlock& local = piece.blocks.emplace_back();
    local.shape = block.shape;
    const auto count = at(std::lower_bound(e, elements.end(), first_[b + 1]) - e);
    local.gid.reserve(count);
    local.input.reserve(count);
    local.nodes.reserve(count * at(mesh::nodes_per_element(block.shape)));
    for (; e != elements.end() && *e < first_[b + 1]; ++e) {
      const auto in_block = static_cast<LocalIndex>(*e) - first_[b];
      local.gid.push_back(*e);
      local.input.push_back(whole_.input_element[b][at(in_block)]);
      for (int c = 0; c < mesh::nodes_per_element(block.shape); ++c)
        local.nodes.push_back(local_[at(block.element(in_block)[c])]);
    }
  }
}

std::vector<mesh::ExteriorFace> Cutter::faces(const std::vector<mesh::Side>& sides) const {
  std::vector<mesh::ExteriorFace> faces;
  for (const mesh::Side& side : sides) {
    const mesh::Block& block = whole_.mesh.blocks[at(side.block)];
    mesh::ExteriorFace face;
    face.key = cells::key_of(static_cast<GlobalIndex>(gid(side)), side.face);
    face.nodes = mesh::face_nodes(block.shape, block.element(side.element), side.face);
    for (LocalIndex& node : face.nodes)
      if (node != no_index) node = local_[at(node)];
    face.block = side.block;
    face.body = body_[gid(side)];
    faces.push_back(face);
  }
  return faces;
}

void Cutter::cut_sets(mesh::LocalMesh& piece, Rank rank) const {
  piece.faces = faces(exterior_[at(rank)]);
  for (const auto& [name, sides] : side_sets_) piece.side_sets[name] = faces(sides[at(rank)]);
  for (const auto& [name, nodes] : whole_.mesh.node_sets) {
    std::vector<LocalIndex>& own = piece.node_sets[name];
    for (const LocalIndex node : nodes)
      if (local_[at(node)] != no_index) own.push_back(local_[at(node)]);
    sort_unique(own);
  }
}

}  // namespace brunt::partition
