// SPDX-License-Identifier: Apache-2.0
// A folder for the files of one test, the same on all ranks, removed at the end.
#pragma once
#include <unistd.h>

#include <filesystem>
#include <string>

#include "comm/communicator.hpp"

namespace brunt::test {

class ScratchFolder {
 public:
  explicit ScratchFolder(const comm::Communicator& ranks) : ranks_(ranks) {
    path_ = (std::filesystem::temp_directory_path() / ("brunt_io_" + std::to_string(::getpid()))).string();
    ranks_.broadcast(path_);
    if (ranks_.is_root()) std::filesystem::create_directories(path_);
    ranks_.barrier();
  }
  ~ScratchFolder() {
    ranks_.barrier();
    if (ranks_.is_root()) std::filesystem::remove_all(path_);
    ranks_.barrier();
  }
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;
  [[nodiscard]] const std::string& path() const { return path_; }
  [[nodiscard]] std::string operator/(const std::string& name) const { return path_ + "/" + name; }

 private:
  comm::Communicator ranks_;
  std::string path_;
};

}  // namespace brunt::test
