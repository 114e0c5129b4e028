// SPDX-License-Identifier: Apache-2.0
// Return at opening: the law of one row (src/contact/enforcement/IMPACT.md). The rate constraint takes the energy of
// the half elements at the surfaces when they meet. A row keeps what it takes as a bank B, and requires a rate of
// separation as it opens that returns the share w of the bank:
//   w = 0 if adjacent elements have flowed since the arrival, otherwise min(1, max(0, 4 phi / top - 2)).
// phi is the pressing force with a memory that fades within 30 crossings of a half element and top the largest one, so
// bodies that are unloaded slowly get nothing. An impulse p does the work p (r_- + r)/2 on the bodies.
#pragma once
#include "contact/data/impact_history.hpp"

namespace brunt::contact {

/// Numbers that decide, dimensionless.
struct ImpactNumbers {
  /// Share of the pressing force of the last step below which a row opens: the force vanishes nearer to this step than
  /// to the next.
  double early = 0.5;
  /// Memory of the pressing force, in crossings of a half element.
  double memory = 30;
};
constexpr ImpactNumbers impact_numbers;

/// A row in a step, along its normal and relative to its wall, with the solution of the rate constraint.
struct ImpactStep {
  double before = 0;    ///< r_-, rate before the step [velocity]
  double after = 0;     ///< r_0, rate after it [velocity]
  double push = 0;      ///< p_0 >= 0 [momentum]
  double pressing = 0;  ///< z, pressing force over impedance [velocity]
  double flow = 0;      ///< e, plastic strain of adjacent elements
};

/// Whether a row with a bank opens in this step: the pressing force vanishes, or its neighbours separate it. A row
/// without an impulse that is still pressed is one of several that are redundant.
bool opens(const ImpactState& state, const ImpactStep& step);

/// w B [energy].
double energy_to_return(const ImpactState& state, double flow);

/// The rate [velocity] with which a row alone does the work `energy` more than the rate constraint. answer: its rate
/// for a unit impulse [1/mass]:
///   x^2 + (answer p_0 + r_- + r_0) x = 2 answer energy,   x = r - r_0 >= 0.
double returning_rate(const ImpactStep& step, double energy, double answer);

/// The state of a row that stays closed, or is one of several redundant ones. work: p (r_- + r)/2 of its impulse on the
/// bodies [energy]; fading: length of the step over the memory.
ImpactState closed_state(ImpactState state, const ImpactStep& step, double work, double fading);

}  // namespace brunt::contact
