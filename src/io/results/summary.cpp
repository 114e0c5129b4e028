// SPDX-License-Identifier: Apache-2.0
// Writes summary.json (see the header).
#include "io/results/summary.hpp"

#include <fstream>
#include <nlohmann/json.hpp>

#include "io/json_text.hpp"
#include "io/text_file.hpp"

namespace brunt::io {

void write_summary(const std::string& folder, const nlohmann::ordered_json& summary) {
  replace_text(folder + "/summary.json", json_text(summary, 2) + "\n");
}

std::optional<GlobalIndex> summarised_steps(const std::string& folder) {
  std::ifstream file(folder + "/summary.json");
  const auto summary = nlohmann::json::parse(file, nullptr, false);
  if (!summary.is_object() || !summary.contains("steps") || !summary["steps"].is_number_integer()) return std::nullopt;
  return summary["steps"].get<GlobalIndex>();
}

}  // namespace brunt::io
