// SPDX-License-Identifier: Apache-2.0
// summary.json: one object that says how a run went.
#pragma once
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>

#include "brunt/core/types.hpp"

namespace brunt::io {

/// Replaces folder/summary.json as a whole. Numbers that JSON cannot hold (NaN, infinity) become null.
/// Not collective: for the root rank. Throws MachineError.
void write_summary(const std::string& folder, const nlohmann::ordered_json& summary);

/// Steps of the run that folder/summary.json tells of; none where there is no such file, or it is damaged.
[[nodiscard]] std::optional<GlobalIndex> summarised_steps(const std::string& folder);

}  // namespace brunt::io
