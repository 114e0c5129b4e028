// SPDX-License-Identifier: Apache-2.0
#include "surface/exposed.hpp"

#include <algorithm>
#include <array>
#include <tuple>

#include "comm/rendezvous.hpp"
#include "core/cells.hpp"
#include "core/error.hpp"

namespace brunt::surface {
namespace {

using mesh::ExteriorFace;

/// A face on its home rank, which receives all elements with its nodes.
struct FaceUse {
  std::array<GlobalIndex, 4> nodes{};  ///< gids ascending, led by no_index for a triangle
  GlobalIndex key = 0;
  Rank rank = 0;
  LocalIndex element = 0;  ///< of that rank, counted through its blocks
};

/// Message to the rank of a face: the element on the other side.
struct Beyond {
  GlobalIndex key = 0, other = 0;  ///< of the face, of the same face as the other element has it
  Rank rank = 0;
  LocalIndex element = 0;
};

/// Elements counted through the blocks of this rank: the first of each block, and how many there are.
std::vector<LocalIndex> first_of_block(const mesh::LocalMesh& mesh) {
  std::vector<LocalIndex> first{0};
  for (const mesh::LocalBlock& block : mesh.blocks)
    first.push_back(first.back() + static_cast<LocalIndex>(block.gid.size()));
  return first;
}

LocalIndex element_of(const mesh::LocalMesh& mesh, const std::vector<LocalIndex>& first, const ExteriorFace& face) {
  const std::vector<GlobalIndex>& gid = nth(mesh.blocks, face.block).gid;
  const auto found = std::ranges::lower_bound(gid, cells::element_of_key(face.key));
  demand(found != gid.end() && *found == cells::element_of_key(face.key), "the element of a face is on its rank");
  return nth(first, face.block) + static_cast<LocalIndex>(found - gid.begin());
}

/// The flags of all elements of this rank.
std::vector<double> flags_of(const mesh::LocalMesh& mesh, Alive alive) {
  std::vector<double> flags;
  for (std::size_t b = 0; b < mesh.blocks.size(); ++b) {
    if (b < alive.size() && !alive[b].empty())
      flags.insert(flags.end(), alive[b].begin(), alive[b].end());
    else
      flags.insert(flags.end(), mesh.blocks[b].gid.size(), 1.0);
  }
  return flags;
}

/// On the home rank of its lowest node each face is matched with the same face of other elements.
std::vector<FaceUse> uses_at_home(const comm::Communicator& ranks, const mesh::LocalMesh& mesh,
                                  std::span<const ExteriorFace> faces) {
  const std::vector<LocalIndex> first = first_of_block(mesh);
  std::vector<std::vector<FaceUse>> to_home(static_cast<std::size_t>(ranks.size()));
  for (const ExteriorFace& face : faces) {
    FaceUse use{.key = face.key, .rank = ranks.rank(), .element = element_of(mesh, first, face)};
    for (std::size_t i = 0; i < 4; ++i)
      use.nodes[i] = face.nodes[i] == no_index ? no_index : nth(mesh.node_gid, face.nodes[i]);
    std::ranges::sort(use.nodes);
    const GlobalIndex lowest = use.nodes[0] == no_index ? use.nodes[1] : use.nodes[0];
    to_home[static_cast<std::size_t>(lowest) % to_home.size()].push_back(use);
  }
  std::vector<FaceUse> uses = comm::exchange(ranks, to_home).values;
  std::ranges::sort(
      uses, [](const FaceUse& a, const FaceUse& b) { return std::tie(a.nodes, a.key) < std::tie(b.nodes, b.key); });
  return uses;
}

/// The element on the other side of each face of this rank.
std::vector<Beyond> found_beyond(const comm::Communicator& ranks, const std::vector<FaceUse>& uses) {
  std::vector<std::vector<Beyond>> to_face(static_cast<std::size_t>(ranks.size()));
  for (std::size_t first = 0, last = 0; first < uses.size(); first = last) {
    while (last < uses.size() && uses[last].nodes == uses[first].nodes) ++last;
    for (std::size_t i = first; i < last; ++i)
      for (std::size_t j = first; j < last; ++j)
        if (i != j) nth(to_face, uses[i].rank).push_back({uses[i].key, uses[j].key, uses[j].rank, uses[j].element});
  }
  std::vector<Beyond> found = comm::exchange(ranks, to_face).values;
  std::ranges::sort(
      found, [](const Beyond& a, const Beyond& b) { return std::tie(a.key, a.other) < std::tie(b.key, b.other); });
  return found;
}

/// Flags of a node from the elements around it.
enum Mark : char { none = 0, held = 1, taken = 2 };

/// By this rank's elements: kept by a living one, removed with a removed one; both flags may be set.
std::vector<char> marks_here(const mesh::LocalMesh& mesh, std::span<const double> flags) {
  std::vector<char> marks(mesh.node_gid.size(), none);
  auto flag = flags.begin();
  for (const mesh::LocalBlock& block : mesh.blocks) {
    const auto width = static_cast<std::size_t>(mesh::nodes_per_element(block.shape));
    for (std::size_t first = 0; first < block.nodes.size(); first += width, ++flag)
      for (const LocalIndex node : std::span(block.nodes).subspan(first, width)) {
        char& mark = nth(marks, node);
        mark = static_cast<char>(mark | (*flag > 0 ? held : *flag < 0 ? taken : none));
      }
  }
  return marks;
}

}  // namespace

InnerFaces join_faces(const comm::Communicator& ranks, const mesh::LocalMesh& mesh, std::vector<ExteriorFace> faces) {
  InnerFaces inner;
  std::ranges::sort(faces, {}, &ExteriorFace::key);
  inner.faces = std::move(faces);
  const std::vector<Beyond> found = found_beyond(ranks, uses_at_home(ranks, mesh, inner.faces));
  const LocalIndex here = first_of_block(mesh).back();
  std::vector<comm::RemoteSlot> source;
  auto next = found.begin();
  for (const ExteriorFace& face : inner.faces) {
    for (; next != found.end() && next->key == face.key; ++next) {
      if (next->rank == ranks.rank()) {
        inner.beyond.values.push_back(next->element);
        continue;
      }
      inner.beyond.values.push_back(here + static_cast<LocalIndex>(source.size()));
      source.push_back({next->rank, next->element});
    }
    inner.beyond.close_row();
  }
  inner.any_foreign = ranks.any(!source.empty());
  if (inner.any_foreign) inner.foreign = comm::Halo(ranks, here, source);
  return inner;
}

BareNodes bare_nodes(const comm::Communicator& ranks, const mesh::LocalMesh& mesh, Alive alive) {
  struct Reported {
    GlobalIndex gid = 0, mark = 0;
  };
  std::vector<char> marks = marks_here(mesh, flags_of(mesh, alive));
  std::vector<std::vector<Reported>> told(static_cast<std::size_t>(ranks.size()));
  for (std::size_t s = 0; s < mesh.shared.size(); ++s) {
    const auto node = static_cast<std::size_t>(mesh.shared[s]);
    for (const Rank sharer : mesh.sharers.row(static_cast<LocalIndex>(s)))
      if (sharer != ranks.rank() && marks[node] != none)
        nth(told, sharer).push_back({mesh.node_gid[node], marks[node]});
  }
  for (const auto& [gid, mark] : comm::exchange(ranks, told).values) {
    const auto node = static_cast<std::size_t>(std::ranges::lower_bound(mesh.node_gid, gid) - mesh.node_gid.begin());
    marks[node] = static_cast<char>(marks[node] | mark);
  }
  BareNodes bare;
  for (std::size_t i = 0; i < marks.size(); ++i)
    if ((marks[i] & held) == 0)
      ((marks[i] & taken) != 0 ? bare.dropped : bare.kept).push_back(static_cast<LocalIndex>(i));
  return bare;
}

ExposedSurface exposed_surface(const comm::Communicator& ranks, const mesh::LocalMesh& mesh, const InnerFaces& inner,
                               Alive alive) {
  std::vector<double> flags = flags_of(mesh, alive);
  const std::vector<LocalIndex> first = first_of_block(mesh);
  const std::vector<LocalIndex> bare = bare_nodes(ranks, mesh, alive).kept;
  if (inner.any_foreign) {
    std::vector<double> foreign(static_cast<std::size_t>(inner.foreign.leaves()));
    inner.foreign.forward(flags, foreign, 1);
    flags.insert(flags.end(), foreign.begin(), foreign.end());
  }
  const auto lives = [&](LocalIndex element) { return nth(flags, element) > 0; };
  ExposedSurface outside;
  const auto look_at = [&](const ExteriorFace& face, std::span<const LocalIndex> beyond) {
    if (lives(element_of(mesh, first, face))) {
      if (std::ranges::none_of(beyond, lives)) outside.faces.push_back(face);
      return;
    }
    for (const LocalIndex node : face.nodes)
      if (node != no_index && std::ranges::binary_search(bare, node))
        outside.points.push_back({face.key, node, face.block, face.body});
  };
  for (const ExteriorFace& face : mesh.faces) look_at(face, {});
  for (std::size_t f = 0; f < inner.faces.size(); ++f)
    look_at(inner.faces[f], inner.beyond.row(static_cast<LocalIndex>(f)));
  std::ranges::sort(outside.faces, {}, &ExteriorFace::key);
  std::ranges::sort(outside.points, [](const MassPoint& a, const MassPoint& b) {
    return std::tie(a.node, a.block, a.key) < std::tie(b.node, b.block, b.key);
  });
  const auto same = [](const MassPoint& a, const MassPoint& b) { return a.node == b.node && a.block == b.block; };
  outside.points.erase(std::unique(outside.points.begin(), outside.points.end(), same), outside.points.end());
  return outside;
}

}  // namespace brunt::surface
