// SPDX-License-Identifier: Apache-2.0
// Wall-clock durations in the usual notation: 3h55m, 90s, 2h.
#pragma once
#include <optional>
#include <string_view>

namespace brunt::scene {

/// Duration in seconds. Days, hours, minutes and seconds may each be given once and in this order (1d, 3h55m, 90s,
/// 1m30.5s), or a plain number of seconds. Empty for other text and for durations that are not positive.
std::optional<double> parse_duration(std::string_view text);

}  // namespace brunt::scene
