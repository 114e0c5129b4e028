// SPDX-License-Identifier: Apache-2.0
#include "brunt/io/compare.hpp"

#include <fmt/core.h>

#include "brunt/core/error.hpp"
#include "commands.hpp"

namespace brunt::app {

int compare(const comm::Communicator& ranks, const CompareOptions& options) {
  const io::Comparison comparison = io::compare_results(ranks, options.a, options.b);
  if (ranks.is_root()) fmt::print("{}", io::comparison_text(comparison, options.tolerance));
  return static_cast<int>(comparison.within(options.tolerance) ? ExitCode::done : ExitCode::differs);
}

}  // namespace brunt::app
