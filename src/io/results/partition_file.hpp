// SPDX-License-Identifier: Apache-2.0
// A stored partition for a later run: the rank that computes each element.
//
// Layout of partition.h5 in its folder: attributes of /: partition_format, parts, fingerprint, scene; /part [elements]:
// in canonical order.
#pragma once
#include <span>
#include <string>
#include <vector>

#include "core/types.hpp"

namespace brunt::io {

struct PartitionFile {
  int parts = 1;
  std::string fingerprint, scene;  ///< as in a checkpoint: of which scene
  std::vector<Rank> part;          ///< of each element in canonical order
};

/// For the root only. Writing creates the folder and throws MachineError; reading throws InputError for an invalid
/// partition or a part out of range.
void write_partition(const std::string& folder, const PartitionFile& partition);
[[nodiscard]] PartitionFile read_partition(const std::string& folder);

}  // namespace brunt::io
