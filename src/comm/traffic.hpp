// SPDX-License-Identifier: Apache-2.0
// Counters of the messages sent by a rank.
#pragma once
#include <cstdint>

#include "comm/communicator.hpp"

namespace brunt::comm {

struct Sent {
  std::int64_t messages = 0;  ///< to other ranks; for collectives the number of calls
  std::int64_t bytes = 0;     ///< of payload, without the overhead of MPI
};

/// Messages of a rank by kind. Internal messages of PETSc and HDF5 (building a halo, linear solvers, files) are not
/// counted.
struct Traffic {
  Sent halo;        ///< to neighbours that are known in advance: halos and ordered sums
  Sent exchange;    ///< to ranks determined at run time, and pieces to and from the root
  Sent collective;  ///< reductions, broadcasts, barriers: the contribution of this rank to each call
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

/// All messages sent by this rank through `ranks` and its copies so far. Not collective.
Traffic sent_by(const Communicator& ranks);

}  // namespace brunt::comm
