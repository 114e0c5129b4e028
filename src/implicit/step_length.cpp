// SPDX-License-Identifier: Apache-2.0
#include "implicit/step_length.hpp"

#include <cmath>

namespace brunt::implicit {
namespace {

constexpr double rounding = 1e-9;  // of bounds that are the first length times a power of two, in decimals

}  // namespace

double step_of(const model::ImplicitSolver& solver, const StepLength& length) {
  return std::ldexp(solver.step, static_cast<int>(length.level));
}

double time_of(const model::ImplicitSolver& solver, const StepLength& length) {
  return length.count * step_of(solver, length);
}

double next_time(const model::ImplicitSolver& solver, const StepLength& length) {
  return (length.count + 1) * step_of(solver, length);
}

bool halve(const model::ImplicitSolver& solver, StepLength& length) {
  if (0.5 * step_of(solver, length) < (1 - rounding) * solver.min_step) return false;
  length = {length.level - 1, 2 * length.count, 0};
  return true;
}

void count_step(const model::ImplicitSolver& solver, int iterations, StepLength& length) {
  ++length.count;
  length.easy = iterations <= easy_iterations ? length.easy + 1 : 0;
  const bool allowed = 2 * step_of(solver, length) <= (1 + rounding) * solver.max_step;
  if (length.easy < steps_until_growth || !allowed || std::fmod(length.count, 2.0) != 0) return;
  length = {length.level + 1, 0.5 * length.count, 0};
}

}  // namespace brunt::implicit
