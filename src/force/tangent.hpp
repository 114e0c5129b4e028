// SPDX-License-Identifier: Apache-2.0
// Consistent tangents: the exact derivative of an element's forces as its discrete update computes them.
#pragma once
#include <span>

#include "force/trial.hpp"
#include "model/model.hpp"

namespace brunt::force {

/// One-point hexahedra have none: their hourglass modes have only the stiffness of the hourglass control.
bool gives_tangents(element::ElementKind kind);
/// Laws with an equation of state, a temperature or damage have none.
bool gives_tangents(const material::Law& law);

/// Derivatives of the internal forces of `elements` of a block at the end of the step by the positions at its end, for
/// fixed initial positions and committed history. One square matrix of 3 times corners rows for each element, in their
/// order, row by row; rows and columns are numbered 3 corner + component. The length of the step must not be zero.
/// Symmetric if the law has a potential (neo-Hookean, without viscosity), otherwise nearly so. Throws InputError if
/// gives_tangents is false.
void element_tangents(const model::Model& model, LocalIndex block, std::span<const LocalIndex> elements,
                      const Motion& motion, const History& committed, std::span<double> matrices);

}  // namespace brunt::force
