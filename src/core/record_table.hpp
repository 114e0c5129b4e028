// SPDX-License-Identifier: Apache-2.0
// Records that are created and deleted during a run, each on one rank and identified by a key of integers. The history
// of contact is stored this way in checkpoints and in the state hash, independent of the meaning of the numbers.
#pragma once
#include <string>
#include <vector>

#include "core/types.hpp"

namespace brunt {

struct RecordTable {
  std::string name;  ///< unique: "contact_pairs"
  int key_width = 0, value_width = 0;
  std::vector<GlobalIndex> keys{};  ///< key_width a record
  std::vector<double> values{};     ///< value_width a record

  [[nodiscard]] GlobalIndex rows() const { return static_cast<GlobalIndex>(keys.size()) / key_width; }
};

}  // namespace brunt
