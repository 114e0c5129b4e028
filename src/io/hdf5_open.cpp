// SPDX-License-Identifier: Apache-2.0
// The HDF5 opener: opens files with the communicator of the run. The only file of io that sees MPI.
#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

#include "comm/native.hpp"
#include "hdf5_handle.hpp"

namespace brunt::io {
namespace {

// A file whose closing failed (full disk) remains in the tables of HDF5, and HDF5 1.10 crashes when it cleans them up:
// at exit, or in MPI_Finalize if MPI was started first. Every file is closed by its owner, so no clean-up is needed:
// HDF5 is started before main, hence before MPI, and without work at exit.
[[maybe_unused]] const bool started_before_mpi = H5dont_atexit() >= 0 && H5open() >= 0;

// MPI-IO does not report why a file cannot be opened, so the root rank asks the operating system first.
std::string system_reason(const comm::Communicator& ranks, const std::string& path, int flags) {
  std::string reason;
  if (ranks.is_root()) {
    const int file = ::open(path.c_str(), flags, 0666);
    if (file < 0)
      reason = std::strerror(errno);
    else
      ::close(file);
  }
  ranks.broadcast(reason);
  return reason;
}

hid_t parallel_access(const comm::Communicator& ranks) {
  H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);  // failures are thrown, not printed
  const hid_t access = H5Pcreate(H5P_FILE_ACCESS);
  H5Pset_fapl_mpio(access, comm::native(ranks), MPI_INFO_NULL);
  return access;
}

}  // namespace

hid_t create_parallel(const comm::Communicator& ranks, const std::string& path, std::string& reason) {
  reason = system_reason(ranks, path, O_WRONLY | O_CREAT);
  if (!reason.empty()) return -1;
  const Handle access(parallel_access(ranks), H5Pclose);
  const hid_t file = H5Fcreate(path.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, access.id());
  if (file < 0) reason = hdf5_reason();  // before the next call of HDF5 clears it
  return file;
}

hid_t open_parallel(const comm::Communicator& ranks, const std::string& path, bool writable, std::string& reason) {
  reason = system_reason(ranks, path, writable ? O_RDWR : O_RDONLY);
  if (!reason.empty()) return -1;
  const Handle access(parallel_access(ranks), H5Pclose);
  const hid_t file = H5Fopen(path.c_str(), writable ? H5F_ACC_RDWR : H5F_ACC_RDONLY, access.id());
  if (file < 0) reason = hdf5_reason();
  return file;
}

hid_t collective_transfer() {
  const hid_t transfer = H5Pcreate(H5P_DATASET_XFER);
  H5Pset_dxpl_mpio(transfer, H5FD_MPIO_COLLECTIVE);
  return transfer;
}

}  // namespace brunt::io
