// SPDX-License-Identifier: Apache-2.0
// The mesh: files and generated bodies, one or a list of them.
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "core/excerpt.hpp"
#include "read_bodies.hpp"
#include "scene/read/sections.hpp"

namespace brunt::scene {
namespace {

constexpr std::string_view rotations = "a map {axis: [x, y, z], degrees: number}, or a list of them";

void read_rotation(const Key& key, Rotation& rotation) {
  Section rotate(key, rotations);
  rotate.required("axis", rotation.axis, Vector::direction);
  rotate.required("degrees", rotation.degrees, any_number);
}

void read_placement(Section& body, Placement& placement) {
  body.optional("scale", placement.scale, positive);
  body.optional("at", placement.at, Vector::any);
  if (!body.has("rotate")) return;
  const Key key = body.at("rotate");
  if (key.tree->kind != Tree::Kind::list) return read_rotation(key, placement.rotate.emplace_back());
  for (const Key& one : items(key, rotations)) read_rotation(one, placement.rotate.emplace_back());
}

MeshFile read_file(Section& entry, const std::string& scene_file, Placement& placement) {
  MeshFile mesh;
  if (entry.required("file", mesh.file, "the path of a mesh file")) {
    const std::filesystem::path folder = std::filesystem::path(scene_file).parent_path();
    mesh.file = (folder / mesh.file).lexically_normal().string();
  }
  entry.optional("prefix", mesh.prefix, "a text that precedes the names of blocks and sets");
  constexpr std::string_view blocks = "a list of names or numbers of blocks of the file";
  if (entry.has("ignore"))
    for (const Key& name : items(entry.at("ignore"), blocks)) {
      std::string& block = mesh.ignore.emplace_back();
      if (read(name, block, "the name or number of a block of the file") &&
          std::count(mesh.ignore.begin(), mesh.ignore.end(), block) > 1)
        fault(name, fmt::format("invalid block '{}': listed twice; expected each block once", excerpt(block)));
    }
  read_placement(entry, placement);
  return mesh;
}

BoxMesh read_box(Section& body) {
  BoxMesh box{.part = {}, .size = Vec3::Ones(), .elements = {1, 1, 1}};
  body.required("part", box.part, part_name);
  std::array<double, 3> size{1, 1, 1};
  body.required("size", size, positive, "three lengths > 0 [x, y, z]");
  box.size = Vec3(size[0], size[1], size[2]);
  const std::array<Extent, 3> extents{{{0, size[0], "along x"}, {0, size[1], "along y"}, {0, size[2], "along z"}}};
  read_divisions(body, extents, box.elements, "three integers >= 1 [along x, y, z]");
  const double x = box.elements[0], y = box.elements[1], z = box.elements[2];
  demand_countable(body, (x + 1) * (y + 1) * (z + 1), x * y * z);
  return box;
}

PlateMesh read_plate(Section& body) {
  PlateMesh plate{.part = {}, .size = {1, 1}, .elements = {1, 1, 1}};
  body.required("part", plate.part, part_name);
  body.required("size", plate.size, positive, "two lengths > 0 [x, y]");
  body.required("thickness", plate.thickness, positive);
  const auto& [width, depth] = plate.size;
  const std::array<Extent, 3> extents{
      {{-width / 2, width / 2, "along x"}, {-depth / 2, depth / 2, "along y"}, {0, plate.thickness, "along z"}}};
  read_divisions(body, extents, plate.elements, "three integers >= 1 [along x, y, z]");
  const double x = plate.elements[0], y = plate.elements[1], z = plate.elements[2];
  demand_countable(body, (x + 1) * (y + 1) * (z + 1), x * y * z);
  return plate;
}

constexpr std::string_view body_words =
    "one of {file: path}, {box: {...}}, {cylinder: {...}}, {sphere: {...}}, {tube: {...}}, {torus: {...}}, {plate: "
    "{...}}";

template <class Body>
bool read_body(Section& entry, std::string_view kind, Body (*reader)(Section&), MeshEntry& target) {
  if (!entry.has(kind)) return false;
  Section body(entry.at(kind), "a map with the part, sizes and elements of the body");
  if (body.is_map()) target.body = reader(body);
  read_placement(body, target.placement);
  return true;
}

void read_entry(const Key& key, Input& input) {
  Section entry(key, body_words);
  if (!entry.is_map()) return;
  MeshEntry mesh;
  mesh.key = key.path;
  int bodies = 0;
  bodies += read_body(entry, "box", read_box, mesh) ? 1 : 0;
  bodies += read_body(entry, "cylinder", read_cylinder, mesh) ? 1 : 0;
  bodies += read_body(entry, "sphere", read_sphere, mesh) ? 1 : 0;
  bodies += read_body(entry, "tube", read_tube, mesh) ? 1 : 0;
  bodies += read_body(entry, "torus", read_torus, mesh) ? 1 : 0;
  bodies += read_body(entry, "plate", read_plate, mesh) ? 1 : 0;
  if (entry.has("file")) {
    ++bodies;
    mesh.body = read_file(entry, input.file, mesh.placement);
  }
  const std::string what = fmt::format("invalid entry: {} bodies are given; expected {}", bodies, body_words);
  if (bodies == 0) lacking(key, {"file", "box", "cylinder", "sphere", "tube", "torus", "plate"}, what);
  if (bodies > 1) fault(key, what);
  input.mesh.push_back(std::move(mesh));
}

}  // namespace

void read_mesh(Section& scene, Input& input) {
  const Key key = scene.at("mesh");
  if (key.tree == nullptr || key.tree->kind != Tree::Kind::list) return read_entry(key, input);
  for (const Key& entry : items(key, body_words)) read_entry(entry, input);
  if (key.tree->children.empty()) wrong(key, "a list of at least one body or file");
}

}  // namespace brunt::scene
