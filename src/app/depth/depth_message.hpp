// SPDX-License-Identifier: Apache-2.0
// Answers of `brunt depth` as bytes that travel between ranks.
#pragma once
#include <cstddef>
#include <span>
#include <vector>

#include "depth_row.hpp"

namespace brunt::app {

[[nodiscard]] std::vector<std::byte> packed(const std::vector<DepthRow>& rows);
[[nodiscard]] std::vector<DepthRow> unpacked(std::span<const std::byte> bytes);

}  // namespace brunt::app
