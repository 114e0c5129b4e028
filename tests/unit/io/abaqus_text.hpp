// SPDX-License-Identifier: Apache-2.0
// An Abaqus input file given as text: the mesh that is read, or what is refused.
#pragma once
#include <fstream>
#include <string>

#include "core/error.hpp"
#include "io/mesh/mesh_file.hpp"
#include "own_folder.hpp"

namespace brunt::test {

inline mesh::Mesh read(const std::string& text) {
  const OwnFolder folder("abaqus");
  const std::string path = folder.path + "/text.inp";
  std::ofstream(path, std::ios::binary) << text;
  return io::read_mesh(path);
}

/// The fault from its place in the file on (":LINE: what"), or "none".
inline std::string fault_of(const std::string& text) {
  try {
    read(text);
  } catch (const InputError& error) {
    const std::string what = error.what();
    return what.substr(what.find(".inp") + 4);
  }
  return "none";
}

}  // namespace brunt::test
