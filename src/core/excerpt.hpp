// SPDX-License-Identifier: Apache-2.0
// Texts of the user in messages.
#pragma once
#include <string>
#include <string_view>

namespace brunt {

/// A text of a file, a scene or a command line as a message may quote it: on one line, without control characters, and
/// at most 60 characters long. A longer text ends with "...". UTF-8 characters remain whole; bytes that are no UTF-8
/// become '?'.
[[nodiscard]] std::string excerpt(std::string_view text);

}  // namespace brunt
