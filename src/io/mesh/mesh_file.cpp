// SPDX-License-Identifier: Apache-2.0
// Which reader for which file, and what all readers end with.
#include "io/mesh/mesh_file.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <filesystem>
#include <fstream>

#include "core/error.hpp"
#include "core/letter_case.hpp"
#include "io/mesh/abaqus.hpp"
#include "io/mesh/exodus.hpp"
#include "io/mesh/gmsh.hpp"
#include "io/text_file.hpp"
#include "mesh/check.hpp"
#include "sound_mesh.hpp"

namespace brunt::io {

mesh::Mesh sound_mesh(const std::string& path, mesh::Mesh&& mesh) {
  auto faults = mesh::check(mesh).faults;
  for (auto& fault : faults) fault = fmt::format("{}: {}", path, fault);
  if (!faults.empty()) throw InputError(faults);
  return std::move(mesh);
}

std::array<int, 8> hex_corners(int count) {
  if (count == 6) return {0, 1, 2, 2, 3, 4, 5, 5};
  if (count == 5) return {0, 1, 2, 3, 4, 4, 4, 4};
  return {0, 1, 2, 3, 4, 5, 6, 7};
}

mesh::Mesh read_mesh(const std::string& path, const std::vector<std::string>& ignore) {
  if (std::filesystem::is_directory(path))
    throw InputError(fmt::format("{}: invalid mesh file: it is a folder; expected a regular file", path));
  std::error_code unknown;
  if (std::filesystem::exists(path, unknown) && !std::filesystem::is_regular_file(path, unknown))
    throw InputError(fmt::format("{}: invalid mesh file; expected a regular file", path));
  std::ifstream file(path, std::ios::binary);
  std::string start(4096, '\0');
  file.read(start.data(), static_cast<std::streamsize>(start.size()));
  start.resize(static_cast<std::size_t>(file.gcount()));
  if (file.bad() || start.empty())
    throw InputError(fmt::format(
        "{}: cannot read the mesh file, or it is empty; expected Exodus II, Gmsh MSH 2.2 or 4.1, or Abaqus .inp",
        path));
  if (start.starts_with("CDF") || start.starts_with("\x89HDF")) return read_exodus(path, ignore);
  refuse_utf16(start, path);
  const std::size_t mark = start.starts_with("\xEF\xBB\xBF") ? 3 : 0;
  const std::string text = start.substr(std::min(start.find_first_not_of(" \t\r\n", mark), start.size()));
  if (text.starts_with("$MeshFormat") || text.starts_with("$Comments")) return read_gmsh(path, ignore);
  if (text.starts_with('*') && !upper_case(text).starts_with("*KEYWORD")) return read_abaqus(path, ignore);
  throw InputError(
      fmt::format("{}: unknown kind of mesh file; expected Exodus II, Gmsh MSH 2.2 or 4.1, or Abaqus .inp", path));
}

}  // namespace brunt::io
