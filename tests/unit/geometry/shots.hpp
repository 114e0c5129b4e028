// SPDX-License-Identifier: Apache-2.0
// Random moving faces and shots at them that are built backwards from the meeting they must have.
#pragma once
#include <Eigen/Geometry>
#include <array>
#include <random>

#include "geometry/first_contact.hpp"

namespace brunt::geometry::testing {

using Random = std::mt19937;

inline double between(Random& random, double low, double high) {
  return std::uniform_real_distribution<double>(low, high)(random);
}

inline Vec3 random_vector(Random& random, double size) {
  return {between(random, -size, size), between(random, -size, size), between(random, -size, size)};
}

inline Mat3 random_rotation(Random& random, double angle) {
  return Eigen::AngleAxisd(angle, random_vector(random, 1).normalized()).toRotationMatrix();
}

inline const std::array<Vec3, 4> origins{Vec3::Zero(), Vec3::Zero(), Vec3::Zero(), Vec3::Zero()};

struct Quadrilateral {
  std::array<Vec3, 4> start = origins, end = origins;
  std::size_t count = 4;
  [[nodiscard]] MovingFace face() const { return {{start.data(), count}, {end.data(), count}}; }
};

/// A square of side 2 turned anyhow, its corners shifted by up to `warp`; over the step it turns by up to `turn` and
/// moves by up to `shift`.
inline Quadrilateral random_face(Random& random, std::size_t count, double warp, double turn, double shift) {
  Quadrilateral q;
  q.count = count;
  q.start = {Vec3(-1, -1, 0), Vec3(1, -1, 0), Vec3(1, 1, 0), Vec3(-1, 1, 0)};
  const Mat3 placed = random_rotation(random, between(random, 0, 3)), turned = random_rotation(random, turn);
  const Vec3 move = random_vector(random, shift);
  for (std::size_t k = 0; k < 4; ++k) {
    q.start[k] = placed * (q.start[k] + random_vector(random, warp));
    q.end[k] = turned * q.start[k] + move + random_vector(random, 0.3 * warp);
  }
  return q;
}

inline std::array<Vec3, 4> corners_at(const MovingFace& face, double tau) {
  std::array<Vec3, 4> at = origins;
  for (std::size_t k = 0; k < face.start.size(); ++k) at[k] = (1 - tau) * face.start[k] + tau * face.end[k];
  return at;
}

inline Vec3 point_at(Corners corners, double xi, double eta) {
  const auto weights = face_weights(corners.size(), xi, eta);
  Vec3 point = Vec3::Zero();
  for (std::size_t k = 0; k < corners.size(); ++k) point += weights[k] * corners[k];
  return point;
}

/// A point that is on the face at (xi, eta, tau) and moves over the step by `relative` as seen from there.
inline MovingPoint shot(const MovingFace& face, double xi, double eta, double tau, const Vec3& relative) {
  const auto at = corners_at(face, tau);
  const Vec3 place = point_at({at.data(), face.start.size()}, xi, eta);
  const Vec3 motion = point_at(face.end, xi, eta) - point_at(face.start, xi, eta) + relative;
  return {place - tau * motion, place + (1 - tau) * motion};
}

inline Vec3 normal_at(const MovingFace& face, double xi, double eta, double tau) {
  const auto at = corners_at(face, tau);
  return face_normal({at.data(), face.start.size()}, xi, eta);
}

/// A direction that goes against the normal at `angle` [rad] to the tangent plane.
inline Vec3 inward(Random& random, const Vec3& normal, double angle) {
  const Vec3 tangent = normal.cross(random_vector(random, 1)).normalized();
  return std::cos(angle) * tangent - std::sin(angle) * normal;
}

}  // namespace brunt::geometry::testing
