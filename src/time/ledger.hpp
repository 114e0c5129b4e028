// SPDX-License-Identifier: Apache-2.0
// The energy balance at t_n: kinetic energy 1/2 m v_{n-1/2} . v_{n+1/2}, and the work of every force as its impulse
// times the mean of the velocities before and after. The total is then an identity of the scheme.
#pragma once
#include "comm/communicator.hpp"
#include "contact/contact.hpp"
#include "model/model.hpp"
#include "time/step.hpp"

namespace brunt::time {

/// All terms in [energy]. contact, friction and walls are taken from the bodies (normally positive); external is
/// supplied by gravity, pressure and prescribed motion.
struct Ledger {
  double kinetic = 0, internal = 0, hourglass = 0, bulk = 0, damping = 0, contact = 0, friction = 0, walls = 0,
         external = 0, eroded = 0;
  double driven = 0;  ///< taken by rows that cannot be satisfied (see contact/unmet.hpp)
  double ties = 0;    ///< the part of `friction` due to the shear of ties, which may be returned
  double mass = 0;
  Vec3 momentum = Vec3::Zero();           ///< [mass length/time]
  Vec3 impulse_given = Vec3::Zero();      ///< of loads, reactions and walls since t = 0
  contact::ContactTotals contact_totals;  ///< what contact and walls have done since t = 0
  double momentum_scale = 0;              ///< sum of m |v|: reference for momentum errors

  /// Constant in time for an exact scheme.
  [[nodiscard]] double total() const {
    return kinetic + internal + hourglass + bulk + damping + contact + friction + walls + driven + eroded - external;
  }
};

/// The ledger at t_n (`contact` as in `advance`); call it after `advance` has gone from t_n to t_{n+1}. Collective.
Ledger ledger(const model::Model& model, const model::State& state, const model::Scratch& scratch, const Links& links,
              const contact::Contact* contact, const StepReport& step);

}  // namespace brunt::time
