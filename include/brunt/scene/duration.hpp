// SPDX-License-Identifier: Apache-2.0
// Wall-clock durations as people write them: 3h55m, 90s, 2h.
#pragma once
#include <optional>
#include <string_view>

namespace brunt::scene {

/// [s]; days, hours, minutes, seconds, each at most once and in this order (1d, 3h55m, 90s, 1m30.5s), or a bare number
/// of seconds. Nothing for other text, zero and negative durations.
std::optional<double> parse_duration(std::string_view text);

}  // namespace brunt::scene
