// SPDX-License-Identifier: Apache-2.0
#include "candidate_pairs.hpp"

#include <algorithm>
#include <cstring>
#include <utility>

#include "contact/data/tolerances.hpp"
#include "core/simd.hpp"
#include "geometry/closest_point.hpp"

namespace brunt::contact {
namespace {

using geometry::Box;

std::vector<GhostFace> own_master_faces(const ListBuild& build) {
  std::vector<GhostFace> masters;
  for (const SurfaceFace& face : build.surface.faces) {
    if (nth(build.roles.master, face.body) == 0) continue;
    GhostFace master{.key = face.key,
                     .corner_count = face.corner_count,
                     .body = face.body,
                     .block = face.block,
                     .element_depth = face.element_depth,
                     .seams = face.seams,
                     .element = face.element};
    const auto count = static_cast<std::size_t>(face.corner_count);
    std::array<Vec3, 4> corners;
    for (std::size_t i = 0; i < count; ++i) {
      corners[i] = build.position(face.nodes[i]);
      master.gid[i] = nth(build.surface.gid, face.nodes[i]);
      master.home[i] = nth(build.surface.home, face.nodes[i]);
    }
    const double edge = geometry::longest_edge({corners.data(), count});
    master.capture = PlainBox(capture_box(build, {corners.data(), count}, edge, face.element_depth));
    masters.push_back(master);
  }
  return masters;
}

std::vector<LocalIndex> own_slave_nodes(const ListBuild& build) {
  std::vector<LocalIndex> slaves;
  for (LocalIndex node = 0; node < static_cast<LocalIndex>(build.surface.gid.size()); ++node) {
    if (!build.surface.owns(node, build.ranks.rank()) || build.surface.blocks.row(node).empty()) continue;
    const auto i = static_cast<std::size_t>(node), body = static_cast<std::size_t>(build.surface.body[i]);
    if (build.roles.slave[body] != 0 || (build.roles.slave_rims[body] != 0 && build.surface.on_rim[i] != 0))
      slaves.push_back(node);
  }
  return slaves;
}

/// A face of the node's own body whose element touches one of the node's elements.
bool is_neighbour(const Surface& surface, LocalIndex node, const GhostFace& face) {
  static_assert(sizeof(face.element) == sizeof(OctetMask));
  OctetMask corners, found{};  // all eight at once: a search of the row by halves guesses wrong at every turn
  std::memcpy(&corners, face.element.data(), sizeof corners);
  for (const GlobalIndex gid : surface.neighbours.row(node)) found |= corners == gid;
  return any_of_eight(found);
}

bool is_permitted(const ListBuild& build, LocalIndex node, const GhostFace& face) {
  const SurfaceNode slave = build.surface.node(node);
  return may_meet(build.specification, build.surface.bodies, slave, face.block, face.body) &&
         (slave.body != face.body || !is_neighbour(build.surface, node, face));
}

}  // namespace

Box capture_box(const ListBuild& build, std::span<const Vec3> corners, double edge, double element_depth) {
  const double motion = build.settings.motion;
  const double reach =
      build.settings.tolerances->reach(edge + 2 * motion, element_depth) + 2 * motion + build.settings.most_clearance();
  // the criterion of detection is evaluated later and rounds otherwise
  return geometry::grown(geometry::bounding_box(corners), reach * (1 + build.settings.tolerances->rounding));
}

CandidatePairs<GhostFace> find_face_pairs(const ListBuild& build, std::span<const Box> also) {
  CandidatePairs<GhostFace> result{own_master_faces(build), {}};
  const std::vector<LocalIndex> slaves = own_slave_nodes(build);
  std::vector<Vec3> points;
  std::vector<Box> wanted;
  for (const LocalIndex node : slaves) {
    points.push_back(build.position(node));
    wanted.push_back({points.back(), points.back()});
  }
  wanted.insert(wanted.end(), also.begin(), also.end());
  add_ghosts(build, wanted, result.masters);
  const std::vector<Box> boxes = capture_boxes(result.masters);
  Ragged<LocalIndex> found;
  find_pairs_by(build.settings.search, boxes, points, build.scratch.faces, found);
  for (LocalIndex s = 0; s < found.rows(); ++s) {
    const LocalIndex node = nth(slaves, s);
    for (const LocalIndex f : std::as_const(found).row(s))
      if (is_permitted(build, node, nth(result.masters, f))) result.pairs.push_back({node, f});
  }
  std::sort(result.pairs.begin(), result.pairs.end(), [&](const CandidatePair& a, const CandidatePair& b) {
    if (a.slave != b.slave) return a.slave < b.slave;
    const GhostFace &one = nth(result.masters, a.master), &other = nth(result.masters, b.master);
    return one.body != other.body ? one.body < other.body : one.key < other.key;
  });
  return result;
}

}  // namespace brunt::contact
