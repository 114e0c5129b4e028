// SPDX-License-Identifier: Apache-2.0
// Small meshes of boxes, dealt out to ranks by a rule: for tests that need a LocalMesh and no partitioner.
#pragma once
#include <array>
#include <functional>
#include <set>
#include <string>
#include <utility>

#include "mesh/local_mesh.hpp"
#include "mesh/mesh.hpp"
#include "mesh/topology.hpp"

namespace brunt::support {

/// Appends a box of hex8 as a block of its own.
inline void append_box(mesh::Mesh& mesh, const Vec3& corner, const Vec3& size, const std::array<int, 3>& elements) {
  const auto first = static_cast<LocalIndex>(mesh.coordinates.size());
  const auto [nx, ny, nz] = elements;
  for (int k = 0; k <= nz; ++k)
    for (int j = 0; j <= ny; ++j)
      for (int i = 0; i <= nx; ++i)
        mesh.coordinates.push_back(corner + Vec3(size.x() * i / nx, size.y() * j / ny, size.z() * k / nz));
  const auto node = [&, nx = nx, ny = ny](int i, int j, int k) {
    return first + static_cast<LocalIndex>((k * (ny + 1) + j) * (nx + 1) + i);
  };
  mesh::Block block;
  block.name = "box" + std::to_string(mesh.blocks.size());
  for (int k = 0; k < nz; ++k)
    for (int j = 0; j < ny; ++j)
      for (int i = 0; i < nx; ++i)
        block.nodes.insert(block.nodes.end(), {node(i, j, k), node(i + 1, j, k), node(i + 1, j + 1, k),
                                               node(i, j + 1, k), node(i, j, k + 1), node(i + 1, j, k + 1),
                                               node(i + 1, j + 1, k + 1), node(i, j + 1, k + 1)});
  mesh.blocks.push_back(block);
}

/// The part of `rank`: gids are the positions in `mesh`. rank_of(element gid) deals the elements out.
inline mesh::LocalMesh deal_out(const mesh::Mesh& mesh, Rank rank, const std::function<Rank(GlobalIndex)>& rank_of) {
  mesh::LocalMesh local;
  local.global_nodes = static_cast<GlobalIndex>(mesh.coordinates.size());
  std::vector<std::set<Rank>> holders(mesh.coordinates.size());
  std::vector<Rank> owner(mesh.coordinates.size(), no_index);
  std::vector<GlobalIndex> first_gid;
  for (const mesh::Block& block : mesh.blocks) {
    first_gid.push_back(local.global_elements);
    const int width = mesh::nodes_per_element(block.shape);
    for (LocalIndex e = 0; e < block.count(); ++e, ++local.global_elements)
      for (int i = 0; i < width; ++i) {
        const auto node = static_cast<std::size_t>(block.element(e)[i]);
        holders[node].insert(rank_of(local.global_elements));
        if (owner[node] == no_index) owner[node] = rank_of(local.global_elements);
      }
  }
  std::vector<LocalIndex> here(mesh.coordinates.size(), no_index);
  for (std::size_t n = 0; n < holders.size(); ++n) {
    if (!holders[n].contains(rank)) continue;
    here[n] = static_cast<LocalIndex>(local.node_gid.size());
    if (holders[n].size() > 1) {
      local.shared.push_back(here[n]);
      for (const Rank other : holders[n])
        if (other != rank) local.sharers.values.push_back(other);
      local.sharers.close_row();
    }
    local.node_gid.push_back(static_cast<GlobalIndex>(n));
    local.coordinates.push_back(mesh.coordinates[n]);
    local.owner.push_back(owner[n]);
  }
  const std::vector<std::int32_t> body = mesh::bodies(mesh);
  for (const mesh::Side& side : mesh::exterior_sides(mesh)) {
    const auto block = static_cast<std::size_t>(side.block);
    const GlobalIndex gid = first_gid[block] + side.element;
    if (rank_of(gid) != rank) continue;
    mesh::ExteriorFace face{
        .key = gid * 8 + side.face, .nodes = {}, .block = side.block, .body = body[static_cast<std::size_t>(gid)]};
    face.nodes = mesh::face_nodes(mesh.blocks[block].shape, mesh.blocks[block].element(side.element), side.face);
    for (LocalIndex& node : face.nodes)
      if (node != no_index) node = here[static_cast<std::size_t>(node)];
    local.faces.push_back(face);
  }
  for (std::size_t b = 0; b < mesh.blocks.size(); ++b) {
    const mesh::Block& block = mesh.blocks[b];
    mesh::LocalBlock& mine =
        local.blocks.emplace_back(mesh::LocalBlock{.shape = block.shape, .gid = {}, .input = {}, .nodes = {}});
    for (LocalIndex e = 0; e < block.count(); ++e) {
      const GlobalIndex gid = first_gid[b] + e;
      if (rank_of(gid) != rank) continue;
      mine.gid.push_back(gid);
      mine.input.push_back(gid);
      for (int i = 0; i < mesh::nodes_per_element(block.shape); ++i)
        mine.nodes.push_back(here[static_cast<std::size_t>(block.element(e)[i])]);
    }
  }
  return local;
}

}  // namespace brunt::support
