// SPDX-License-Identifier: Apache-2.0
// The internal force of all elements: gather, kernel (element x material), scatter in canonical element order.
#pragma once
#include <string>
#include <vector>

#include "brunt/element/batch.hpp"
#include "brunt/force/assembled.hpp"
#include "brunt/model/model.hpp"

namespace brunt::force {

/// What the elements of this rank say about the step.
struct ElementReport {
  double rate = 0;        ///< largest 1/(stable step) [1/time]
  LocalIndex block = -1;  ///< of the element that controls the step
  LocalIndex element = -1;
  LocalIndex inverted_block = -1;  ///< >= 0: an element with no volume left (or not a number)
  LocalIndex inverted_element = -1;
  double growth = 0;  ///< largest growth over StepWatch::baseline, of squared frequencies; 0 without one
};

/// What elements of this kind and law remember, in order.
std::vector<element::HistoryField> history_fields(const model::ElementBlock& block);

/// force[node] = minus the internal force, but for border nodes, whose corner forces stand in `slots`.
/// Stress and history go from t_n - dt to t_n.
ElementReport internal_forces(const model::Model& model, model::State& state, model::Scratch& scratch,
                              const StepWatch& watch = {});

}  // namespace brunt::force
