// SPDX-License-Identifier: Apache-2.0
// Records that come and go during a run, each on one rank and told apart by a key of integers: how contact's history
// goes to checkpoints and into the state hash, which need not know what the numbers mean.
#pragma once
#include <string>
#include <vector>

#include "brunt/core/types.hpp"

namespace brunt {

struct RecordTable {
  std::string name;  ///< unique: "contact_pairs"
  int key_width = 0, value_width = 0;
  std::vector<GlobalIndex> keys{};  ///< key_width a record
  std::vector<double> values{};     ///< value_width a record

  [[nodiscard]] GlobalIndex rows() const { return static_cast<GlobalIndex>(keys.size()) / key_width; }
};

}  // namespace brunt
