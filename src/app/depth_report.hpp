// SPDX-License-Identifier: Apache-2.0
// What `brunt depth` tells: text for one answer, a row of depth.csv an answer, one JSON object for all.
#pragma once
#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "brunt/depth/penetration_depth.hpp"

namespace brunt::app {

/// One answer, with what it was asked about. Everything of it travels between ranks.
struct DepthRow {
  std::int64_t pose = 0;  ///< from 0; of a scene: the pair
  std::string a, b;       ///< files or parts
  depth::Metric metric = depth::Metric::displacement;
  depth::Answer answer;
  Vec3 centroid = Vec3::Zero();  ///< of A, in the coordinates of its file
  Placement start;
  double seconds = 0;
};

[[nodiscard]] std::vector<std::byte> packed(const std::vector<DepthRow>& rows);
[[nodiscard]] std::vector<DepthRow> unpacked(std::span<const std::byte> bytes);

/// Some lines, for a terminal.
[[nodiscard]] std::string described(const DepthRow& row);

[[nodiscard]] std::string csv_header();
/// Numbers in the shortest form that reads back to the same bits; the time stands last.
[[nodiscard]] std::string csv_row(const DepthRow& row);

[[nodiscard]] nlohmann::ordered_json as_json(const DepthRow& row);

}  // namespace brunt::app
