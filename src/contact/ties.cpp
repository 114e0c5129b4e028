// SPDX-License-Identifier: Apache-2.0
#include "brunt/contact/ties.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <limits>

#include "brunt/core/error.hpp"
#include "brunt/geometry/closest_point.hpp"

namespace brunt::contact {
namespace {

using FaceCorners = std::array<Vec3, 4>;

std::span<const Vec3> corners_of(const MasterFace& face, std::span<const NodeMotion> motion, FaceCorners& storage) {
  const auto count = static_cast<std::size_t>(face.corner_count);
  for (std::size_t i = 0; i < count; ++i) storage[i] = motion[static_cast<std::size_t>(face.nodes[i])].position;
  return {storage.data(), count};
}

struct Place {
  double distance = std::numeric_limits<double>::infinity();
  GlobalIndex face = no_index;
  Tie tie;
};

/// Keeps the nearer one of `best` and this face, if that is within reach.
constexpr double flush = 1e-3;

void look_at(const MasterFace& face, std::span<const NodeMotion> motion, const Vec3& slave,
             const EncounterSettings& settings, Place& best) {
  FaceCorners storage;
  const std::span<const Vec3> corners = corners_of(face, motion, storage);
  const auto closest = geometry::closest_point(slave, corners);
  if (!closest) return;
  const Vec3 offset = slave - closest->point;
  const double distance = offset.norm(), size = geometry::longest_edge(corners);
  const Mat3 frame = face_frame(corners);
  const double over = std::abs(frame.col(2).dot(offset)),
               beside = std::sqrt(std::max(0.0, distance * distance - over * over));
  if (over > settings.deepest(size, face.depth) || beside > settings.rim * size) return;
  if (distance > best.distance || (distance == best.distance && face.key > best.face)) return;
  best = {distance,
          face.key,
          {.face = face.key,
           .body = face.body,
           .block = face.block,
           .weights = closest->weights,
           .flush = distance <= flush * size,
           .offset = frame.transpose() * offset}};
}

/// Place of the slave among the candidates; no_index where it is none.
LocalIndex slave_of(const Tie& tie, const TieScene& scene) {
  const std::vector<LocalIndex>& slaves = scene.candidates.slave;
  const auto gid_of = [&](LocalIndex node) { return scene.gid[static_cast<std::size_t>(node)]; };
  const auto found = std::ranges::lower_bound(slaves, tie.slave, {}, gid_of);
  if (found == slaves.end() || gid_of(*found) != tie.slave) return no_index;
  return static_cast<LocalIndex>(found - slaves.begin());
}

const MasterFace* face_of(const Tie& tie, const TieScene& scene) {
  const auto key_of = [&](LocalIndex face) { return scene.faces[static_cast<std::size_t>(face)].key; };
  const auto found = std::ranges::lower_bound(scene.by_key, tie.face, {}, key_of);
  return found != scene.by_key.end() && key_of(*found) == tie.face ? &scene.faces[static_cast<std::size_t>(*found)]
                                                                   : nullptr;
}

Row row_of(const Tie& tie, LocalIndex candidate, const MasterFace& face, const TieScene& scene) {
  FaceCorners storage;
  const std::span<const Vec3> corners = corners_of(face, scene.motion, storage);
  const LocalIndex slave = scene.candidates.slave[static_cast<std::size_t>(candidate)];
  Row row{.slave_gid = tie.slave,
          .master_key = face.key,
          .slave_body = scene.candidates.body[static_cast<std::size_t>(candidate)],
          .master_body = face.body,
          .master_block = face.block};
  row.nodes[0] = slave;
  row.weights[0] = 1;
  row.node_count = 1;
  Vec3 crept = scene.motion[static_cast<std::size_t>(slave)].position;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    if (tie.weights[i] == 0) continue;
    const auto k = static_cast<std::size_t>(row.node_count++);
    row.nodes[k] = face.nodes[i];
    row.weights[k] = -tie.weights[i];
    crept -= tie.weights[i] * corners[i];
  }
  const Mat3 frame = face_frame(corners);
  crept -= frame * tie.offset;
  row.normal = frame.col(2);
  row.cone = Cone::free;
  row.friction = std::numeric_limits<double>::infinity();
  row.gap = row.normal.dot(crept);
  const Vec3 back = -scene.recovery / scene.dt * crept;
  row.required = row.normal.dot(back);
  row.drift = back - row.required * row.normal;
  return row;
}

}  // namespace

Mat3 face_frame(std::span<const Vec3> corners) {
  const Vec3 normal = geometry::area_vector(corners).normalized();
  const Vec3 edge = corners[1] - corners[0];
  Mat3 frame;
  frame.col(0) = (edge - normal.dot(edge) * normal).normalized();
  frame.col(1) = normal.cross(frame.col(0));
  frame.col(2) = normal;
  return frame;
}

std::vector<Tie> find_ties(const Candidates& candidates, std::span<const MasterFace> faces,
                           std::span<const GlobalIndex> gid, std::span<const NodeMotion> motion,
                           const EncounterSettings& settings,
                           const std::function<bool(LocalIndex, LocalIndex)>& may_tie) {
  std::vector<Tie> ties;
  for (std::size_t s = 0; s < candidates.slave.size(); ++s) {
    const LocalIndex slave = candidates.slave[s];
    Place best;
    for (const LocalIndex f : candidates.faces.row(static_cast<LocalIndex>(s)))
      if (may_tie(slave, f))
        look_at(faces[static_cast<std::size_t>(f)], motion, motion[static_cast<std::size_t>(slave)].position, settings,
                best);
    if (best.face == no_index) continue;
    best.tie.slave = gid[static_cast<std::size_t>(slave)];
    ties.push_back(best.tie);
  }
  return ties;
}

const Tie* find_tie(std::span<const Tie> ties, GlobalIndex slave, std::int32_t body) {
  const auto found = std::ranges::lower_bound(ties, slave, {}, &Tie::slave);
  return found != ties.end() && found->slave == slave && found->body == body ? &*found : nullptr;
}

bool holds(const Tie& tie, const TieScene& scene) {
  return slave_of(tie, scene) != no_index && face_of(tie, scene) != nullptr;
}

void tie_rows(std::span<const Tie> ties, const TieScene& scene, std::vector<Row>& rows) {
  for (const Tie& tie : ties) {
    const LocalIndex slave = slave_of(tie, scene);
    const MasterFace* face = face_of(tie, scene);
    demand(slave != no_index && face != nullptr, "the lists hold the face of a tie and its slave");
    rows.push_back(row_of(tie, slave, *face, scene));
  }
}

}  // namespace brunt::contact
