// SPDX-License-Identifier: Apache-2.0
#include "contact/anchors/anchors.hpp"

#include <algorithm>
#include <array>
#include <numeric>

#include "contact/data/tolerances.hpp"
#include "core/error.hpp"
#include "geometry/closest_point.hpp"

namespace brunt::contact {
namespace {

const Wall& wall_of(const AnchorScene& scene, GlobalIndex wall) {
  return nth(scene.walls, wall);
}

/// The face of this key, which mostly is that of the row; null if the lists do not have it.
const MasterFace* face_of(const AnchorScene& scene, const Row& row, GlobalIndex key) {
  if (row.master_face != no_index && key == row.key.master) return &nth(scene.faces, row.master_face);
  return find_face(scene.faces, scene.by_key, key);
}

Vec3 slip_of_edges(const AnchorScene& scene, const AnchorRecord& anchor, const Row& row) {
  Vec3 apart = Vec3::Zero();
  for (std::size_t i = 0; i < 4; ++i) apart += anchor.weights[i] * nth(scene.motion, row.nodes[i]).position;
  return apart;
}

}  // namespace

std::vector<LocalIndex> order_by_key(std::span<const MasterFace> faces) {
  std::vector<LocalIndex> order(faces.size());
  std::iota(order.begin(), order.end(), 0);
  std::ranges::sort(order, {}, [&](LocalIndex face) { return nth(faces, face).key; });
  return order;
}

const MasterFace* find_face(std::span<const MasterFace> faces, std::span<const LocalIndex> by_key, GlobalIndex key) {
  const auto key_of = [&](LocalIndex face) { return nth(faces, face).key; };
  const auto found = std::ranges::lower_bound(by_key, key, {}, key_of);
  return found != by_key.end() && key_of(*found) == key ? &nth(faces, *found) : nullptr;
}

std::optional<Vec3> slip(const AnchorScene& scene, const AnchorRecord& anchor, const Row& row) {
  if (row.is_edge()) return slip_of_edges(scene, anchor, row);
  const Vec3& slave = nth(scene.motion, row.nodes[0]).position;
  if (anchor.key.kind == RowKind::wall)
    return slave - (wall_of(scene, anchor.key.master).point + Vec3(anchor.on_wall.data()));
  const MasterFace* face = face_of(scene, row, anchor.face);
  if (face == nullptr) return std::nullopt;
  std::array<Vec3, 4> corners;
  const auto count = static_cast<std::size_t>(face->corner_count);
  Vec3 point = Vec3::Zero();
  for (std::size_t i = 0; i < count; ++i) {
    corners[i] = nth(scene.motion, face->nodes[i]).position;
    point += anchor.weights[i] * corners[i];
  }
  const Vec3 moved = slave - point;
  const double size = geometry::longest_edge({corners.data(), count});
  const double reach = scene.tolerances->reach(size, face->element_depth) + face->half_thickness;
  if (!(moved.norm() <= reach)) return std::nullopt;
  return moved;
}

std::optional<AnchorRecord> dragged(const AnchorScene& scene, const AnchorRecord& anchor, const Row& row,
                                    const Vec3& slid) {
  if (row.is_edge()) return std::nullopt;
  AnchorRecord moved = anchor;
  if (row.is_wall()) {
    for (std::size_t c = 0; c < 3; ++c) moved.on_wall[c] += slid[static_cast<Eigen::Index>(c)];
    return moved;
  }
  const MasterFace* face = face_of(scene, row, anchor.face);
  if (face == nullptr) return std::nullopt;
  std::array<Vec3, 4> corners;
  const auto count = static_cast<std::size_t>(face->corner_count);
  Vec3 point = slid;
  for (std::size_t i = 0; i < count; ++i) {
    corners[i] = nth(scene.motion, face->nodes[i]).position;
    point += anchor.weights[i] * corners[i];
  }
  const auto closest = geometry::closest_point(point, {corners.data(), count});
  if (!closest || closest->region != geometry::Region::face) return std::nullopt;
  moved.weights = closest->weights;
  return moved;
}

AnchorRecord anchor_of(const AnchorScene& scene, const Row& row) {
  AnchorRecord anchor{.key = anchor_key_of(row)};
  if (row.is_edge()) {
    std::copy_n(row.weights.begin(), 4, anchor.weights.begin());
    return anchor;
  }
  if (row.is_wall()) {
    const Vec3& slave = nth(scene.motion, row.nodes[0]).position;
    const Vec3 place = slave - row.gap * row.normal - wall_of(scene, row.key.master).point;
    anchor.on_wall = {place[0], place[1], place[2]};
    return anchor;
  }
  const MasterFace* face = face_of(scene, row, row.key.master);
  demand(face != nullptr, "the face of a row is in the lists");
  anchor.face = row.key.master;
  for (std::size_t k = 1; k < static_cast<std::size_t>(row.node_count); ++k) {
    const auto corner = std::ranges::find(face->nodes, row.nodes[k]) - face->nodes.begin();
    nth(anchor.weights, corner) = -row.weights[k];
  }
  return anchor;
}

}  // namespace brunt::contact
