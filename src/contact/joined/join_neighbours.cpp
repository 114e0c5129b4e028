// SPDX-License-Identifier: Apache-2.0
// Elements report to the owners of their surface nodes which nodes they connect; faces meet at their edges.
#include "contact/joined/join_neighbours.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numeric>
#include <tuple>

#include "comm/rendezvous.hpp"
#include "core/cells.hpp"
#include "core/error.hpp"
#include "geometry/closest_point.hpp"

namespace brunt::contact {
namespace {

/// Node `other` is in an element with surface node `gid`.
struct Together {
  GlobalIndex gid = 0, other = 0;
  friend auto operator<=>(const Together&, const Together&) = default;
};

/// Ascending, each once; lists of one rank come in that order.
void keep_different(std::vector<Together>& list) {
  if (!std::is_sorted(list.begin(), list.end())) std::sort(list.begin(), list.end());
  list.erase(std::unique(list.begin(), list.end()), list.end());
}

bool has_element(const mesh::LocalMesh& mesh, const SurfaceFace& face) {
  const auto block = static_cast<std::size_t>(face.block);
  return block < mesh.blocks.size() && !mesh.blocks[block].gid.empty();
}

/// Calls use(surface node, gid of a node) for the nodes of this rank's living elements around its surface nodes; of a
/// surface without elements the faces stand for them. A pair comes as often as elements hold both.
template <class Use>
void for_each_together(const mesh::LocalMesh& mesh, const Surface& surface, surface::Alive alive, const Use& use) {
  std::vector<LocalIndex> surface_node(mesh.node_gid.size(), no_index);
  for (std::size_t s = 0; s < surface.model_node.size(); ++s)
    nth(surface_node, surface.model_node[s]) = static_cast<LocalIndex>(s);
  for (std::size_t b = 0; b < mesh.blocks.size(); ++b) {
    const mesh::LocalBlock& block = mesh.blocks[b];
    const std::vector<double>* flags = b < alive.size() && !alive[b].empty() ? &alive[b] : nullptr;
    const auto width = static_cast<std::size_t>(mesh::nodes_per_element(block.shape));
    for (std::size_t first = 0; first < block.nodes.size(); first += width) {
      if (flags != nullptr && (*flags)[first / width] <= 0) continue;
      const std::span<const LocalIndex> nodes(&block.nodes[first], width);
      for (const LocalIndex node : nodes) {
        const LocalIndex at = nth(surface_node, node);
        if (at == no_index) continue;
        for (const LocalIndex other : nodes) use(at, nth(mesh.node_gid, other));
      }
    }
  }
  for (const SurfaceFace& face : surface.faces) {
    if (has_element(mesh, face)) continue;
    for (const LocalIndex node : std::span(face.nodes).first(static_cast<std::size_t>(face.corner_count)))
      for (const GlobalIndex other : face.element)
        if (other != no_index) use(node, other);
  }
}

/// The surface nodes that this rank's elements contain, each with the nodes of those elements: ascending, each once.
/// Sorted node by node, since this is made anew whenever elements go.
std::vector<Together> seen_here(const mesh::LocalMesh& mesh, const Surface& surface, surface::Alive alive) {
  std::vector<std::size_t> end(surface.gid.size() + 1, 0);
  for_each_together(mesh, surface, alive,
                    [&](LocalIndex node, GlobalIndex) { ++end[static_cast<std::size_t>(node) + 1]; });
  for (std::size_t s = 1; s < end.size(); ++s) end[s] += end[s - 1];
  std::vector<GlobalIndex> others(end.back());
  std::vector<std::size_t> next(end.begin(), end.end() - 1);
  for_each_together(mesh, surface, alive,
                    [&](LocalIndex node, GlobalIndex other) { others[nth(next, node)++] = other; });
  std::vector<Together> seen;
  for (std::size_t s = 0; s < surface.gid.size(); ++s) {
    const auto first = others.begin() + static_cast<std::ptrdiff_t>(end[s]);
    const auto last = others.begin() + static_cast<std::ptrdiff_t>(end[s + 1]);
    std::sort(first, last);
    const auto different = std::unique(first, last);
    for (auto other = first; other != different; ++other) seen.push_back({surface.gid[s], *other});
  }
  return seen;
}

/// One face at an edge, reported to the home of the edge.
struct EdgeUse {
  std::array<GlobalIndex, 2> gid{};  ///< ascending
  GlobalIndex key = 0;
  Place face;
  std::array<double, 3> area{};       ///< of the face
  std::array<double, 3> direction{};  ///< of the edge, counter-clockwise around the face
  std::array<GlobalIndex, cells::most_corners> element{};
  double element_depth = 0;
  std::int32_t body = 0, block = 0;
};

/// What the home reports to the rank of the face with the lower key.
struct EdgeFound {
  std::array<GlobalIndex, 2> gid{};
  std::array<Place, 2> faces{};  ///< lower key first
  std::array<std::array<GlobalIndex, cells::most_corners>, 2> elements{};
  std::int32_t body = 0, block = 0;
  double element_depth = 0;
  EdgeKind kind = EdgeKind::flat;
};

Vec3 vector_of(const std::array<double, 3>& components) {
  return Vec3(components.data());
}

std::array<double, 3> components_of(const Vec3& vector) {
  return {vector[0], vector[1], vector[2]};
}

std::vector<EdgeUse> uses_at_home(const comm::Communicator& ranks, const mesh::LocalMesh& mesh,
                                  const Surface& surface) {
  std::vector<std::vector<EdgeUse>> to_home(static_cast<std::size_t>(ranks.size()));
  for (std::size_t f = 0; f < surface.faces.size(); ++f) {
    const SurfaceFace& face = surface.faces[f];
    const auto count = static_cast<std::size_t>(face.corner_count);
    std::array<Vec3, 4> corners;
    std::array<GlobalIndex, 4> gid{};
    for (std::size_t i = 0; i < count; ++i) {
      const auto node = static_cast<std::size_t>(face.nodes[i]);
      corners[i] = nth(mesh.coordinates, surface.model_node[node]);
      gid[i] = surface.gid[node];
    }
    const Vec3 area = geometry::area_vector({corners.data(), count});
    for (std::size_t i = 0; i < count; ++i) {
      const std::size_t next = (i + 1) % count;
      const auto [low, high] = std::minmax(gid[i], gid[next]);
      const EdgeUse use{.gid = {low, high},
                        .key = face.key,
                        .face = {ranks.rank(), static_cast<LocalIndex>(f)},
                        .area = components_of(area),
                        .direction = components_of(corners[next] - corners[i]),
                        .element = face.element,
                        .element_depth = face.element_depth,
                        .body = face.body,
                        .block = face.block};
      to_home[static_cast<std::size_t>(low) % to_home.size()].push_back(use);
    }
  }
  const std::vector<EdgeUse> uses = comm::exchange(ranks, to_home).values;
  std::vector<std::size_t> order(uses.size());  // the records are large: their numbers are sorted in their place
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return std::tie(uses[a].gid, uses[a].key) < std::tie(uses[b].gid, uses[b].key);
  });
  std::vector<EdgeUse> sorted;
  sorted.reserve(uses.size());
  for (const std::size_t use : order) sorted.push_back(uses[use]);
  return sorted;
}

/// Between the normals [radians]; > 0: convex.
double angle_between(const EdgeUse& one, const EdgeUse& other) {
  const Vec3 normal = vector_of(one.area).normalized(), other_normal = vector_of(other.area).normalized();
  const Vec3 turn = normal.cross(other_normal);
  const double sine = turn.dot(vector_of(one.direction).normalized());
  return std::atan2(sine, normal.dot(other_normal));
}

EdgeKind kind_of(double angle, const EdgeAngles& angles) {
  return angle > angles.sharp ? EdgeKind::sharp : angle > angles.blunt ? EdgeKind::blunt : EdgeKind::flat;
}

}  // namespace

Ragged<GlobalIndex> element_neighbours(const comm::Communicator& ranks, const mesh::LocalMesh& mesh,
                                       const Surface& surface, surface::Alive alive) {
  std::vector<std::vector<Together>> to_owner(static_cast<std::size_t>(ranks.size()));
  std::size_t at = 0;
  for (const Together& pair : seen_here(mesh, surface, alive)) {
    while (surface.gid[at] != pair.gid) ++at;
    nth(to_owner, surface.home[at].rank).push_back(pair);
  }
  std::vector<Together> known = comm::exchange(ranks, to_owner).values;
  keep_different(known);
  Ragged<GlobalIndex> neighbours;
  auto next = known.begin();
  for (const GlobalIndex gid : surface.gid) {
    for (; next != known.end() && next->gid == gid; ++next) neighbours.values.push_back(next->other);
    neighbours.close_row();
  }
  return neighbours;
}

std::vector<SurfaceEdge> edges_of(const comm::Communicator& ranks, const mesh::LocalMesh& mesh, const Surface& surface,
                                  const EdgeAngles& angles) {
  const std::vector<EdgeUse> uses = uses_at_home(ranks, mesh, surface);
  std::vector<std::vector<EdgeFound>> to_face(static_cast<std::size_t>(ranks.size()));
  for (std::size_t first = 0, last = 0; first < uses.size(); first = last) {
    while (last < uses.size() && uses[last].gid == uses[first].gid) ++last;
    if (last - first != 2) continue;  // a rim, or an edge where surfaces meet that are no neighbours
    const EdgeUse &one = uses[first], &other = uses[first + 1];
    const double angle = angle_between(one, other);
    if (!(angle > angles.least)) continue;
    nth(to_face, one.face.rank)
        .push_back({one.gid,
                    {one.face, other.face},
                    {one.element, other.element},
                    one.body,
                    one.block,
                    std::min(one.element_depth, other.element_depth),
                    kind_of(angle, angles)});
  }
  std::vector<EdgeFound> found = comm::exchange(ranks, to_face).values;
  std::sort(found.begin(), found.end(), [](const EdgeFound& a, const EdgeFound& b) { return a.gid < b.gid; });
  std::vector<SurfaceEdge> edges;
  for (const EdgeFound& edge : found) {
    SurfaceEdge convex{
        .facets = edge.faces, .body = edge.body, .block = edge.block, .element_depth = edge.element_depth};
    convex.kind = edge.kind;
    for (std::size_t i = 0; i < 2; ++i) {
      std::copy(edge.elements[i].begin(), edge.elements[i].end(),
                convex.elements.begin() + static_cast<long>(cells::most_corners * i));
      const auto at = std::lower_bound(surface.gid.begin(), surface.gid.end(), edge.gid[i]);
      demand(at != surface.gid.end() && *at == edge.gid[i], "the nodes of a face's edge are on its rank");
      convex.nodes[i] = static_cast<LocalIndex>(at - surface.gid.begin());
    }
    edges.push_back(convex);
  }
  return edges;
}

void report_to_copies(const comm::Communicator& ranks, const Surface& surface, std::vector<char>& flags) {
  const auto count = static_cast<std::size_t>(ranks.size());
  std::vector<std::vector<LocalIndex>> copies(count), asked(count), reported(count);
  for (std::size_t i = 0; i < surface.gid.size(); ++i) {
    const auto& [owner, index] = surface.home[i];
    if (owner == ranks.rank()) continue;
    nth(copies, owner).push_back(static_cast<LocalIndex>(i));
    nth(asked, owner).push_back(index);
  }
  const Ragged<LocalIndex> wanted = comm::exchange(ranks, asked);
  for (std::size_t r = 0; r < reported.size(); ++r)
    for (const LocalIndex node : wanted.row(static_cast<LocalIndex>(r))) reported[r].push_back(nth(flags, node));
  const Ragged<LocalIndex> received = comm::exchange(ranks, reported);
  for (std::size_t r = 0; r < copies.size(); ++r)
    for (std::size_t k = 0; k < copies[r].size(); ++k)
      nth(flags, copies[r][k]) = static_cast<char>(received.row(static_cast<LocalIndex>(r))[k]);
}

std::vector<char> nodes_on_rims(const comm::Communicator& ranks, const Surface& surface) {
  std::vector<std::vector<LocalIndex>> to_owner(static_cast<std::size_t>(ranks.size()));
  for (const SurfaceEdge& edge : surface.edges) {
    if (edge.kind != EdgeKind::sharp) continue;
    for (const LocalIndex node : edge.nodes) {
      const Place& home = nth(surface.home, node);
      nth(to_owner, home.rank).push_back(home.index);
    }
  }
  std::vector<char> on_rim(surface.gid.size(), 0);
  for (const LocalIndex node : comm::exchange(ranks, to_owner).values) nth(on_rim, node) = 1;

  report_to_copies(ranks, surface, on_rim);
  return on_rim;
}

}  // namespace brunt::contact
