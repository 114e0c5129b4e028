// SPDX-License-Identifier: Apache-2.0
#include "other_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <initializer_list>

#include "core/letter_case.hpp"

namespace brunt::scene {
namespace {

/// The first line with anything in it, and no comment of a deck ($ in LS-DYNA, ** in Abaqus).
std::string_view first_line(std::string_view text) {
  if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);
  while (!text.empty()) {
    const std::size_t end = std::min(text.find_first_of("\r\n"), text.size());
    std::string_view line = text.substr(0, end);
    line.remove_prefix(std::min(line.find_first_not_of(" \t"), line.size()));
    const bool comment = line.starts_with("**") || (line.starts_with('$') && !line.starts_with("$MeshFormat"));
    if (!line.empty() && !comment) return line;
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return {};
}

bool is_one_of(const std::string& word, std::initializer_list<std::string_view> words) {
  return std::ranges::find(words, word) != words.end();
}

std::string named_as_mesh(std::string_view what, const std::string& file) {
  return fmt::format("invalid scene: the file is {}; expected a scene in YAML that names it: mesh: {{file: {}}}", what,
                     std::filesystem::path(file).filename().string());
}

}  // namespace

std::string fault_of_other_file(std::string_view text, const std::string& file) {
  const std::string extension = lower_case(std::filesystem::path(file).extension().string());
  const std::string line = lower_case(first_line(text));
  if (text.starts_with("CDF") || text.starts_with("\x89HDF")) {
    if (is_one_of(extension, {".h5", ".hdf5"}))
      return "invalid scene: the file is an HDF5 file; expected a scene in YAML, and a checkpoint after --restart";
    return named_as_mesh("an Exodus mesh", file);
  }
  if (line.starts_with("$meshformat")) return named_as_mesh("a Gmsh mesh", file);
  if (line.starts_with('*') && line.size() > 1 && line[1] >= 'a' && line[1] <= 'z') {
    if (line.starts_with("*keyword") || is_one_of(extension, {".k", ".key", ".dyn"}))
      return "invalid scene: the file is an LS-DYNA deck, which is not read; expected a scene in YAML that names an "
             "Exodus, Gmsh or Abaqus mesh: mesh: {file: NAME}";
    return named_as_mesh("an Abaqus input file", file);
  }
  if (is_one_of(extension, {".stl", ".obj", ".ply"}))
    return "invalid scene: the file is a surface of triangles; expected a scene in YAML (brunt depth A B measures how "
           "deep two surfaces overlap)";
  return {};
}

}  // namespace brunt::scene
