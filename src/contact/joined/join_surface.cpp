// SPDX-License-Identifier: Apache-2.0
// Once a run: who owns which surface node, and what lies around it.
#include "contact/joined/join_surface.hpp"

#include <algorithm>
#include <limits>
#include <numbers>
#include <vector>

#include "comm/exact_sum.hpp"
#include "comm/rendezvous.hpp"
#include "contact/data/tolerances.hpp"
#include "contact/joined/join_neighbours.hpp"
#include "contact/joined/seams.hpp"
#include "core/cells.hpp"
#include "core/error.hpp"
#include "geometry/closest_point.hpp"
#include "geometry/shortest_edge.hpp"

namespace brunt::contact {
namespace {

EdgeAngles edge_angles(const Tolerances& tolerances) {
  constexpr double degree = std::numbers::pi / 180;
  return {.least = -tolerances.same_direction * degree,
          .blunt = tolerances.blunt_angle * degree,
          .sharp = tolerances.same_direction * degree};
}

/// A face reports to the owner of each of its nodes.
struct NodeUse {
  GlobalIndex gid = 0, key = 0;
  std::int32_t block = no_index;  ///< no_index for an excluded face
  std::int32_t body = 0;
  Place face;
};

constexpr Place no_face{no_index, no_index};  ///< of a mass point

/// What the surface is made of.
struct Outside {
  std::span<const mesh::ExteriorFace> faces;
  std::span<const char> excluded;
  std::span<const surface::MassPoint> points{};
  surface::Alive alive{};
};

/// In order of gid, then face key: the same whoever sent them.
std::vector<NodeUse> uses_of_owned_nodes(const comm::Communicator& ranks, const mesh::LocalMesh& mesh,
                                         const Outside& outside) {
  std::vector<std::vector<NodeUse>> outgoing(static_cast<std::size_t>(ranks.size()));
  LocalIndex contact_face = 0;
  for (const surface::MassPoint& point : outside.points) {
    const auto node = static_cast<std::size_t>(point.node);
    nth(outgoing, mesh.owner[node]).push_back({mesh.node_gid[node], point.key, point.block, point.body, no_face});
  }
  for (std::size_t f = 0; f < outside.faces.size(); ++f) {
    const mesh::ExteriorFace& face = outside.faces[f];
    const bool touches = outside.excluded[f] == 0;
    for (std::size_t i = 0; i < cells::corner_count(face.nodes); ++i) {
      const auto node = static_cast<std::size_t>(face.nodes[i]);
      nth(outgoing, mesh.owner[node])
          .push_back({mesh.node_gid[node],
                      face.key,
                      touches ? face.block : no_index,
                      face.body,
                      {ranks.rank(), contact_face}});
    }
    if (touches) ++contact_face;
  }
  std::vector<NodeUse> uses = comm::exchange(ranks, outgoing).values;
  std::sort(uses.begin(), uses.end(),
            [](const NodeUse& a, const NodeUse& b) { return a.gid != b.gid ? a.gid < b.gid : a.key < b.key; });
  return uses;
}

LocalIndex index_of(const std::vector<GlobalIndex>& ascending, GlobalIndex gid) {
  const auto found = std::lower_bound(ascending.begin(), ascending.end(), gid);
  demand(found != ascending.end() && *found == gid, "a surface node is not where its owner says");
  return static_cast<LocalIndex>(found - ascending.begin());
}

/// Owned surface nodes are reported to all ranks that hold them, so that every copy is known as surface.
void collect_nodes(const comm::Communicator& ranks, const mesh::LocalMesh& mesh, const std::vector<NodeUse>& uses,
                   Surface& surface) {
  std::vector<GlobalIndex> owned;
  for (const NodeUse& use : uses)
    if (owned.empty() || owned.back() != use.gid) owned.push_back(use.gid);
  std::vector<std::vector<GlobalIndex>> reported(static_cast<std::size_t>(ranks.size()));
  for (std::size_t s = 0; s < mesh.shared.size(); ++s) {
    const auto node = static_cast<std::size_t>(mesh.shared[s]);
    const GlobalIndex gid = mesh.node_gid[node];
    if (mesh.owner[node] != ranks.rank() || !std::binary_search(owned.begin(), owned.end(), gid)) continue;
    for (const Rank sharer : mesh.sharers.row(static_cast<LocalIndex>(s)))
      if (sharer != ranks.rank()) nth(reported, sharer).push_back(gid);
  }
  const Ragged<GlobalIndex> received = comm::exchange(ranks, reported);
  surface.gid = owned;
  surface.gid.insert(surface.gid.end(), received.values.begin(), received.values.end());
  std::sort(surface.gid.begin(), surface.gid.end());
  for (const GlobalIndex gid : surface.gid) surface.model_node.push_back(index_of(mesh.node_gid, gid));

  std::vector<std::vector<LocalIndex>> place_at(reported.size());
  for (std::size_t r = 0; r < reported.size(); ++r)
    for (const GlobalIndex gid : reported[r]) place_at[r].push_back(index_of(surface.gid, gid));
  const Ragged<LocalIndex> places = comm::exchange(ranks, place_at);
  for (std::size_t i = 0; i < surface.gid.size(); ++i)
    surface.home.push_back({ranks.rank(), static_cast<LocalIndex>(i)});
  for (Rank r = 0; r < ranks.size(); ++r) {
    const auto gids = received.row(r);
    const auto there = places.row(r);
    for (std::size_t i = 0; i < gids.size(); ++i) nth(surface.home, index_of(surface.gid, gids[i])) = {r, there[i]};
  }
}

void attach_faces(const std::vector<NodeUse>& uses, Surface& surface) {
  surface.body.assign(surface.gid.size(), no_index);
  auto use = uses.begin();
  for (std::size_t i = 0; i < surface.gid.size(); ++i) {
    std::vector<std::int32_t> blocks;
    for (; use != uses.end() && use->gid == surface.gid[i]; ++use) {
      surface.body[i] = use->body;
      if (use->block == no_index) continue;
      if (use->face != no_face) surface.facets.values.push_back(use->face);
      blocks.push_back(use->block);
    }
    std::sort(blocks.begin(), blocks.end());
    surface.blocks.values.insert(surface.blocks.values.end(), blocks.begin(),
                                 std::unique(blocks.begin(), blocks.end()));
    surface.facets.close_row();
    surface.blocks.close_row();
  }
}

/// The local nodes of the element behind a face; none for a surface without elements.
std::span<const LocalIndex> element_of(const mesh::LocalMesh& mesh, const mesh::ExteriorFace& face) {
  if (static_cast<std::size_t>(face.block) >= mesh.blocks.size() || nth(mesh.blocks, face.block).gid.empty()) return {};
  const mesh::LocalBlock& block = nth(mesh.blocks, face.block);
  const auto found = std::lower_bound(block.gid.begin(), block.gid.end(), cells::element_of_key(face.key));
  demand(found != block.gid.end() && *found == cells::element_of_key(face.key),
         "the element of an exterior face is on its rank");
  const auto width = static_cast<std::size_t>(mesh::nodes_per_element(block.shape));
  return {&block.nodes[static_cast<std::size_t>(found - block.gid.begin()) * width], width};
}

/// How far the element reaches behind its face, or the face across its longest edge if that is less: what a flat or a
/// long element has to do with lies no farther away. Infinite for a surface without elements.
double element_depth(const mesh::LocalMesh& mesh, const mesh::ExteriorFace& face) {
  const std::span<const LocalIndex> element = element_of(mesh, face);
  if (element.empty()) return std::numeric_limits<double>::infinity();
  const auto corner = [&](LocalIndex node) -> const Vec3& { return nth(mesh.coordinates, node); };
  const std::size_t count = cells::corner_count(face.nodes);
  std::array<Vec3, 4> corners;
  Vec3 centre = Vec3::Zero();
  for (std::size_t i = 0; i < count; ++i) {
    corners[i] = corner(face.nodes[i]);
    centre += corners[i] / static_cast<double>(count);
  }
  const Vec3 inwards = -geometry::area_vector({corners.data(), count}).normalized();
  double depth = 0;
  for (const LocalIndex node : element) depth = std::max(depth, (corner(node) - centre).dot(inwards));
  return std::min(depth, geometry::width({corners.data(), count}));
}

void collect_faces(const mesh::LocalMesh& mesh, const Outside& outside, Surface& surface) {
  for (std::size_t f = 0; f < outside.faces.size(); ++f) {
    if (outside.excluded[f] != 0) continue;
    const mesh::ExteriorFace& from = outside.faces[f];
    SurfaceFace face{.key = from.key,
                     .corner_count = static_cast<std::int32_t>(cells::corner_count(from.nodes)),
                     .body = from.body,
                     .block = from.block,
                     .element_depth = element_depth(mesh, from)};
    for (std::size_t i = 0; i < cells::corner_count(from.nodes); ++i)
      face.nodes[i] = index_of(surface.gid, nth(mesh.node_gid, from.nodes[i]));
    face.element.fill(no_index);
    const std::span<const LocalIndex> element = element_of(mesh, from);
    const std::span<const LocalIndex> behind =
        element.empty() ? std::span(from.nodes.data(), cells::corner_count(from.nodes)) : element;
    for (std::size_t i = 0; i < behind.size(); ++i) face.element[i] = nth(mesh.node_gid, behind[i]);
    surface.faces.push_back(face);
  }
}

double mean(double sum, GlobalIndex count) {
  return count > 0 ? sum / static_cast<double>(count) : 0.0;
}

/// Bodies are numbered as at the start, when each had a face.
void measure_bodies(const comm::Communicator& ranks, const mesh::LocalMesh& mesh, std::span<const double> inverse_mass,
                    Surface& surface) {
  GlobalIndex last_body = -1;
  for (const mesh::ExteriorFace& face : mesh.faces) last_body = std::max<GlobalIndex>(last_body, face.body);
  const auto body_count = static_cast<std::size_t>(ranks.max(last_body) + 1);
  std::vector<comm::ExactAccumulator> sums(2 * body_count + 2);  // areas, masses; edges and depths of all bodies
  const std::size_t block_count = mesh.blocks.size();
  std::vector<GlobalIndex> counts(3 * body_count, 0);  // faces, nodes, nodes that cannot move
  std::vector<GlobalIndex> faces_of(body_count * block_count, 0);
  std::vector<double> edges(2 * body_count, -std::numeric_limits<double>::infinity());  // longest, minus the shortest
  for (const SurfaceFace& face : surface.faces) {
    std::array<Vec3, 4> corners;
    const auto count = static_cast<std::size_t>(face.corner_count);
    for (std::size_t i = 0; i < count; ++i) {
      const LocalIndex node = nth(surface.model_node, face.nodes[i]);
      corners[i] = nth(mesh.coordinates, node);
    }
    const geometry::Corners view(corners.data(), count);
    const auto body = static_cast<std::size_t>(face.body);
    sums[body].add(geometry::area_vector(view).norm());
    const double edge = geometry::longest_edge(view);
    sums[2 * body_count].add(edge);
    edges[2 * body] = std::max(edges[2 * body], edge);
    edges[2 * body + 1] = std::max(edges[2 * body + 1], -geometry::shortest_edge(view));
    sums[2 * body_count + 1].add(std::min(edge, face.element_depth));
    ++counts[body];
    if (static_cast<std::size_t>(face.block) < block_count)
      ++faces_of[body * block_count + static_cast<std::size_t>(face.block)];
  }
  for (std::size_t i = 0; i < surface.gid.size(); ++i) {
    if (!surface.owns(static_cast<LocalIndex>(i), ranks.rank())) continue;
    const auto body = static_cast<std::size_t>(surface.body[i]);
    const double inverse = nth(inverse_mass, surface.model_node[i]);
    ++counts[body_count + body];
    if (inverse > 0)
      sums[body_count + body].add(1 / inverse);
    else
      ++counts[2 * body_count + body];
  }
  std::vector<double> totals(sums.size());
  comm::exact_sum(ranks, sums, totals);
  ranks.sum(counts);
  ranks.sum(faces_of);
  ranks.max(edges);
  GlobalIndex faces = 0;
  for (std::size_t body = 0; body < body_count; ++body) {
    const double mass = mean(totals[body_count + body], counts[body_count + body]);
    const bool held = counts[2 * body_count + body] > 0;
    surface.bodies.push_back({mean(totals[body], counts[body]),
                              held ? std::numeric_limits<double>::infinity() : mass,
                              {},
                              edges[2 * body],
                              -edges[2 * body + 1]});
    for (std::size_t block = 0; block < block_count; ++block)
      if (faces_of[body * block_count + block] > 0)
        surface.bodies.back().blocks.push_back(static_cast<std::int32_t>(block));
    faces += counts[body];
  }
  surface.mean_edge = mean(totals[2 * body_count], faces);
  surface.mean_element_depth = mean(totals[2 * body_count + 1], faces);
}

Surface join(const comm::Communicator& ranks, const mesh::LocalMesh& mesh, const Outside& outside,
             std::span<const double> inverse_mass, const Tolerances& tolerances) {
  demand(outside.excluded.size() == outside.faces.size(), "one exclusion flag for each exterior face");
  demand(inverse_mass.size() == mesh.node_gid.size(), "one inverse mass for each node");
  Surface surface;
  const std::vector<NodeUse> uses = uses_of_owned_nodes(ranks, mesh, outside);
  collect_nodes(ranks, mesh, uses, surface);
  attach_faces(uses, surface);
  collect_faces(mesh, outside, surface);
  measure_bodies(ranks, mesh, inverse_mass, surface);
  surface.neighbours = element_neighbours(ranks, mesh, surface, outside.alive);
  surface.edges = edges_of(ranks, mesh, surface, edge_angles(tolerances));
  surface.on_rim = nodes_on_rims(ranks, surface);
  find_seams(ranks, mesh, tolerances, surface);
  return surface;
}

}  // namespace

Surface join_surface(const comm::Communicator& ranks, const mesh::LocalMesh& mesh, std::span<const char> excluded,
                     std::span<const double> inverse_mass, const Tolerances& tolerances) {
  return join(ranks, mesh, {.faces = mesh.faces, .excluded = excluded}, inverse_mass, tolerances);
}

Surface join_surface(const comm::Communicator& ranks, const mesh::LocalMesh& mesh, const Remains& remains,
                     std::span<const double> inverse_mass, const Tolerances& tolerances) {
  return join(ranks, mesh, {remains.outside.faces, remains.excluded, remains.outside.points, remains.alive},
              inverse_mass, tolerances);
}

}  // namespace brunt::contact
