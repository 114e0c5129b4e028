// SPDX-License-Identifier: Apache-2.0
// A copy of the saved state in memory, to go back to where a run was still right.
#pragma once
#include <vector>

#include "brunt/model/registry.hpp"

namespace brunt::app {

class Snapshot {
 public:
  [[nodiscard]] bool empty() const { return values_.empty(); }
  /// Copies what a checkpoint would hold of this rank. Allocates at the first call, and where records have come in.
  void take(const model::Registry& registry);
  /// Fills the arrays and tables of the same registry with what was taken.
  void give_back(const model::Registry& registry) const;
  /// Forgets the copy and gives its memory back.
  void release() { *this = {}; }

 private:
  std::vector<double> values_;
  std::vector<RecordTable> tables_;
};

}  // namespace brunt::app
