// SPDX-License-Identifier: Apache-2.0
// What io/hdf5 needs of the HDF5 library beside its calls: ids that close themselves, the reason of a failure, and
// the parallel opener (the only place where HDF5 meets MPI).
#pragma once
#include <hdf5.h>

#include <string>
#include <utility>

#include "comm/communicator.hpp"

namespace brunt::io {

class Handle {
 public:
  using Close = herr_t (*)(hid_t);
  Handle(hid_t id, Close close) : id_(id), close_(close) {}
  ~Handle() {
    if (id_ >= 0) close_(id_);
  }
  Handle(const Handle&) = delete;
  Handle& operator=(const Handle&) = delete;
  [[nodiscard]] hid_t id() const { return id_; }
  [[nodiscard]] bool good() const { return id_ >= 0; }

 private:
  hid_t id_;
  Close close_;
};

/// The innermost message of HDF5's error stack.
std::string hdf5_reason();

/// The first non-empty text in order of rank, on all ranks. Collective.
std::string first_reason(const comm::Communicator& ranks, const std::string& mine);

/// Ids of files opened by all ranks together; negative on failure, then `reason` says why: what the operating system
/// answered the root rank, else what HDF5 said on this one. Collective.
hid_t create_parallel(const comm::Communicator& ranks, const std::string& path, std::string& reason);
hid_t open_parallel(const comm::Communicator& ranks, const std::string& path, bool writable, std::string& reason);

/// Property list of a collective transfer.
hid_t collective_transfer();

}  // namespace brunt::io
