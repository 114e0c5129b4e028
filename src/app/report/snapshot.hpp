// SPDX-License-Identifier: Apache-2.0
// A copy of the saved state in memory, for a return to the last valid state of a run.
#pragma once
#include <vector>

#include "model/registry.hpp"

namespace brunt::app {

class Snapshot {
 public:
  [[nodiscard]] bool empty() const { return values_.empty(); }
  /// Copies the data of this rank that a checkpoint would contain. Allocates at the first call, and for new records.
  void take(const model::Registry& registry);
  /// Restores the arrays and tables of the same registry.
  void give_back(const model::Registry& registry) const;
  /// Deletes the copy and releases its memory.
  void release() { *this = {}; }

 private:
  std::vector<double> values_;
  std::vector<RecordTable> tables_;
};

}  // namespace brunt::app
