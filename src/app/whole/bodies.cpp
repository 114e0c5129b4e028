// SPDX-License-Identifier: Apache-2.0
#include "bodies.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <type_traits>
#include <variant>

#include "core/error.hpp"
#include "core/excerpt.hpp"
#include "io/mesh/mesh_file.hpp"
#include "mesh/assemble.hpp"
#include "mesh/check.hpp"
#include "mesh/duplicate_elements.hpp"
#include "mesh/primitives.hpp"
#include "mesh/resolution.hpp"
#include "mesh/shell_bodies.hpp"

namespace brunt::app {
namespace {

template <class Body>
constexpr bool may_be_shell = requires(const Body& body) {
  body.shell;
};

mesh::Mesh solid_of(const scene::BoxMesh& body) {
  return mesh::box(body.part, body.size, body.elements);
}
mesh::Mesh solid_of(const scene::SphereMesh& body) {
  return mesh::sphere(body.part, body.radius, body.elements, {body.finer, body.half});
}
mesh::Mesh solid_of(const scene::TubeMesh& body) {
  return mesh::tube(body.part, body.inner_radius, body.outer_radius, body.length, body.elements, body.half);
}
mesh::Mesh solid_of(const scene::PlateMesh& body) {
  return mesh::plate(body.part, body.size, body.thickness, body.elements);
}

mesh::Mesh shells_of(const scene::BoxMesh& body) {
  return mesh::shell_box(body.part, body.size, body.elements, body.open);
}
mesh::Mesh shells_of(const scene::SphereMesh& body) {
  return mesh::shell_sphere(body.part, body.radius, body.elements, {body.finer, body.half});
}
mesh::Mesh shells_of(const scene::TubeMesh& body) {
  mesh::Divisions<2> elements;
  for (const std::size_t i : {0, 1}) elements[i] = body.elements[i + 1];
  return mesh::shell_tube(body.part, 0.5 * (body.inner_radius + body.outer_radius), body.length, elements, body.half);
}
mesh::Mesh shells_of(const scene::PlateMesh& body) {
  mesh::Divisions<2> elements;
  for (const std::size_t i : {0, 1}) elements[i] = body.elements[i];
  return mesh::shell_plate(body.part, body.size, elements);
}

mesh::Mesh generate(const scene::MeshEntry& entry) {
  return std::visit(
      [](const auto& body) {
        using Body = std::decay_t<decltype(body)>;
        if constexpr (std::is_same_v<Body, scene::MeshFile>)
          return io::read_mesh(body.file, body.ignore);
        else if constexpr (may_be_shell<Body>)
          return body.shell ? shells_of(body) : solid_of(body);
        else if constexpr (std::is_same_v<Body, scene::CylinderMesh>)
          return mesh::cylinder(body.part, body.radius, body.length, body.elements, body.half);
        else
          return mesh::torus(body.part, body.radius, body.tube[0], body.tube[1], body.elements);
      },
      entry.body);
}

/// Generated quadrilaterals of a part of triangles are split.
void split_for_part(const scene::Input& input, mesh::Mesh& piece) {
  const auto part = std::ranges::find(input.parts, piece.blocks.front().name, &scene::Part::block);
  if (part != input.parts.end() && part->element == element::ElementKind::shell3) mesh::split_into_triangles(piece);
}

/// Puts the body in its place; what is wrong with it there.
std::string place(mesh::Mesh& piece, const scene::Placement& placement) {
  double farthest = placement.at.cwiseAbs().maxCoeff();
  for (const Vec3& x : piece.coordinates) farthest = std::max(farthest, placement.scale * x.cwiseAbs().maxCoeff());
  const std::vector<scene::Rotation> none(1), &turns = placement.rotate.empty() ? none : placement.rotate;
  double scale = placement.scale;
  for (const scene::Rotation& turn : turns) {
    mesh::place(piece, scale, turn.axis, turn.degrees, &turn == &turns.back() ? placement.at : Vec3::Zero());
    scale = 1;
  }
  return mesh::resolution_fault(piece, farthest);
}

}  // namespace

mesh::Mesh assemble(const scene::Input& input, std::vector<std::string>& warnings) {
  mesh::Mesh whole;
  std::vector<std::string> faults;
  std::vector<int> piece_of_block;
  int pieces = 0;
  for (const scene::MeshEntry& entry : input.mesh) {
    const auto* file = std::get_if<scene::MeshFile>(&entry.body);
    const std::string where = file ? input.at(entry.key + ".file") + ": " + file->file : input.at(entry.key);
    try {
      mesh::Mesh piece = generate(entry);
      if (file == nullptr) split_for_part(input, piece);
      const mesh::CheckReport report = mesh::check(piece, file ? mesh::MeshSource::file : mesh::MeshSource::generated);
      for (const std::string& fault : report.faults) faults.push_back(where + ": " + fault);
      for (const std::string& warning : report.warnings) warnings.push_back(where + ": " + warning);
      for (std::string& note : piece.notes)
        if (!file || !note.starts_with(file->file)) note.insert(0, (file ? file->file : entry.key) + ": ");
      if (!report.faults.empty()) continue;
      if (const std::string fault = place(piece, entry.placement); !fault.empty())
        faults.push_back(where + ": " + fault);
      piece_of_block.insert(piece_of_block.end(), piece.blocks.size(), pieces++);
      mesh::append(whole, std::move(piece), file ? file->prefix : "", file ? file->file : "");
    } catch (const InputError& error) {
      for (const std::string& fault : error.faults())
        faults.push_back(file && fault.starts_with(file->file) ? input.at(entry.key + ".file") + ": " + fault
                                                               : where + ": " + fault);
    }
  }
  if (faults.empty())
    for (const std::string& fault : mesh::coincident_elements(whole, piece_of_block))
      faults.push_back(input.at("mesh") + ": " + fault);
  if (!faults.empty()) throw InputError(std::move(faults));
  return whole;
}

std::vector<std::string> left_out_lines(const mesh::Mesh& mesh) {
  std::vector<std::string> lines;
  for (const mesh::LeftOut& block : mesh.left_out)
    lines.push_back(fmt::format("excluded: block {}, {} element{} of type {}",
                                block.name.empty() ? std::to_string(block.id) : excerpt(block.name), block.count,
                                block.count == 1 ? "" : "s", excerpt(block.type)));
  lines.insert(lines.end(), mesh.notes.begin(), mesh.notes.end());
  return lines;
}

}  // namespace brunt::app
