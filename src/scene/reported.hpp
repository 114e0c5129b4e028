// SPDX-License-Identifier: Apache-2.0
// The line of a fault that is found after a scene has been read.
#pragma once
#include <fmt/format.h>

#include <string>
#include <utility>

#include "scene/input.hpp"

namespace brunt::scene {

/// "FILE:LINE: key: what".
template <class... Values>
std::string reported(const Input& input, const std::string& key, fmt::format_string<Values...> what,
                     Values&&... values) {
  return fmt::format("{}: {}", input.at(key), fmt::format(what, std::forward<Values>(values)...));
}

}  // namespace brunt::scene
