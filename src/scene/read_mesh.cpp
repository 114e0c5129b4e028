// SPDX-License-Identifier: Apache-2.0
// The mesh: files and generated bodies, one or a list of them.
#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>

#include "brunt/scene/sections.hpp"

namespace brunt::scene {
namespace {

constexpr std::string_view part_name = "a name for the part";
constexpr Count cells{1};
/// An axis from 1, with the sign of the side that is kept.
const Choices<int> sides_of_section{{{"x", 1}, {"-x", -1}, {"y", 2}, {"-y", -2}}, {}};
const Choices<int> sides{{{"x", 1}, {"-x", -1}, {"y", 2}, {"-y", -2}, {"z", 3}, {"-z", -3}}, {}};

void read_placement(Section& body, Placement& placement) {
  body.optional("scale", placement.scale, positive);
  body.optional("at", placement.at, Vector::any);
  if (!body.has("rotate")) return;
  Section rotate(body.at("rotate"), "a map {axis: [x, y, z], degrees: number}");
  rotate.required("axis", placement.rotate.axis, Vector::direction);
  rotate.required("degrees", placement.rotate.degrees, any_number);
}

/// `half`, a list of sides that are kept, at most one of an axis; `quarter` is the same with two of them.
void read_half(Section& body, std::array<int, 3>& half, const Choices<int>& choices) {
  const bool quarter = body.has("quarter");
  if (body.has("half") && quarter)
    return fault(body.at("quarter"), "half is given as well; accepted: one of them, such as quarter: [x, y]");
  if (!body.has("half") && !quarter) return;
  std::string words;
  for (const auto& choice : choices.now) words += (words.empty() ? "" : ", ") + choice.first;
  const std::string accepted = fmt::format("a list of {}{}", quarter ? "two of " : "", words);
  const Key key = body.at(quarter ? "quarter" : "half");
  const std::vector<Key> named = items(key, accepted, quarter ? 2 : 0);
  if (named.empty() && key.tree->kind == Tree::Kind::list && key.tree->children.empty() && !quarter)
    wrong(key, accepted);
  for (const Key& one : named) {
    int side = 0;
    if (!read(one, side, choices)) continue;
    int& kept = half[static_cast<std::size_t>(std::abs(side) - 1)];
    if (kept != 0)
      fault(one,
            fmt::format("'{}': {} stands twice; accepted: each axis once", one.tree->text, "xyz"[std::abs(side) - 1]));
    kept = side > 0 ? 1 : -1;
  }
}

/// A mesh is held with 32-bit indices, and its numbers of nodes and corners must fit.
void demand_countable(Section& body, double nodes, double elements) {
  constexpr double most = std::numeric_limits<LocalIndex>::max();
  if (nodes <= most && 8 * elements <= most) return;
  fault(body.at("elements"),
        fmt::format("{:.3g} elements are too many for one body; accepted: at most {:.3g}", elements, most / 8));
}

MeshFile read_file(Section& entry, const std::string& scene_file, Placement& placement) {
  MeshFile mesh;
  if (entry.required("file", mesh.file, "the path of a mesh file")) {
    const std::filesystem::path folder = std::filesystem::path(scene_file).parent_path();
    mesh.file = (folder / mesh.file).lexically_normal().string();
  }
  entry.optional("prefix", mesh.prefix, "text to put before the names of blocks and sets");
  constexpr std::string_view blocks = "a list of names or numbers of blocks of the file";
  if (entry.has("ignore"))
    for (const Key& name : items(entry.at("ignore"), blocks)) {
      std::string& block = mesh.ignore.emplace_back();
      if (read(name, block, "the name or number of a block of the file") &&
          std::count(mesh.ignore.begin(), mesh.ignore.end(), block) > 1)
        fault(name, fmt::format("'{}' stands twice; accepted: each block once", block));
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
  body.required("elements", box.elements, cells, "three integers >= 1 [along x, y, z]");
  const double x = box.elements[0], y = box.elements[1], z = box.elements[2];
  demand_countable(body, (x + 1) * (y + 1) * (z + 1), x * y * z);
  return box;
}

CylinderMesh read_cylinder(Section& body) {
  CylinderMesh cylinder{.part = {}, .elements = {1, 1}};
  body.required("part", cylinder.part, part_name);
  body.required("radius", cylinder.radius, positive);
  body.required("length", cylinder.length, positive);
  body.required("elements", cylinder.elements, cells, "two integers >= 1 [across the radius, along the axis]");
  read_half(body, cylinder.half, sides_of_section);
  const double across = cylinder.elements[0], along = cylinder.elements[1];
  demand_countable(body, 4 * (across + 1) * (across + 1) * (along + 1), 4 * across * across * along);
  return cylinder;
}

SphereMesh read_sphere(Section& body) {
  SphereMesh sphere{.part = {}, .elements = 1};
  body.required("part", sphere.part, part_name);
  body.required("radius", sphere.radius, positive);
  body.required("elements", sphere.elements, cells);
  body.optional("finer", sphere.finer, Range{1, infinity, true, false, "a number >= 1"});
  read_half(body, sphere.half, sides);
  if (sphere.finer > 1 && sphere.half[2] > 0)
    fault(body.at(body.has("half") ? "half" : "quarter"),
          "z keeps the pole that finer does not refine; accepted: -z, or no half along z");
  const double across = sphere.elements;
  demand_countable(body, 8 * (across + 1) * (across + 1) * (across + 1), 8 * across * across * across);
  return sphere;
}

TubeMesh read_tube(Section& body) {
  TubeMesh tube{.part = {}, .elements = {1, 3, 1}};
  body.required("part", tube.part, part_name);
  const bool inner = body.required("inner_radius", tube.inner_radius, positive);
  const bool outer = body.required("outer_radius", tube.outer_radius, positive);
  if (inner && outer && tube.outer_radius <= tube.inner_radius) {
    fault(body.at("outer_radius"), fmt::format("{} is not larger than inner_radius {}; accepted: a larger one",
                                               tube.outer_radius, tube.inner_radius));
  }
  body.required("length", tube.length, positive);
  body.required("elements", tube.elements, cells, "three integers >= 1 [through the wall, around, along]");
  if (tube.elements[1] < 3) {
    fault(body.at("elements"), fmt::format("{} around do not close; accepted: at least 3 around", tube.elements[1]));
  }
  read_half(body, tube.half, sides_of_section);
  const int parts = (tube.half[0] != 0 ? 2 : 1) * (tube.half[1] != 0 ? 2 : 1);
  if (tube.elements[1] >= 3 && tube.elements[1] % parts != 0)
    fault(body.at("elements"),
          fmt::format("{} elements around the whole cannot be cut into {} equal parts; accepted: a "
                      "multiple of {} around",
                      tube.elements[1], parts, parts));
  const double through = tube.elements[0], around = tube.elements[1], along = tube.elements[2];
  demand_countable(body, (through + 1) * around * (along + 1), through * around * along);
  return tube;
}

PlateMesh read_plate(Section& body) {
  PlateMesh plate{.part = {}, .size = {1, 1}, .elements = {1, 1, 1}};
  body.required("part", plate.part, part_name);
  body.required("size", plate.size, positive, "two lengths > 0 [x, y]");
  body.required("thickness", plate.thickness, positive);
  body.required("elements", plate.elements, cells, "three integers >= 1 [along x, y, z]");
  const double x = plate.elements[0], y = plate.elements[1], z = plate.elements[2];
  demand_countable(body, (x + 1) * (y + 1) * (z + 1), x * y * z);
  return plate;
}

constexpr std::string_view body_words =
    "one of {file: path}, {box: {...}}, {cylinder: {...}}, {sphere: {...}}, {tube: {...}}, {plate: {...}}";

template <class Body>
bool read_body(Section& entry, std::string_view kind, Body (*reader)(Section&), MeshEntry& target) {
  if (!entry.has(kind)) return false;
  Section body(entry.at(kind), "a map that says the body's part, sizes and elements");
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
  bodies += read_body(entry, "plate", read_plate, mesh) ? 1 : 0;
  if (entry.has("file")) {
    ++bodies;
    mesh.body = read_file(entry, input.file, mesh.placement);
  }
  const std::string what = fmt::format("{} bodies in one entry; accepted: {}", bodies, body_words);
  if (bodies == 0) lacking(key, {"file", "box", "cylinder", "sphere", "tube", "plate"}, what);
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
