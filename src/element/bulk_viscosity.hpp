// SPDX-License-Identifier: Apache-2.0
// Viscous pressure that spreads shocks over a few elements and damps the highest frequency.
#pragma once
#include "element/batch.hpp"
#include "element/options.hpp"

namespace brunt::element {

/// Viscosity z of the pressure -z e, e the rate of volume strain: linear rho c L + quadratic^2 rho L^2 |e|, the second
/// in compression only (J. von Neumann, R. D. Richtmyer 1950; R. Landshoff 1955). `modulus` = rho c^2, `rho_length2` =
/// rho L^2, L the thickness of the element.
template <class Number, class Modulus>
BRUNT_INLINE Number bulk_viscosity(const BulkViscosity& bulk, Modulus modulus, Number rho_length2, Number volume_rate) {
  const Number compression = pack_max(-volume_rate, Number{});
  return bulk.linear * pack_sqrt(modulus * rho_length2) + (bulk.quadratic * bulk.quadratic) * rho_length2 * compression;
}

/// Adds the work of the viscous stress over the step to t_n (trapezoidal, as all work in the ledger). Accounts: energy,
/// then the viscous stress times volume at the end of the step. Returns the work [energy].
template <class Number>
BRUNT_INLINE Number book_bulk_work(const Pack* committed, Number* trial, Number viscous_stress, Number volume,
                                   Number volume_rate, double dt) {
  const Number now = viscous_stress * volume;
  const Number work = (0.5 * dt) * (committed[1] + now) * volume_rate;
  trial[0] = committed[0] + work;
  trial[1] = now;
  return work;
}

}  // namespace brunt::element
