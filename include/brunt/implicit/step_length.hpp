// SPDX-License-Identifier: Apache-2.0
// The lengths of steps: a first length times powers of two, halved where Newton's iteration fails, doubled again after
// easy steps. t_n is a whole number of steps of the present length, so that halved steps meet the times of unhalved
// ones, the end of a run is met where the first length divides it, and a restart goes on in the same places.
#pragma once
#include "brunt/model/implicit_solver.hpp"

namespace brunt::implicit {

/// Whole numbers, saved with the state.
struct StepLength {
  double level = 0;  ///< dt = step 2^level
  double count = 0;  ///< t_n = count dt
  double easy = 0;   ///< steps since the last hard or halved one, of this level
};
constexpr int step_length_values = 3;

constexpr int easy_iterations = 6;  ///< a step of more is hard: M6 has at most six on average
constexpr double steps_until_growth = 2;

double step_of(const model::ImplicitSolver& solver, const StepLength& length);    ///< dt [time]
double next_time(const model::ImplicitSolver& solver, const StepLength& length);  ///< t_n + dt [time]

/// Halves the step; false where that would be below min_step.
bool halve(const model::ImplicitSolver& solver, StepLength& length);

/// After a step that took `iterations`: counts it, and doubles the step after some easy ones where max_step allows and
/// t_n is a whole number of the doubled ones.
void count_step(const model::ImplicitSolver& solver, int iterations, StepLength& length);

}  // namespace brunt::implicit
