// SPDX-License-Identifier: Apache-2.0
#include "brunt/contact/seams.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <utility>

#include "brunt/comm/rendezvous.hpp"
#include "brunt/contact/data/tolerances.hpp"
#include "brunt/contact/detection/seams.hpp"
#include "brunt/contact/ghosting.hpp"
#include "brunt/contact/join_neighbours.hpp"
#include "brunt/contact/search/search.hpp"
#include "brunt/core/error.hpp"
#include "brunt/geometry/closest_point.hpp"

namespace brunt::contact {
namespace {

/// A face with its corners where they are at the start.
struct StartFace {
  GlobalIndex key = 0;
  std::array<GlobalIndex, 4> gid{};
  std::array<std::array<double, 3>, 4> corners{};
  std::int32_t corner_count = 4, body = 0;
  double margin = 0;  ///< how far from the face a point may be to lie on it [length]
  double sag = 0;     ///< of a seam at one of its sides [length]
  PlainBox capture{};

  [[nodiscard]] std::array<Vec3, 4> places() const {
    std::array<Vec3, 4> places;
    for (std::size_t i = 0; i < 4; ++i) places[i] = Vec3(corners[i].data());
    return places;
  }
  friend bool operator<(const StartFace& a, const StartFace& b) { return a.key < b.key; }
};

StartFace start_face(const mesh::LocalMesh& mesh, const Surface& surface, const SurfaceFace& from,
                     const Tolerances& tolerances) {
  StartFace face{.key = from.key, .corner_count = from.corner_count, .body = from.body};
  face.gid.fill(no_index);
  const auto count = static_cast<std::size_t>(from.corner_count);
  std::array<Vec3, 4> corners;
  for (std::size_t i = 0; i < count; ++i) {
    const auto node = static_cast<std::size_t>(from.nodes[i]);
    corners[i] = mesh.coordinates[static_cast<std::size_t>(surface.model_node[node])];
    face.corners[i] = {corners[i][0], corners[i][1], corners[i][2]};
    face.gid[i] = surface.gid[node];
  }
  const geometry::Corners view(corners.data(), count);
  const double edge = geometry::longest_edge(view);
  face.sag = tolerances.max_penetration(edge, from.element_depth);
  face.margin = tolerances.seam_reach * std::min(edge, 2 * from.element_depth);
  face.capture = PlainBox(geometry::grown(geometry::bounding_box(view), face.margin));
  return face;
}

/// A point beyond a side of a face.
struct Beyond {
  std::size_t face = 0, side = 0;  ///< of surface.faces
  Vec3 normal = Vec3::Zero();      ///< of the face
};

/// Sides of which both ends stand on rims: two points beyond each.
void look_beyond(const Surface& surface, std::span<const StartFace> faces, const Tolerances& tolerances,
                 std::vector<Beyond>& sides, std::vector<Vec3>& points) {
  for (std::size_t f = 0; f < faces.size(); ++f) {
    const auto count = static_cast<std::size_t>(faces[f].corner_count);
    const std::array<Vec3, 4> corners = faces[f].places();
    const Vec3 normal = geometry::area_vector({corners.data(), count}).normalized();
    for (std::size_t i = 0; i < count; ++i) {
      const std::size_t next = (i + 1) % count;
      const auto on_rim = [&](std::size_t c) {
        return surface.on_rim[static_cast<std::size_t>(surface.faces[f].nodes[c])] != 0;
      };
      if (!on_rim(i) || !on_rim(next)) continue;
      const Vec3 side = corners[next] - corners[i], out = side.cross(normal).normalized();
      for (const double share : {tolerances.seam_sample, 1 - tolerances.seam_sample}) {
        sides.push_back({f, i, normal});
        points.push_back(corners[i] + share * side + faces[f].margin * out);
      }
    }
  }
}

bool continues(const StartFace& own, const Beyond& side, const Vec3& point, const StartFace& other,
               const Tolerances& tolerances) {
  for (const GlobalIndex gid : own.gid)
    if (gid != no_index && std::ranges::find(other.gid, gid) != other.gid.end()) return false;
  const auto count = static_cast<std::size_t>(other.corner_count);
  const std::array<Vec3, 4> corners = other.places();
  const geometry::Corners view(corners.data(), count);
  const Vec3 normal = geometry::area_vector(view).normalized();
  if (!same_direction(normal, side.normal, tolerances.same_direction)) return false;
  const auto closest = geometry::closest_point(point, view);
  return closest && (point - closest->point).norm() <= std::min(own.margin, other.margin);
}

/// Marks sides of this rank's faces; returns the pairs of bodies that meet there. Collective.
std::vector<BodyPair> mark_sides(const comm::Communicator& ranks, const mesh::LocalMesh& mesh,
                                 const Tolerances& tolerances, Surface& surface) {
  std::vector<StartFace> faces;
  for (const SurfaceFace& face : surface.faces) faces.push_back(start_face(mesh, surface, face, tolerances));
  std::vector<Beyond> sides;
  std::vector<Vec3> points;
  look_beyond(surface, faces, tolerances, sides, points);
  std::vector<geometry::Box> wanted, boxes;
  for (const Vec3& point : points) wanted.push_back({point, point});
  const std::vector<StartFace> ghosts = ghost(ranks, std::span<const StartFace>(faces), wanted, 2 * surface.mean_edge);
  faces.insert(faces.end(), ghosts.begin(), ghosts.end());
  for (const StartFace& face : faces) boxes.push_back(face.capture.box());
  SearchScratch scratch;
  Ragged<LocalIndex> found;
  find_pairs(boxes, points, scratch, found);
  std::vector<BodyPair> flush;
  for (std::size_t p = 0; p < points.size(); ++p)
    for (const LocalIndex f : std::as_const(found).row(static_cast<LocalIndex>(p))) {
      const StartFace &own = faces[sides[p].face], &other = faces[static_cast<std::size_t>(f)];
      if (!continues(own, sides[p], points[p], other, tolerances)) continue;
      surface.faces[sides[p].face].seams |= static_cast<std::uint8_t>(1U << sides[p].side);
      flush.emplace_back(std::minmax(own.body, other.body));
    }
  return flush;
}

void sort_unique(std::vector<BodyPair>& pairs) {
  std::ranges::sort(pairs);
  pairs.erase(std::ranges::unique(pairs).begin(), pairs.end());
}

/// A face beyond whose edge another one goes on. The edge by its nodes, the lower gid first.
struct SeamOfFace {
  std::array<GlobalIndex, 2> edge{};
  Place face;
  friend auto operator<=>(const SeamOfFace&, const SeamOfFace&) = default;
};

/// A face that goes on beyond a side that ends in the node; the face is of the rank that says so.
struct SeamOfNode {
  LocalIndex node = 0, face = 0;
  double sag = 0;  ///< [length]
  std::array<double, 3> normal{};
};

/// Is it in the side of a seam that something with this normal ends in the node?
struct EndAtNode {
  LocalIndex node = 0;  ///< of its owner
  std::array<double, 3> normal{};
};

/// What the faces of all ranks say, at the owners of nodes: those of the node, and those of which it is the lower end.
struct ReceivedSeams {
  Ragged<SeamOfNode> nodes;
  std::vector<SeamOfFace> edges;  ///< ascending
};

std::array<double, 3> normal_of(const mesh::LocalMesh& mesh, const Surface& surface, const SurfaceFace& face,
                                const Tolerances& tolerances) {
  const std::array<Vec3, 4> corners = start_face(mesh, surface, face, tolerances).places();
  const Vec3 normal = geometry::area_vector({corners.data(), static_cast<std::size_t>(face.corner_count)}).normalized();
  return {normal[0], normal[1], normal[2]};
}

/// Collective.
ReceivedSeams report_to_owners(const comm::Communicator& ranks, const mesh::LocalMesh& mesh, const Surface& surface,
                               const Tolerances& tolerances) {
  const auto count = static_cast<std::size_t>(ranks.size());
  std::vector<std::vector<SeamOfNode>> nodes(count);
  std::vector<std::vector<SeamOfFace>> edges(count);
  for (std::size_t f = 0; f < surface.faces.size(); ++f)
    for (std::size_t side = 0; side < 4; ++side) {
      const SurfaceFace& face = surface.faces[f];
      if ((face.seams >> side & 1U) == 0) continue;
      const auto corners = static_cast<std::size_t>(face.corner_count);
      const double sag = start_face(mesh, surface, face, tolerances).sag;
      LocalIndex low = face.nodes[side], high = face.nodes[(side + 1) % corners];
      if (surface.gid[static_cast<std::size_t>(high)] < surface.gid[static_cast<std::size_t>(low)])
        std::swap(low, high);
      const std::array<double, 3> normal = normal_of(mesh, surface, face, tolerances);
      for (const LocalIndex node : {low, high}) {
        const Place& home = surface.home[static_cast<std::size_t>(node)];
        nodes[static_cast<std::size_t>(home.rank)].push_back({home.index, static_cast<LocalIndex>(f), sag, normal});
      }
      edges[static_cast<std::size_t>(surface.home[static_cast<std::size_t>(low)].rank)].push_back(
          {{surface.gid[static_cast<std::size_t>(low)], surface.gid[static_cast<std::size_t>(high)]},
           {ranks.rank(), static_cast<LocalIndex>(f)}});
    }
  ReceivedSeams received{comm::exchange(ranks, nodes), comm::exchange(ranks, edges).values};
  std::ranges::sort(received.edges);
  return received;
}

void mark_nodes(const Ragged<SeamOfNode>& received, Surface& surface) {
  surface.seam_sag.assign(surface.facets.values.size(), 0);
  for (Rank rank = 0; rank < received.rows(); ++rank)
    for (const auto& [node, face, sag, normal] : received.row(rank)) {
      const std::span<const Place> facets = std::as_const(surface.facets).row(node);
      const auto at = std::ranges::find(facets, Place{rank, face});
      demand(at != facets.end(), "a node's owner knows its faces");
      surface.seam_sag[static_cast<std::size_t>(&*at - surface.facets.values.data())] = sag;
    }
}

/// Edges ask the owner of their lower node. Collective.
void mark_edges(const comm::Communicator& ranks, std::span<const SeamOfFace> known, Surface& surface) {
  const auto count = static_cast<std::size_t>(ranks.size());
  std::vector<std::vector<SeamOfFace>> asked(count);
  const auto asks = [&](const SurfaceEdge& edge) {
    return static_cast<std::size_t>(surface.home[static_cast<std::size_t>(edge.nodes[0])].rank);
  };
  for (const SurfaceEdge& edge : surface.edges)
    for (const Place& facet : edge.facets)
      asked[asks(edge)].push_back(
          {{surface.gid[static_cast<std::size_t>(edge.nodes[0])], surface.gid[static_cast<std::size_t>(edge.nodes[1])]},
           facet});
  const Ragged<SeamOfFace> questions = comm::exchange(ranks, asked);
  std::vector<std::vector<char>> answers(count);
  for (std::size_t r = 0; r < count; ++r)
    for (const SeamOfFace& question : questions.row(static_cast<LocalIndex>(r)))
      answers[r].push_back(std::ranges::binary_search(known, question) ? 1 : 0);
  const Ragged<char> received = comm::exchange(ranks, answers);
  std::vector<std::size_t> next(count, 0);
  for (SurfaceEdge& edge : surface.edges)
    for (bool& seam : edge.seam) seam = received.row(static_cast<LocalIndex>(asks(edge)))[next[asks(edge)]++] != 0;
}

/// Flat edges ask the owners of their ends: they lie in the side of a seam where one goes by there, but not along the
/// edge's own faces. Collective.
void mark_ends(const comm::Communicator& ranks, const mesh::LocalMesh& mesh, const Ragged<SeamOfNode>& received,
               const Tolerances& tolerances, Surface& surface) {
  const auto count = static_cast<std::size_t>(ranks.size());
  std::vector<std::vector<EndAtNode>> asked(count);
  const auto each_end = [&](auto&& visit) {
    for (SurfaceEdge& edge : surface.edges)
      for (std::size_t i = 0; edge.kind == EdgeKind::flat && i < 2; ++i)
        visit(edge, i, surface.home[static_cast<std::size_t>(edge.nodes[i])]);
  };
  each_end([&](const SurfaceEdge& edge, std::size_t, const Place& home) {
    const SurfaceFace& face = surface.faces[static_cast<std::size_t>(edge.facets[0].index)];
    asked[static_cast<std::size_t>(home.rank)].push_back({home.index, normal_of(mesh, surface, face, tolerances)});
  });
  const Ragged<EndAtNode> questions = comm::exchange(ranks, asked);
  std::vector<SeamOfNode> known(received.values);
  std::ranges::stable_sort(known, {}, &SeamOfNode::node);
  std::vector<std::vector<char>> answers(count);
  for (std::size_t r = 0; r < count; ++r)
    for (const auto& [node, normal] : questions.row(static_cast<LocalIndex>(r))) {
      const auto tops = std::ranges::equal_range(known, node, {}, &SeamOfNode::node);
      const bool along = std::ranges::any_of(tops, [&](const SeamOfNode& top) {
        return same_direction(Vec3(normal.data()), Vec3(top.normal.data()), tolerances.same_direction);
      });
      answers[r].push_back(!tops.empty() && !along ? 1 : 0);
    }
  const Ragged<char> replies = comm::exchange(ranks, answers);
  std::vector<std::size_t> next(count, 0);
  each_end([&](SurfaceEdge& edge, std::size_t i, const Place& home) {
    edge.end_on_seam[i] = replies.row(home.rank)[next[static_cast<std::size_t>(home.rank)]++];
  });
}

}  // namespace

void find_seams(const comm::Communicator& ranks, const mesh::LocalMesh& mesh, const Tolerances& tolerances,
                Surface& surface) {
  std::vector<BodyPair> flush = mark_sides(ranks, mesh, tolerances, surface);
  sort_unique(flush);
  std::vector<std::array<std::int32_t, 2>> sent;
  for (const auto& [one, other] : flush) sent.push_back({one, other});
  const std::vector<std::vector<std::array<std::int32_t, 2>>> to_all(static_cast<std::size_t>(ranks.size()), sent);
  for (const auto& [one, other] : comm::exchange(ranks, to_all).values) surface.flush.emplace_back(one, other);
  sort_unique(surface.flush);
  if (surface.flush.empty()) return;
  const ReceivedSeams received = report_to_owners(ranks, mesh, surface, tolerances);
  mark_nodes(received.nodes, surface);
  mark_edges(ranks, received.edges, surface);
  mark_ends(ranks, mesh, received.nodes, tolerances, surface);
}

}  // namespace brunt::contact
