// SPDX-License-Identifier: Apache-2.0
// The only header that includes mpi.h: for comm, the parallel HDF5 files, the reference solution and app.
#pragma once
#include <mpi.h>

#include <cstddef>
#include <cstdint>

#include "comm/communicator.hpp"
#include "comm/traffic.hpp"

namespace brunt::comm {

struct NativeAccess {
  static MPI_Comm of(const Communicator& ranks);
  static Communicator on(MPI_Comm ranks);           ///< a private copy; collective
  static Traffic& sent(const Communicator& ranks);  ///< its counters, for comm alone
};
inline MPI_Comm native(const Communicator& ranks) {
  return NativeAccess::of(ranks);
}

/// Counts messages that this rank sends, `bytes` in all.
inline void add_sent(Sent& sent, std::size_t messages, std::size_t bytes) {
  sent.messages += static_cast<std::int64_t>(messages);
  sent.bytes += static_cast<std::int64_t>(bytes);
}
/// Counts one collective call, to which this rank contributes `bytes`.
inline void count_collective(const Communicator& ranks, std::size_t bytes) {
  add_sent(NativeAccess::sent(ranks).collective, 1, bytes);
}

}  // namespace brunt::comm
