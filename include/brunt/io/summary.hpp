// SPDX-License-Identifier: Apache-2.0
// summary.json: one object that says how a run went.
#pragma once
#include <nlohmann/json_fwd.hpp>
#include <string>

namespace brunt::io {

/// Replaces folder/summary.json as a whole. Numbers that JSON cannot hold (NaN, infinity) become null.
/// Not collective: for the root rank. Throws MachineError.
void write_summary(const std::string& folder, const nlohmann::ordered_json& summary);

}  // namespace brunt::io
