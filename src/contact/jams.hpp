// SPDX-License-Identifier: Apache-2.0
// Rows that the motion of a step cannot satisfy since bodies turn. A row is linear in the motion of the step; where a
// body can yield by turning only, its lever changes as it turns, and a lever that is short is used up:
//
//   gap at the end = gap by v* + a s + a^2 q,   a: multiple of the impulses, s: first order, q: second order.
//
// With q < 0 no multiple makes up for what the row requires, gain = n . (v - v*) dt, if s <= 0 or s^2 < -4 q gain: a
// pivoted body that is pressed beside the line to its pivot gives way by lever^2 / (2 distance) and no more. The linear
// solution would turn it by any angle instead. Such a row is unmet (see unmet.hpp): it is left out of the step.
#pragma once
#include "contact/contact.hpp"

namespace brunt::contact {

/// Second-order change of the gap of a row in a step. Vectors refer to space.
struct SecondOrder {
  Vec3 normal = Vec3::Zero();  ///< of the master, unit
  Vec3 arm = Vec3::Zero();     ///< from the centre of the slave's body to the slave [length]
  Vec3 reach = Vec3::Zero();   ///< from the centre of the master's body to the slave [length]
  struct Motion {
    Vec3 turn = Vec3::Zero();         ///< of the slave's body in the step [rad]
    Vec3 master_turn = Vec3::Zero();  ///< of the master's body [rad]
    Vec3 shift = Vec3::Zero();        ///< of the slave, relative to the centre of the master's body [length]
  };
  /// The normal turns with the master.
  [[nodiscard]] double of(const Motion& motion) const {
    const Vec3 of_slave = motion.turn.cross(motion.turn.cross(arm)),
               of_master = motion.master_turn.cross(motion.master_turn.cross(reach));
    return normal.dot(0.5 * (of_slave + of_master) - motion.master_turn.cross(motion.shift));
  }
};

/// Whether no multiple of impulses of this first and second order gains as much (> 0).
inline bool has_no_multiple(double first, double second, double gain) {
  return second < 0 && (first <= 0 || first * first < -4 * second * gain);
}

/// Takes such rows out of the step, after enforcement; contact.unmet.jammed keeps them. Was there any on some rank?
/// Collective.
bool drop_jammed_rows(Contact& contact, const StepInput& input, const EnforcementResult& result);

}  // namespace brunt::contact
