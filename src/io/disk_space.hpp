// SPDX-License-Identifier: Apache-2.0
// Tests whether a file may grow, before the ranks write together: if the disk fills up inside a collective HDF5 call,
// the failing ranks leave it and the others wait for ever.
#pragma once
#include <string>

#include "comm/communicator.hpp"
#include "core/types.hpp"

namespace brunt::io {

/// Lets the file (created if necessary) grow by `bytes` and shrinks it again. Throws MachineError on all ranks if the
/// disk, a quota or a limit refuses; file systems without allocation in advance are trusted. Collective.
void demand_disk_space(const comm::Communicator& ranks, const std::string& path, GlobalIndex bytes);

/// The size of a table with its share of the file's own records.
constexpr GlobalIndex table_bytes(GlobalIndex rows, int width) {
  return rows * width * 8 + 4096;
}

}  // namespace brunt::io
