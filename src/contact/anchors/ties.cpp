// SPDX-License-Identifier: Apache-2.0
#include "contact/anchors/ties.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <algorithm>
#include <limits>

#include "contact/anchors/anchors.hpp"
#include "contact/data/tolerances.hpp"
#include "core/cross_matrix.hpp"
#include "core/error.hpp"
#include "geometry/closest_point.hpp"
#include "geometry/face_weights.hpp"

namespace brunt::contact {
namespace {

using geometry::middle_of;
using FaceCorners = std::array<Vec3, 4>;

std::span<const Vec3> corners_of(const MasterFace& face, std::span<const NodeMotion> motion, FaceCorners& storage) {
  const auto count = static_cast<std::size_t>(face.corner_count);
  for (std::size_t i = 0; i < count; ++i) storage[i] = nth(motion, face.nodes[i]).position;
  return {storage.data(), count};
}

/// Unit, along the area vector.
Vec3 normal_of(std::span<const Vec3> corners) {
  return geometry::area_vector(corners).normalized();
}

/// From the point that the weights name to the slave.
Vec3 offset_of(const Vec3& slave, std::span<const Vec3> corners, const std::array<double, 4>& weights) {
  Vec3 offset = slave;
  for (std::size_t i = 0; i < corners.size(); ++i) offset -= weights[i] * corners[i];
  return offset;
}

/// Do the slave's own faces look at one with this normal, one of them or all together (at the edge of a wedge) by 60
/// degrees or less? Nodes on the side of a part whose end is tied do not, nor do those that hang over a rim.
bool looks_at(std::span<const LocalIndex> facets, std::span<const Vec3> facet_area, const Vec3& normal,
              const Tolerances& tolerances) {
  const auto is_opposed = [&](const Vec3& area) { return -area.dot(normal) >= tolerances.facing * area.norm(); };
  Vec3 sum = Vec3::Zero();
  double total = 0;
  for (const LocalIndex facet : facets) {
    const Vec3& area = nth(facet_area, facet);
    if (is_opposed(area)) return true;
    sum += area;
    total += area.norm();
  }
  return facets.empty() || (sum.norm() > tolerances.rounding * total && is_opposed(sum));
}

/// The best place of a slave so far.
struct Place {
  double distance = std::numeric_limits<double>::infinity();
  GlobalIndex face = no_index;
  Tie tie;
};

enum class Seen : std::int8_t { nothing, beside, over };

/// Keeps the nearer one of `best` and this face, if that is within reach.
Seen look_at(const MasterFace& face, std::span<const NodeMotion> motion, const Vec3& slave,
             std::span<const LocalIndex> facets, std::span<const Vec3> facet_area, const Tolerances& tolerances,
             Place& best) {
  FaceCorners storage;
  const std::span<const Vec3> corners = corners_of(face, motion, storage);
  const auto closest = geometry::closest_point(slave, corners);
  if (!closest) return Seen::nothing;
  const Vec3 normal = normal_of(corners), offset = slave - closest->point;
  const double size = geometry::longest_edge(corners), over = normal.dot(offset), distance = offset.norm();
  const double reach = tolerances.max_penetration(size, face.element_depth);
  if (std::abs(over) > reach || !looks_at(facets, facet_area, normal, tolerances)) return Seen::nothing;
  const Vec3 across = offset - over * normal;
  if (across.norm() > tolerances.rim * size) return distance <= reach ? Seen::beside : Seen::nothing;
  if (distance > best.distance || (distance == best.distance && face.key > best.face)) return Seen::over;
  best = {distance, face.key, {.face = face.key, .body = face.body, .block = face.block, .weights = closest->weights}};
  if (across.norm() > tolerances.fine_rounding * size)
    geometry::shift_weights(corners, normal, across, best.tie.weights);
  const double height = normal.dot(offset_of(slave, corners, best.tie.weights));
  // the moment of a height that is rounding is nothing
  best.tie.height = std::abs(height) > tolerances.fine_rounding * size ? height : 0.0;
  return Seen::over;
}

/// Place of the slave among the candidates; no_index where it is none.
LocalIndex slave_of(const Tie& tie, const TieScene& scene) {
  const std::vector<LocalIndex>& slaves = scene.candidates.slave;
  const auto gid_of = [&](LocalIndex node) { return nth(scene.gid, node); };
  const auto found = std::ranges::lower_bound(slaves, tie.slave, {}, gid_of);
  if (found == slaves.end() || gid_of(*found) != tie.slave) return no_index;
  return static_cast<LocalIndex>(found - slaves.begin());
}

const MasterFace* face_of(const Tie& tie, const TieScene& scene) {
  return find_face(scene.faces, scene.by_key, tie.face);
}

/// How the offset of a slave turns with the corners. What is along the normal turns with the area vector
/// A = 1/2 sum x_i x x_{i+1}, whose rate is sum c_i x v_i with c_i = (x_{i-1} - x_{i+1}) / 2: the gradient of what the
/// tie keeps. The little that has crept across goes with the corners' mean spin J^-1 sum d_i x v_i.
void lay_arms(const Vec3& offset, std::span<const Vec3> corners, const Row& row, TieArms& arms) {
  const std::size_t count = corners.size();
  const Vec3 &normal = row.normal, middle = middle_of(corners);
  const double height = normal.dot(offset);
  const Mat3 tilt = height / geometry::area_vector(corners).norm() * (Mat3::Identity() - normal * normal.transpose());
  Mat3 inertia = Mat3::Zero();
  for (const Vec3& corner : corners) {
    const Mat3 arm = cross_matrix(corner - middle);
    inertia += arm.transpose() * arm;
  }
  const Mat3 spin = cross_matrix(offset - height * normal) * inertia.inverse();
  arms = {};
  for (std::size_t i = 0; i < count; ++i) {
    const Vec3 along = 0.5 * (corners[(i + count - 1) % count] - corners[(i + 1) % count]);
    arms[i + 1].turn = spin * cross_matrix(corners[i] - middle) - tilt * cross_matrix(along);
    arms[i + 1].size = arms[i + 1].turn.norm();
  }
}

/// What of the place that a tie keeps would be lost within a step at the velocities before it, though its rates are
/// kept: the pin turns [length]. Asked back beforehand, since a pin that is longer whenever it pulls does work.
Vec3 lost_in_turning(const Tie& tie, const Vec3& crept, const Row& row, const MasterFace& face, const TieScene& scene) {
  const auto old_velocity = [&](LocalIndex node) -> const Vec3& { return nth(scene.motion, node).old_velocity; };
  const auto place_after = [&](LocalIndex node) -> Vec3 {
    return nth(scene.motion, node).position + scene.dt * old_velocity(node);
  };
  FaceCorners storage;
  const auto count = static_cast<std::size_t>(face.corner_count);
  for (std::size_t i = 0; i < count; ++i) storage[i] = place_after(face.nodes[i]);
  const std::span<const Vec3> corners(storage.data(), count);
  const Vec3 after = offset_of(place_after(row.nodes[0]), corners, tie.weights) - tie.height * normal_of(corners);
  return after - crept - scene.dt * relative_velocity(row, old_velocity);
}

/// Bound of the rounding in a sum of the slave's and the corners' positions with weights of sum 1 and -1 [length]: each
/// position is rounded when X + u is made, and so is each of at most six partial sums, by half an epsilon of the
/// largest coordinate or less; weights a little beside a face take no more than twice that.
double rounding_of_positions(const Row& row, std::span<const NodeMotion> motion) {
  constexpr double roundings = 2 * (2 + 6) * 0.5;
  double largest = 0;
  for (std::size_t i = 0; i < static_cast<std::size_t>(row.node_count); ++i)
    largest = std::max(largest, nth(motion, row.nodes[i]).position.cwiseAbs().maxCoeff());
  return roundings * std::numeric_limits<double>::epsilon() * largest;
}

Row row_of(const Tie& tie, LocalIndex candidate, const MasterFace& face, const TieScene& scene, TieArms& arms) {
  FaceCorners storage;
  const std::span<const Vec3> corners = corners_of(face, scene.motion, storage);
  const LocalIndex slave = nth(scene.candidates.slave, candidate);
  Row row{.key = {.kind = RowKind::tie, .slave = tie.slave, .master = face.key},
          .slave_body = nth(scene.candidates.body, candidate),
          .master_body = face.body,
          .master_block = face.block};
  row.nodes[0] = slave;
  row.weights[0] = 1;
  row.node_count = 1;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    if (tie.height == 0 && tie.weights[i] == 0) continue;
    const auto k = static_cast<std::size_t>(row.node_count++);
    row.nodes[k] = face.nodes[i];
    row.weights[k] = -tie.weights[i];
  }
  row.normal = normal_of(corners);
  row.cone = Cone::free;
  row.holds = true;
  const Vec3 offset = offset_of(nth(scene.motion, slave).position, corners, tie.weights);
  if (tie.height != 0) {
    lay_arms(offset, corners, row, arms);
    row.arms = std::span<const Arm>(arms).first(static_cast<std::size_t>(row.node_count));
  }
  const Vec3 crept = offset - tie.height * row.normal;
  row.gap = row.normal.dot(crept);
  Vec3 back = -scene.recovery / scene.dt * crept;
  if (tie.height != 0) back -= lost_in_turning(tie, crept, row, face, scene) / scene.dt;
  row.noise = (scene.recovery + (tie.height != 0 ? 1 : 0)) / scene.dt * rounding_of_positions(row, scene.motion);
  row.required = row.normal.dot(back);
  row.drift = back - row.required * row.normal;
  return row;
}

/// Projector onto the directions in which an impulse can move a point of the body.
Mat3 free_directions(const Carrier& body, const Vec3& position) {
  constexpr double nothing = Mobility::rounding * Mobility::rounding;
  Eigen::SelfAdjointEigenSolver<Mat3> directions;
  directions.computeDirect(answer_at(body, position));
  Mat3 free = Mat3::Zero();
  for (int k = 0; k < 3; ++k)
    if (directions.eigenvalues()[k] > nothing * directions.eigenvalues()[2])
      free += directions.eigenvectors().col(k) * directions.eigenvectors().col(k).transpose();
  return free;
}

/// G P of the i-th node of the row: how its velocity enters the rate, along the directions that are free to it.
Mat3 free_part(const Row& row, std::size_t i, const Mat3& free) {
  Mat3 part = row.shares()[i] * free;
  if (!row.arms.empty()) part += row.arms[i].turn * free;
  return part;
}

/// Projector onto the directions in which nothing can change the row's rate: the null space of sum G P (G P)^T. A share
/// of Mobility::rounding of the largest is no motion, as elsewhere.
Mat3 held_directions(const Row& row, std::span<const Mobility> mobility, std::span<const NodeMotion> motion,
                     const Carriers& carriers) {
  Mat3 sum = Mat3::Zero();
  for (std::size_t i = 0; i < row.points().size(); ++i) {
    const LocalIndex point = row.points()[i];
    const Mobility& node = nth(mobility, point);
    const Carrier* body = carriers.of(point);
    if (node.inverse_mass == 0 && body == nullptr) continue;
    const Vec3& place = nth(motion, point).position;
    const Mat3 part = free_part(row, i, body != nullptr ? free_directions(*body, place) : node.projector);
    sum += part * part.transpose();
  }
  Eigen::SelfAdjointEigenSolver<Mat3> directions;
  directions.computeDirect(sum);
  Mat3 held = Mat3::Zero();
  constexpr double nothing = Mobility::rounding * Mobility::rounding;
  const double squared_share = largest_share(row) * largest_share(row);
  for (int k = 0; k < 3; ++k)
    if (directions.eigenvalues()[k] <= nothing * squared_share)
      held += directions.eigenvectors().col(k) * directions.eigenvectors().col(k).transpose();
  return held;
}

}  // namespace

void keep_feasible_rate(Row& row, std::span<const Mobility> mobility, std::span<const NodeMotion> motion,
                        const Carriers& carriers) {
  const Mobility& slave = nth(mobility, row.nodes[0]);
  if (slave.is_free() && slave.inverse_mass > 0) return;  // it can follow any rate
  const Mat3 held = held_directions(row, mobility, motion, carriers);
  if (held.isZero(0)) return;
  const Vec3 asked = row.required * row.normal + row.drift;
  const Vec3 predicted =
      relative_velocity(row, [&](LocalIndex node) -> const Vec3& { return nth(motion, node).predicted; });
  const Vec3 left = asked + held * (predicted - asked);
  row.required = row.normal.dot(left);
  row.drift = left - row.required * row.normal;
}

std::vector<Tie> find_ties(const Candidates& candidates, std::span<const MasterFace> faces,
                           std::span<const GlobalIndex> gid, std::span<const NodeMotion> motion,
                           std::span<const Vec3> facet_area, const Tolerances& tolerances,
                           const std::function<bool(LocalIndex, LocalIndex)>& may_tie,
                           const std::function<void(LocalIndex, LocalIndex)>& beside) {
  std::vector<Tie> ties;
  for (LocalIndex s = 0; s < static_cast<LocalIndex>(candidates.slave.size()); ++s) {
    const LocalIndex slave = nth(candidates.slave, s);
    const std::span<const LocalIndex> facets =
        s < candidates.slave_facets.rows() ? candidates.slave_facets.row(s) : std::span<const LocalIndex>{};
    Place best;
    LocalIndex passed = no_index;
    for (const LocalIndex f : candidates.faces.row(s)) {
      if (!may_tie(slave, f)) continue;
      const Vec3& place = nth(motion, slave).position;
      if (look_at(nth(faces, f), motion, place, facets, facet_area, tolerances, best) == Seen::beside) passed = f;
    }
    if (best.face == no_index) {
      if (passed != no_index) beside(slave, passed);
      continue;
    }
    best.tie.slave = nth(gid, slave);
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

void tie_rows(std::span<const Tie> ties, const TieScene& scene, std::span<TieArms> arms, std::vector<Row>& rows) {
  demand(arms.size() == ties.size(), "room for the arms of each tie");
  for (std::size_t t = 0; t < ties.size(); ++t) {
    const LocalIndex slave = slave_of(ties[t], scene);
    const MasterFace* face = face_of(ties[t], scene);
    demand(slave != no_index && face != nullptr, "the lists hold the face of a tie and its slave");
    rows.push_back(row_of(ties[t], slave, *face, scene, arms[t]));
  }
}

}  // namespace brunt::contact
