// SPDX-License-Identifier: Apache-2.0
// Rotary inertia of the shells of each kind: of their fibres, or as much as the transverse shear needs not to govern
// the stable step.
#pragma once
#include "element/options.hpp"
#include "element/shell3.hpp"
#include "element/shell4_step.hpp"

namespace brunt::element {

/// Of whole elements of any kind with these corners, an equal share for each corner. x: corners at the start; lambda,
/// mu: Lame's constants of the virgin solid.
template <int nodes>
Pack rotary_inertia_of(const Pack (&x)[3][nodes], Pack mass, const ShellSection& section, double lambda, double mu) {
  return rotary_inertia(x, mass, broadcast(section.thickness), section.offset, lambda, mu);
}

}  // namespace brunt::element
