// SPDX-License-Identifier: Apache-2.0
// The residuals of Newton's iterations, step by step, and how many steps converged quadratically.
#pragma once
#include <deque>
#include <span>
#include <vector>

#include "brunt/core/types.hpp"

namespace brunt::implicit {

/// Residuals below are near rounding, and no longer squared.
constexpr double least_ratio = 1e-11;
/// log r_{k+1} / log r_k from which on a step counts as quadratic; 2 in the limit (M6).
constexpr double quadratic_order = 1.7;

/// One step that converged.
struct NewtonRecord {
  double time = 0;             ///< t_{n+1}
  std::vector<double> ratios;  ///< forces left over those that act, iterate by iterate
  bool stood = true;           ///< the set of contact was the same at the last two iterates above least_ratio
};

struct NewtonTable {
  std::deque<NewtonRecord> last;          ///< of the last most_records steps
  GlobalIndex judged = 0, quadratic = 0;  ///< of all steps: with two residuals above least_ratio and a set that stood
};
constexpr std::size_t most_records = 1000;

/// Place of the last residual above least_ratio that has one before it; 0: there are no two.
std::size_t last_judged(std::span<const double> ratios);

/// log r_{k+1} / log r_k of the last two residuals above least_ratio; 0 where there are no two.
double order_of(std::span<const double> ratios);

void add(NewtonTable& table, NewtonRecord record);

}  // namespace brunt::implicit
