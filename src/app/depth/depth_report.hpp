// SPDX-License-Identifier: Apache-2.0
// Output of an answer of `brunt depth`: text for a terminal, a JSON object.
#pragma once
#include <nlohmann/json.hpp>
#include <string>

#include "depth_row.hpp"
#include "depth_table.hpp"

namespace brunt::app {

/// Some lines, for a terminal.
[[nodiscard]] std::string described(const DepthRow& row);

/// One line, empty where the overlaps explain the depth. careful: the search was; the advice is another then.
[[nodiscard]] std::string warning_of(const DepthRow& row, bool careful);

[[nodiscard]] nlohmann::ordered_json as_json(const DepthRow& row);

/// Of a row that was read from depth.csv: as for the answer itself, but without the contacts, of which the table holds
/// the number only.
[[nodiscard]] nlohmann::ordered_json as_json(const EarlierRow& earlier);

}  // namespace brunt::app
