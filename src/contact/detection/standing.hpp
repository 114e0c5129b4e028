// SPDX-License-Identifier: Apache-2.0
// The classifier of encounters by position: where a node is relative to the closest point of a face, for one pair or a
// pack of pairs, and the resulting meeting.
#pragma once
#include <algorithm>

#include "contact/data/tolerances.hpp"
#include "contact/detection/encounter.hpp"
#include "geometry/vec_of.hpp"

namespace brunt::contact {

/// T: double, or Pack for a pair a lane.
template <class T>
struct Standing {
  T over_middle;  ///< height over the tangent plane at the closest point [length]
  T beside;       ///< distance of the node's projection on that plane from the point [length]
  T moved;        ///< length of the motion relative to the point within the step [length]
  T risen;        ///< its component along the normal [length]
};

/// normal: unit, on the node's side; relative: predicted velocity of the node relative to the point.
template <class T>
BRUNT_INLINE Standing<T> stand(const geometry::VecOf<T>& node, const geometry::VecOf<T>& point,
                               const geometry::VecOf<T>& normal, const geometry::VecOf<T>& relative, T dt) {
  const geometry::VecOf<T> offset = node - point;
  const T over_middle = dot(offset, normal);
  return {over_middle, norm(offset - over_middle * normal), dt * norm(relative), dt * dot(relative, normal)};
}

/// Fills height, gap, beside, slow and meeting of an encounter with known region, size and clearance; element_depth: of
/// the face.
inline void classify(const Standing<double>& at, const Tolerances& tolerances, double element_depth, Encounter& met) {
  met.height = met.gap = at.over_middle - met.approach.clearance;
  met.beside = at.beside;
  if (met.height <= 0) {
    const double deepest = tolerances.max_penetration(met.size, element_depth);
    if (at.over_middle * at.over_middle + met.beside * met.beside <= deepest * deepest) met.meeting = Meeting::inside;
    return;
  }
  met.slow = at.moved <= tolerances.slow * met.size;
  // candidates come from boxes along the axes, which reach farther along some directions than along others
  if (met.height + std::min(0.0, at.risen) > tolerances.reach(met.size, element_depth)) return;
  const bool over = met.region == geometry::Region::face;
  if (over || met.beside <= tolerances.rim * met.size) met.meeting = Meeting::above;
}

}  // namespace brunt::contact
