// SPDX-License-Identifier: Apache-2.0
// Consistent tangents: the exact derivative of an element's forces as its discrete update computes them.
#pragma once
#include <span>

#include "brunt/force/trial.hpp"
#include "brunt/model/model.hpp"

namespace brunt::force {

/// One-point hexahedra have none: their hourglass modes stand on control alone.
bool gives_tangents(element::ElementKind kind);
/// Laws with an equation of state, a temperature or damage have none.
bool gives_tangents(const material::Law& law);

/// Derivatives of the internal forces of `elements` of a block at the end of the step, by the positions at its end,
/// while where it began and what is committed stay. A square matrix of 3 times corners rows for each element, in their
/// order, row after row; rows and columns count 3 corner + component. The step's length must not be zero. Symmetric
/// where the law has a potential (neo-Hookean, without viscosity), else nearly. Throws InputError where gives_tangents
/// says no.
void element_tangents(const model::Model& model, LocalIndex block, std::span<const LocalIndex> elements,
                      const Motion& motion, const History& committed, std::span<double> matrices);

}  // namespace brunt::force
