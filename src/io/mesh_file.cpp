// SPDX-License-Identifier: Apache-2.0
// Which reader for which file, and what all readers end with.
#include "brunt/io/mesh_file.hpp"

#include <fmt/core.h>

#include <filesystem>
#include <fstream>

#include "abaqus_deck.hpp"
#include "brunt/core/error.hpp"
#include "brunt/io/abaqus.hpp"
#include "brunt/io/exodus.hpp"
#include "brunt/io/gmsh.hpp"
#include "brunt/mesh/check.hpp"
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

namespace {

/// The first bytes; of a text those behind a byte-order mark of UTF-8 and blank lines.
std::string start_of(const std::string& path) {
  constexpr std::streamsize enough = 16;  // longer than each signature
  std::ifstream file(path, std::ios::binary);
  std::string start(enough, '\0');
  file.read(start.data(), enough);
  if (file.bad() || (!file && file.gcount() == 0))
    throw InputError(fmt::format(
        "{}: cannot read the mesh file, or it is empty; expected Exodus II, Gmsh MSH 2.2 or 4.1, or Abaqus .inp",
        path));
  file.clear();
  file.seekg(start.starts_with("\xEF\xBB\xBF") ? 3 : 0);
  file >> std::ws;
  std::string text(enough, '\0');
  file.read(text.data(), enough);
  return text.starts_with('*') ? text : start;
}

}  // namespace

mesh::Mesh read_mesh(const std::string& path, const std::vector<std::string>& ignore) {
  if (std::filesystem::is_directory(path))
    throw InputError(fmt::format("{}: invalid mesh file: it is a folder; expected a regular file", path));
  std::error_code unknown;
  if (std::filesystem::exists(path, unknown) && !std::filesystem::is_regular_file(path, unknown))
    throw InputError(fmt::format("{}: invalid mesh file; expected a regular file", path));
  const std::string start = start_of(path);
  if (start.starts_with("CDF") || start.starts_with("\x89HDF")) return read_exodus(path, ignore);
  if (start.starts_with("$MeshFormat") || start.starts_with("$Comments")) return read_gmsh(path, ignore);
  if (start.starts_with("\xFF\xFE") || start.starts_with("\xFE\xFF"))
    throw InputError(fmt::format("{}: invalid text: it is written in UTF-16; expected ASCII or UTF-8", path));
  if (start.starts_with('*') && !in_capitals(start).starts_with("*KEYWORD")) return read_abaqus(path, ignore);
  throw InputError(
      fmt::format("{}: unknown kind of mesh file; expected Exodus II, Gmsh MSH 2.2 or 4.1, or Abaqus .inp", path));
}

}  // namespace brunt::io
