// SPDX-License-Identifier: Apache-2.0
#include "io/results/compare.hpp"

#include <fmt/core.h>

#include "app/program/commands.hpp"
#include "core/error.hpp"

namespace brunt::app {

int compare(const comm::Communicator& ranks, const CompareOptions& options) {
  const io::Comparison comparison = io::compare_results(ranks, options.a, options.b);
  if (ranks.is_root()) fmt::print("{}", io::comparison_text(comparison, options.tolerance));
  return static_cast<int>(comparison.within(options.tolerance) ? ExitCode::done : ExitCode::differs);
}

}  // namespace brunt::app
