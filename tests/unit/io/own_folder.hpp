// SPDX-License-Identifier: Apache-2.0
// A folder for the files of one test process, removed at the end; not collective.
#pragma once
#include <unistd.h>

#include <filesystem>
#include <string>

namespace brunt::test {

struct OwnFolder {
  std::string path;
  explicit OwnFolder(const std::string& name) {
    static int count = 0;
    path = (std::filesystem::temp_directory_path() /
            ("brunt_" + name + "_" + std::to_string(::getpid()) + "_" + std::to_string(count++)))
               .string();
    std::filesystem::create_directories(path);
  }
  ~OwnFolder() { std::filesystem::remove_all(path); }
  OwnFolder(const OwnFolder&) = delete;
  OwnFolder& operator=(const OwnFolder&) = delete;
};

}  // namespace brunt::test
