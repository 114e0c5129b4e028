// SPDX-License-Identifier: Apache-2.0
// The mesh: files and generated bodies, one or a list of them.
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "core/excerpt.hpp"
#include "given_body.hpp"
#include "placement.hpp"
#include "scene/read/sections.hpp"

namespace brunt::scene {
namespace {

constexpr const char* body_words =
    "one of {file: path}, {box: {...}}, {cylinder: {...}}, {sphere: {...}}, {tube: {...}}, {torus: {...}}, {plate: "
    "{...}}";

/// An entry, with the file that it may have.
struct GivenMesh {
  MeshFile file;
  MeshEntry entry;
};

void read_ignored(const Key& key, MeshFile& file) {
  for (const Key& name : items(key, "a list of names or numbers of blocks of the file")) {
    std::string& block = file.ignore.emplace_back();
    if (read(name, block, "the name or number of a block of the file") && std::ranges::count(file.ignore, block) > 1)
      fault(name, fmt::format("invalid block '{}': listed twice; expected each block once", excerpt(block)));
  }
}

/// A generated body, which has its placement inside.
Value<GivenMesh> body(const char* kind) {
  return {.type = "map",
          .read =
              [kind](const Key& key, GivenMesh& mesh) {
                GivenBody given(kind);
                body_keys.read(key, given);
                mesh.entry.body = std::move(given.body);
                mesh.entry.placement = std::move(given.placement);
              },
          .inner = {&body_keys}};
}

void judge_mesh(const Key& map, GivenMesh&) {
  const std::vector<std::string> bodies{"file", "box", "cylinder", "sphere", "tube", "torus", "plate"};
  const auto given = std::ranges::count_if(bodies, [&](const std::string& name) { return has(map, name); });
  const std::string what = fmt::format("invalid entry: {} bodies are given; expected {}", given, body_words);
  demand_one(map, bodies, what, what);
  if (!has(map, "file"))
    refuse_any(map, {"prefix", "ignore", "scale", "rotate", "at"},
               "unknown key of a generated body; expected it beside file (scale, rotate and at also inside the body)");
}

const std::vector<Row<MeshFile>> file_rows{
    {"file", value(&MeshFile::file, Text{"text", "the path of a mesh file"}), "-",
     "Path relative to the scene file: Exodus II, Gmsh MSH 2.2 or 4.1 (ASCII), or Abaqus input. The content decides.",
     "required, or a body"},
    {"prefix", value(&MeshFile::prefix, Text{"text", "a text that precedes the names of blocks and sets"}), "-",
     "Text that is put before the names of the blocks and sets of the file.", "empty"},
    {"ignore", special("list", read_ignored), "-", "Names or numbers of blocks that are excluded, without the prefix."},
};
const std::vector<Row<GivenMesh>> body_rows{
    {"box", body("box"), "-", "Box with one corner at the origin.", "required, or another body"},
    {"cylinder", body("cylinder"), "-", "Solid cylinder along z with its foot at the origin.",
     "required, or another body"},
    {"sphere", body("sphere"), "-", "Solid sphere with its centre at the origin.", "required, or another body"},
    {"tube", body("tube"), "-", "Tube along z with its foot at the origin.", "required, or another body"},
    {"torus", body("torus"), "-", "Hollow torus around z with its centre at the origin.", "required, or another body"},
    {"plate", body("plate"), "-", "Plate in the x-y plane; the centre of its lower face is the origin.",
     "required, or another body"},
};
const Table<GivenMesh> mesh_keys{
    "mesh",
    body_words,
    joined(joined(within(&GivenMesh::file, file_rows), body_rows),
           within(&GivenMesh::entry, within(&MeshEntry::placement, placement_rows()))),
    judge_mesh,
};

void read_entry(const Key& key, Input& input) {
  GivenMesh mesh;
  if (!mesh_keys.read(key, mesh)) return;
  mesh.entry.key = key.path;
  if (has(key, "file")) {  // relative to the scene
    const std::filesystem::path folder = std::filesystem::path(input.file).parent_path();
    mesh.file.file = (folder / mesh.file.file).lexically_normal().string();
    mesh.entry.body = std::move(mesh.file);
  }
  input.mesh.push_back(std::move(mesh.entry));
}

void read_one_or_more(const Key& key, Input& input) {
  if (!is_list(key)) return read_entry(key, input);
  for (const Key& entry : items(key, body_words)) read_entry(entry, input);
  if (key.tree->children.empty()) wrong(key, "a list of at least one body or file");
}

}  // namespace

Value<Input> mesh_value() {
  return special("map or list", read_one_or_more, {&mesh_keys});
}

}  // namespace brunt::scene
