// SPDX-License-Identifier: Apache-2.0
#include "contact/joined/seams.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <utility>

#include "comm/rendezvous.hpp"
#include "contact/data/tolerances.hpp"
#include "contact/detection/seams.hpp"
#include "contact/joined/join_neighbours.hpp"
#include "contact/lists/ghosting.hpp"
#include "contact/search/search.hpp"
#include "core/error.hpp"
#include "core/sorted.hpp"
#include "geometry/closest_point.hpp"

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
  [[nodiscard]] std::size_t next(std::size_t corner) const {
    return (corner + 1) % static_cast<std::size_t>(corner_count);
  }
  [[nodiscard]] Vec3 normal() const {
    const std::array<Vec3, 4> at = places();
    return geometry::area_vector({at.data(), static_cast<std::size_t>(corner_count)}).normalized();
  }
  [[nodiscard]] Vec3 along(std::size_t side) const {
    return (Vec3(corners[next(side)].data()) - Vec3(corners[side].data())).normalized();
  }
  /// Out of the face across one of its sides.
  [[nodiscard]] Vec3 out(std::size_t side) const { return along(side).cross(normal()).normalized(); }
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
    corners[i] = nth(mesh.coordinates, surface.model_node[node]);
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

std::vector<StartFace> start_faces(const mesh::LocalMesh& mesh, const Surface& surface, const Tolerances& tolerances) {
  std::vector<StartFace> faces;
  for (const SurfaceFace& face : surface.faces) faces.push_back(start_face(mesh, surface, face, tolerances));
  return faces;
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
    const Vec3 normal = faces[f].normal();
    for (std::size_t i = 0; i < count; ++i) {
      const std::size_t next = faces[f].next(i);
      const auto on_rim = [&](std::size_t c) { return nth(surface.on_rim, surface.faces[f].nodes[c]) != 0; };
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
  if (!same_direction(other.normal(), side.normal, tolerances.same_direction)) return false;
  const auto closest = geometry::closest_point(point, view);
  return closest && (point - closest->point).norm() <= std::min(own.margin, other.margin);
}

/// Marks sides of this rank's faces; returns the pairs of bodies that meet there. Collective.
std::vector<BodyPair> mark_sides(const comm::Communicator& ranks, const mesh::LocalMesh& mesh,
                                 const Tolerances& tolerances, Surface& surface) {
  std::vector<StartFace> faces = start_faces(mesh, surface, tolerances);
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
      const StartFace &own = faces[sides[p].face], &other = nth(faces, f);
      if (!continues(own, sides[p], points[p], other, tolerances)) continue;
      surface.faces[sides[p].face].seams |= static_cast<std::uint8_t>(1U << sides[p].side);
      flush.emplace_back(std::minmax(own.body, other.body));
    }
  return flush;
}

/// A face that goes on beyond a side that ends in the node; the face is of the rank that says so.
struct SeamOfNode {
  LocalIndex node = 0, face = 0;
  double sag = 0;                         ///< [length]
  std::array<double, 3> normal{}, out{};  ///< of the face; where it goes on, in its plane
};

/// A side of a face that ends in a node.
struct EndAtNode {
  LocalIndex node = 0;                      ///< of its owner
  std::array<double, 3> normal{}, along{};  ///< of the face; of the side, away from the node
};

/// An edge, the lower gid first, as a side of one of its faces.
struct SideOfFace {
  std::array<GlobalIndex, 2> edge{};
  Place face;
  friend auto operator<=>(const SideOfFace&, const SideOfFace&) = default;
};

/// What seams make of it.
struct SideAtSeam {
  SideOfFace side;
  bool seam = false;                  ///< another face goes on beyond it
  std::array<bool, 2> end_at_side{};  ///< the face is there the side of a seam that goes by, see SurfaceEdge
};

std::array<double, 3> as_array(const Vec3& v) {
  return {v[0], v[1], v[2]};
}

/// The owners of nodes learn which faces go on beyond sides that end there. Collective.
Ragged<SeamOfNode> report_seams(const comm::Communicator& ranks, const Surface& surface,
                                std::span<const StartFace> faces) {
  std::vector<std::vector<SeamOfNode>> nodes(static_cast<std::size_t>(ranks.size()));
  for (std::size_t f = 0; f < faces.size(); ++f)
    for (std::size_t side = 0; side < 4; ++side) {
      if ((surface.faces[f].seams >> side & 1U) == 0) continue;
      for (const std::size_t end : {side, faces[f].next(side)}) {
        const Place& home = nth(surface.home, surface.faces[f].nodes[end]);
        nth(nodes, home.rank)
            .push_back({home.index, static_cast<LocalIndex>(f), faces[f].sag, as_array(faces[f].normal()),
                        as_array(faces[f].out(side))});
      }
    }
  return comm::exchange(ranks, nodes);
}

std::vector<SeamOfNode> by_node(const Ragged<SeamOfNode>& received) {
  std::vector<SeamOfNode> known(received.values);
  std::ranges::stable_sort(known, {}, &SeamOfNode::node);
  return known;
}

/// The faces that go on at a node. One that is itself the side of a seam there is none: of tiles that lie flush, four
/// in a point, the faces between them continue in each other too, but what slides over the tiles does not slide on
/// these.
void mark_nodes(const Ragged<SeamOfNode>& received, const Tolerances& tolerances, Surface& surface) {
  surface.seam_sag.assign(surface.facets.values.size(), 0);
  const std::vector<SeamOfNode> known = by_node(received);
  for (Rank rank = 0; rank < received.rows(); ++rank)
    for (const SeamOfNode& seam : received.row(rank)) {
      const std::span<const Place> facets = std::as_const(surface.facets).row(seam.node);
      const auto at = std::ranges::find(facets, Place{rank, seam.face});
      demand(at != facets.end(), "a node's owner knows its faces");
      const auto goes_by = [&](const SeamOfNode& other) {
        return Vec3(other.out.data()).dot(Vec3(seam.normal.data())) > tolerances.facing;
      };
      if (std::ranges::any_of(equal_part(known, seam.node, &SeamOfNode::node), goes_by)) continue;
      nth(surface.seam_sag, &*at - surface.facets.values.data()) = seam.sag;
    }
}

/// Does the seam go by, and go on over the face whose side ends there?
bool ends_at_side(const SeamOfNode& seam, const EndAtNode& end, const Tolerances& tolerances) {
  return Vec3(seam.out.data()).dot(Vec3(end.normal.data())) > tolerances.facing &&
         Vec3(seam.normal.data()).dot(Vec3(end.along.data())) < -tolerances.slight;
}

/// Sides of this rank's faces that are at seams, or end there: for that they ask the owners of their ends. For each
/// rank, those of which the lower node is its own. Collective.
std::vector<std::vector<SideAtSeam>> find_sides_at_seams(const comm::Communicator& ranks, const Surface& surface,
                                                         std::span<const StartFace> faces,
                                                         const Ragged<SeamOfNode>& received,
                                                         const Tolerances& tolerances) {
  const auto count = static_cast<std::size_t>(ranks.size());
  const auto each_end = [&](auto&& visit) {
    for (std::size_t f = 0; f < faces.size(); ++f)
      for (std::size_t side = 0; side < static_cast<std::size_t>(faces[f].corner_count); ++side)
        for (const bool second : {false, true}) {
          const LocalIndex node = surface.faces[f].nodes[second ? faces[f].next(side) : side];
          if (nth(surface.on_rim, node) != 0) visit(f, side, second, nth(surface.home, node));
        }
  };
  std::vector<std::vector<EndAtNode>> asked(count);
  each_end([&](std::size_t f, std::size_t side, bool second, const Place& home) {
    const Vec3 along = (second ? -1 : 1) * faces[f].along(side);
    nth(asked, home.rank).push_back({home.index, as_array(faces[f].normal()), as_array(along)});
  });
  const Ragged<EndAtNode> questions = comm::exchange(ranks, asked);
  const std::vector<SeamOfNode> known = by_node(received);
  std::vector<std::vector<char>> answers(count);
  for (std::size_t r = 0; r < count; ++r)
    for (const EndAtNode& end : questions.row(static_cast<LocalIndex>(r))) {
      const auto here = equal_part(known, end.node, &SeamOfNode::node);
      const auto is_side = [&](const SeamOfNode& seam) { return ends_at_side(seam, end, tolerances); };
      answers[r].push_back(std::ranges::any_of(here, is_side) ? 1 : 0);
    }
  const Ragged<char> replies = comm::exchange(ranks, answers);
  std::vector<std::array<std::array<bool, 2>, 4>> at_side(faces.size());
  std::vector<std::size_t> next(count, 0);
  each_end([&](std::size_t f, std::size_t side, bool second, const Place& home) {
    at_side[f][side][second ? 1 : 0] = replies.row(home.rank)[nth(next, home.rank)++] != 0;
  });
  std::vector<std::vector<SideAtSeam>> sides(count);
  for (std::size_t f = 0; f < faces.size(); ++f)
    for (std::size_t side = 0; side < static_cast<std::size_t>(faces[f].corner_count); ++side) {
      SideAtSeam found;
      found.seam = (surface.faces[f].seams >> side & 1U) != 0;
      found.end_at_side = at_side[f][side];
      if (!found.seam && !found.end_at_side[0] && !found.end_at_side[1]) continue;
      std::size_t low = side, high = faces[f].next(side);
      if (faces[f].gid[high] < faces[f].gid[low]) {
        std::swap(low, high);
        std::swap(found.end_at_side[0], found.end_at_side[1]);
      }
      found.side = {{faces[f].gid[low], faces[f].gid[high]}, {ranks.rank(), static_cast<LocalIndex>(f)}};
      const Place& home = nth(surface.home, surface.faces[f].nodes[low]);
      nth(sides, home.rank).push_back(found);
    }
  return sides;
}

/// Faces tell the owners of the lower nodes of their sides, edges ask there. Collective.
void mark_edges(const comm::Communicator& ranks, const std::vector<std::vector<SideAtSeam>>& sides, Surface& surface) {
  const auto count = static_cast<std::size_t>(ranks.size());
  std::vector<SideAtSeam> known = comm::exchange(ranks, sides).values;
  std::ranges::sort(known, {}, &SideAtSeam::side);
  std::vector<std::vector<SideOfFace>> asked(count);
  const auto asks = [&](const SurfaceEdge& edge) {
    return static_cast<std::size_t>(nth(surface.home, edge.nodes[0]).rank);
  };
  for (const SurfaceEdge& edge : surface.edges)
    for (const Place& facet : edge.facets)
      asked[asks(edge)].push_back({{nth(surface.gid, edge.nodes[0]), nth(surface.gid, edge.nodes[1])}, facet});
  const Ragged<SideOfFace> questions = comm::exchange(ranks, asked);
  std::vector<std::vector<SideAtSeam>> answers(count);
  for (std::size_t r = 0; r < count; ++r)
    for (const SideOfFace& question : questions.row(static_cast<LocalIndex>(r))) {
      const auto found = std::ranges::lower_bound(known, question, {}, &SideAtSeam::side);
      answers[r].push_back(found != known.end() && found->side == question ? *found : SideAtSeam{});
    }
  const Ragged<SideAtSeam> received = comm::exchange(ranks, answers);
  std::vector<std::size_t> next(count, 0);
  for (SurfaceEdge& edge : surface.edges)
    for (std::size_t k = 0; k < 2; ++k) {
      const SideAtSeam& side = received.row(static_cast<LocalIndex>(asks(edge)))[next[asks(edge)]++];
      edge.seam[k] = side.seam;
      for (std::size_t end = 0; end < 2; ++end) edge.end_at_side[end][k] = side.end_at_side[end];
    }
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
  const std::vector<StartFace> faces = start_faces(mesh, surface, tolerances);
  const Ragged<SeamOfNode> received = report_seams(ranks, surface, faces);
  mark_nodes(received, tolerances, surface);
  mark_edges(ranks, find_sides_at_seams(ranks, surface, faces, received, tolerances), surface);
}

}  // namespace brunt::contact
