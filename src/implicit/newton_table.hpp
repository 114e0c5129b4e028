// SPDX-License-Identifier: Apache-2.0
// The residuals of Newton's iterations, step by step, and how many steps converged quadratically.
#pragma once
#include <deque>
#include <span>
#include <vector>

#include "core/types.hpp"

namespace brunt::implicit {

/// Smaller residuals are near rounding, where convergence is no longer quadratic.
constexpr double least_ratio = 1e-11;
/// A step counts as quadratic from this value of log r_{k+1} / log r_k; the limit is 2.
constexpr double quadratic_order = 1.7;

/// One converged step.
struct NewtonRecord {
  double time = 0;             ///< t_{n+1}
  std::vector<double> ratios;  ///< residual over applied forces, for each iterate
  bool stood = true;           ///< the active set was the same at the last two iterates above least_ratio
};

struct NewtonTable {
  std::deque<NewtonRecord> last;          ///< of the last most_records steps
  GlobalIndex judged = 0, quadratic = 0;  ///< number of steps with two residuals above least_ratio and an unchanged
                                          ///< active set, and those with quadratic convergence
};
constexpr std::size_t most_records = 1000;

/// Index of the last residual above least_ratio that has a predecessor; 0 if there are not two.
std::size_t last_judged(std::span<const double> ratios);

/// log r_{k+1} / log r_k of the last two residuals above least_ratio; 0 if there are not two.
double order_of(std::span<const double> ratios);

void add(NewtonTable& table, NewtonRecord record);

}  // namespace brunt::implicit
