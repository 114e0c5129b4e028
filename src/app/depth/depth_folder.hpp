// SPDX-License-Identifier: Apache-2.0
// The result folder of `brunt depth`: depth.csv, row by row; depth.json and surfaces at the end. An unfinished folder
// is continued.
#pragma once
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "depth_table.hpp"
#include "depth_work.hpp"

namespace brunt::app {

/// For the root rank.
class DepthFolder {
 public:
  /// Without `--out` nothing is written. fingerprint: of the query; an unfinished folder of another query is rejected,
  /// and so is one with results, unless forced. Throws InputError.
  DepthFolder(const DepthOptions& options, const std::string& fingerprint);

  [[nodiscard]] const std::vector<EarlierRow>& earlier() const { return earlier_; }  ///< rows of an unfinished run
  /// Handed to the operating system at once. Throws MachineError.
  void add(const DepthRow& row);
  /// Body A before and after each motion, and body B: PLY.
  void write_surfaces(const DepthWork& work, const std::vector<DepthRow>& rows) const;
  void finish(const nlohmann::ordered_json& all) const;

 private:
  void keep_whole_rows(const std::string& path);

  std::string folder_;
  std::ofstream rows_;
  std::vector<EarlierRow> earlier_;
};

}  // namespace brunt::app
