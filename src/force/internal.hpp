// SPDX-License-Identifier: Apache-2.0
// The internal force of all elements: gather, kernel (element x material), scatter in canonical element order.
#pragma once
#include <string>
#include <vector>

#include "element/batch.hpp"
#include "force/assembled.hpp"
#include "model/model.hpp"

namespace brunt::force {

/// Results of the elements of this rank for the step.
struct ElementReport {
  double rate = 0;        ///< largest 1/(stable step) [1/time]
  LocalIndex block = -1;  ///< of the element that controls the step
  LocalIndex element = -1;
  LocalIndex inverted_block = -1;  ///< >= 0: an element without positive volume (or NaN)
  LocalIndex inverted_element = -1;
  double growth = 0;  ///< largest growth of squared frequencies relative to StepWatch::baseline; 0 without one
};

/// The history variables of elements of this kind and law, in order.
std::vector<element::HistoryField> history_fields(const model::ElementBlock& block);

/// force[node] = minus the internal force, except for border nodes, whose corner forces are stored in `slots`. Stress
/// and history advance from t_n - dt to t_n.
ElementReport internal_forces(const model::Model& model, model::State& state, model::Scratch& scratch,
                              const StepWatch& watch = {});

}  // namespace brunt::force
