// SPDX-License-Identifier: Apache-2.0
// The arms of friction (FRICTION.md). The slave of a row lies at the height g over its place on the master, so the
// impulse p across the normal n and its reaction have the moment g n x p. With the points x_i of the master, their
// shares m_i (of sum 1) and y_i = x_i - sum m_i x_i, the master's motion along n has the slope
//   s = K^-1 sum m_i y_i (n . v_i),   K = sum m_i y_i y_i^T across n,
// and n turns by -s. The place at the height g therefore moves by g s less than the one on the master:
// Row::tilts are g K^-1 m_i y_i. A common rotation then has no rate across n, and the impulse no moment. Rates and
// impulses along n are as without.
#pragma once
#include <cmath>
#include <concepts>
#include <span>
#include <vector>

#include "contact/data/constraint.hpp"
#include "contact/detection/detection.hpp"
#include "geometry/moments_across.hpp"

namespace brunt::contact {

struct TiltScene {
  std::span<const NodeMotion> motion;  ///< of contact nodes
  double least = 0;                    ///< height that is rounding [length]
};

/// Mortar rows with friction.
bool has_tilts(const Row& row);

/// The tilts of the rows of a step.
struct TiltStore {
  std::vector<Vec3> values;
  std::size_t used = 0;
  /// With room for all points of rows that have tilts.
  void start(std::span<const Row> rows);
  std::span<Vec3> next(std::size_t count);
};

/// Row::tilts of a row with friction; none if its height is rounding or its points lie on a line. share_of(i): m_i of
/// its i-th point, in any unit, 0 if that is not one of the master's.
template <std::invocable<std::size_t> ShareOf>
void tilt_row(Row& row, const TiltScene& scene, TiltStore& store, const ShareOf& share_of) {
  const std::size_t count = row.points().size();
  const auto place = [&](std::size_t i) -> const Vec3& { return nth(scene.motion, row.points()[i]).position; };
  Vec3 offset = Vec3::Zero(), middle = Vec3::Zero();
  double total = 0;
  for (std::size_t i = 0; i < count; ++i) {
    offset += row.shares()[i] * place(i);
    middle += share_of(i) * place(i);
    total += share_of(i);
  }
  const double height = row.normal.dot(offset);
  if (!(std::abs(height) > scene.least) || total == 0) return;
  middle /= total;
  Mat3 moments = Mat3::Zero();
  for (std::size_t i = 0; i < count; ++i) {
    if (share_of(i) == 0) continue;
    const Vec3 from_middle = place(i) - middle;
    moments += share_of(i) * from_middle * from_middle.transpose();
  }
  const geometry::MomentsAcross across(moments, row.normal);
  if (!across.are_plane()) return;
  const Mat3 slope = height * across.inverse();
  const std::span<Vec3> tilts = store.next(count);
  for (std::size_t i = 0; i < count; ++i) {
    const double share = share_of(i);
    tilts[i] = share == 0 ? Vec3(Vec3::Zero()) : Vec3(share * (slope * (place(i) - middle)));
  }
  row.tilts = tilts;
}

}  // namespace brunt::contact
