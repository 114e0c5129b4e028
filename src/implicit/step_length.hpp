// SPDX-License-Identifier: Apache-2.0
// The lengths of steps: a first length times powers of two, halved if Newton's iteration fails, doubled again after
// easy steps. t_n is an integer multiple of the current length, so that halved steps reach the times of unhalved ones,
// the end time is reached exactly if the first length divides it, and a restart continues with the same times.
#pragma once
#include "model/implicit_solver.hpp"

namespace brunt::implicit {

/// Whole numbers, saved with the state.
struct StepLength {
  double level = 0;  ///< dt = step 2^level
  double count = 0;  ///< t_n = count dt
  double easy = 0;   ///< number of steps since the last difficult or halved one, at this level
};
constexpr int step_length_values = 3;

constexpr int easy_iterations = 6;  ///< steps with more iterations are difficult
constexpr double steps_until_growth = 2;

double step_of(const model::ImplicitSolver& solver, const StepLength& length);    ///< dt [time]
double time_of(const model::ImplicitSolver& solver, const StepLength& length);    ///< t_n [time]
double next_time(const model::ImplicitSolver& solver, const StepLength& length);  ///< t_n + dt [time]

/// Halves the step; returns false if it would be below min_step.
bool halve(const model::ImplicitSolver& solver, StepLength& length);

/// After a step with `iterations`: counts it, and doubles the step after some easy ones if max_step allows it and t_n
/// is an integer multiple of the doubled step.
void count_step(const model::ImplicitSolver& solver, int iterations, StepLength& length);

}  // namespace brunt::implicit
