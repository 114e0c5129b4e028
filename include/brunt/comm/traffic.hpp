// SPDX-License-Identifier: Apache-2.0
// What a rank sends: plain counters, read where a run reports its messages.
#pragma once
#include <cstdint>

#include "brunt/comm/communicator.hpp"

namespace brunt::comm {

struct Sent {
  std::int64_t messages = 0;  ///< to other ranks; of collectives the number of calls
  std::int64_t bytes = 0;     ///< of payload, without what MPI adds
};

/// Messages of a rank by kind. What PETSc and HDF5 send for their own ends (building a halo, linear solvers, files) is
/// not in it.
struct Traffic {
  Sent halo;        ///< to neighbours that are known beforehand: halos and ordered sums
  Sent exchange;    ///< to ranks found at run time, and pieces to and from the root
  Sent collective;  ///< reductions, broadcasts, barriers: what this rank brings to each call
};

constexpr Sent operator-(const Sent& a, const Sent& b) {
  return {a.messages - b.messages, a.bytes - b.bytes};
}
constexpr Sent operator+(const Sent& a, const Sent& b) {
  return {a.messages + b.messages, a.bytes + b.bytes};
}
constexpr Traffic operator-(const Traffic& a, const Traffic& b) {
  return {a.halo - b.halo, a.exchange - b.exchange, a.collective - b.collective};
}
constexpr Traffic operator+(const Traffic& a, const Traffic& b) {
  return {a.halo + b.halo, a.exchange + b.exchange, a.collective + b.collective};
}

/// All that this rank has sent through `ranks` and its copies so far. Not collective.
Traffic sent_by(const Communicator& ranks);

}  // namespace brunt::comm
