// SPDX-License-Identifier: Apache-2.0
// The one door to mpi.h, for comm, the parallel HDF5 opener, the reference solve and app.
#pragma once
#include <mpi.h>

#include "brunt/comm/communicator.hpp"

namespace brunt::comm {

struct NativeAccess {
  static MPI_Comm of(const Communicator& ranks);
};
inline MPI_Comm native(const Communicator& ranks) {
  return NativeAccess::of(ranks);
}

}  // namespace brunt::comm
