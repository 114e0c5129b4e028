// SPDX-License-Identifier: Apache-2.0
// summary.json: one object with the results of a run.
#pragma once
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>

#include "core/types.hpp"

namespace brunt::io {

/// Replaces folder/summary.json. Numbers that JSON cannot represent (NaN, infinity) become null. Not collective: for
/// the root rank. Throws MachineError.
void write_summary(const std::string& folder, const nlohmann::ordered_json& summary);

/// Number of steps recorded in folder/summary.json; none if there is no such file, or it is damaged.
[[nodiscard]] std::optional<GlobalIndex> summarised_steps(const std::string& folder);

}  // namespace brunt::io
