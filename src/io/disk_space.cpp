// SPDX-License-Identifier: Apache-2.0
// Asks for disk space (see the header).
#include "disk_space.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

#include "on_root.hpp"

namespace brunt::io {
namespace {

// errno of the attempt, 0 if the file may grow.
int try_to_grow(int file, GlobalIndex bytes) {
  struct stat before {};
  if (::fstat(file, &before) != 0) return errno;
  const int error = ::fallocate(file, 0, before.st_size, bytes) == 0 ? 0 : errno;
  if (::ftruncate(file, before.st_size) != 0) return errno;
  return error == EOPNOTSUPP || error == ENOSYS ? 0 : error;
}

}  // namespace

void demand_disk_space(const comm::Communicator& ranks, const std::string& path, GlobalIndex bytes) {
  on_root(ranks, [&] {
    const int file = ::open(path.c_str(), O_WRONLY | O_CREAT, 0666);
    const int error = file < 0 ? errno : try_to_grow(file, bytes);
    if (file >= 0) ::close(file);
    if (error != 0) throw MachineError(fmt::format("{}: cannot write {} bytes: {}", path, bytes, std::strerror(error)));
  });
}

}  // namespace brunt::io
