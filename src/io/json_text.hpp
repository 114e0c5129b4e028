// SPDX-License-Identifier: Apache-2.0
// JSON that every reader accepts.
#pragma once
#include <nlohmann/json_fwd.hpp>
#include <string>

namespace brunt::io {

/// The value as text. Bytes that are no UTF-8, as paths may hold, become the replacement character; NaN and infinity
/// become null. indent: blanks a level; < 0: all in one line.
[[nodiscard]] std::string json_text(const nlohmann::ordered_json& value, int indent = -1);

}  // namespace brunt::io
