// SPDX-License-Identifier: Apache-2.0
#include "core/error.hpp"

#include <utility>

namespace brunt {
namespace {

std::string joined(const std::vector<std::string>& lines) {
  std::string text;
  for (const std::string& line : lines) text += (text.empty() ? "" : "\n") + line;
  return text;
}

}  // namespace

InputError::InputError(const std::string& fault) : InputError(std::vector<std::string>{fault}) {}

InputError::InputError(std::vector<std::string> faults)
    : std::runtime_error(joined(faults)), faults_(std::move(faults)) {}

void demand(bool holds, std::string_view what) {
  if (!holds)
    throw std::logic_error("internal error (please report it): this condition does not hold: " + std::string(what));
}

}  // namespace brunt
