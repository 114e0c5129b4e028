// SPDX-License-Identifier: Apache-2.0
#include "placed_beyond.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "scene/build/select.hpp"
#include "scene/text/units.hpp"

namespace brunt::app {
namespace {

constexpr double accuracy = 1e-5;  // of a part's displacement: that of a walk (depth/assembly_walk.cpp)

/// The nodes of a part where they were and where they are, several times where elements share them.
struct PartNodes {
  std::vector<Vec3> before, now;
  double farthest = 0;  ///< largest displacement [length]
};

std::vector<PartNodes> nodes_of_parts(const scene::Input& input, const mesh::Mesh& mesh, std::span<const Vec3> before) {
  const std::vector<std::size_t> part_of = scene::parts_of_blocks(input, mesh);
  std::vector<PartNodes> parts(input.parts.size());
  for (std::size_t b = 0; b < mesh.blocks.size(); ++b) {
    PartNodes& part = parts[part_of[b]];
    const mesh::Block& block = mesh.blocks[b];
    for (LocalIndex e = 0; e < block.count(); ++e)
      for (int i = 0; i < mesh::nodes_per_element(block.shape); ++i) {
        const auto node = static_cast<std::size_t>(block.element(e)[i]);
        part.before.push_back(before[node]);
        part.now.push_back(mesh.coordinates[node]);
        part.farthest = std::max(part.farthest, (part.now.back() - part.before.back()).norm());
      }
  }
  return parts;
}

/// Of the points, behind the plane [length]; none: negative.
double depth_behind(const Vec3& point, const Vec3& normal, std::span<const Vec3> points) {
  double most = -std::numeric_limits<double>::infinity();
  for (const Vec3& x : points) most = std::max(most, normal.dot(point - x));
  return most;
}

/// How far the part stands behind the plane, if that is farther than before; else 0.
double pushed_behind(const Vec3& point, const Vec3& normal, const PartNodes& part) {
  const double before = depth_behind(point, normal, part.before), now = depth_behind(point, normal, part.now);
  return now > std::max(before, 0.0) + accuracy * part.farthest ? now : 0;
}

/// Towards the side on which the part lay, for the most part.
Vec3 towards(const Vec3& point, const Vec3& normal, const PartNodes& part) {
  double sum = 0;
  for (const Vec3& x : part.before) sum += normal.dot(x - point);
  return sum < 0 ? Vec3(-normal) : normal;
}

}  // namespace

std::vector<std::string> placed_beyond(const scene::Input& input, const mesh::Mesh& mesh,
                                       std::span<const Vec3> before) {
  std::vector<std::string> warnings;
  const std::vector<PartNodes> parts = nodes_of_parts(input, mesh, before);
  const auto warn = [&](const std::string& key, const std::string& part, double depth, const std::string& what) {
    warnings.push_back(fmt::format("{}: initial_overlap: place moves part '{}' {} {}", input.at(key), part,
                                   scene::with_length(depth, input.units), what));
  };
  for (std::size_t p = 0; p < parts.size(); ++p) {
    if (!(parts[p].farthest > 0)) continue;
    const std::string& name = input.parts[p].name;
    for (std::size_t k = 0; k < input.rigid_walls.size(); ++k) {
      const scene::RigidWall& wall = input.rigid_walls[k];
      if (!wall.parts.empty() && std::ranges::find(wall.parts, name) == wall.parts.end()) continue;
      const double depth = pushed_behind(wall.point, wall.normal.normalized(), parts[p]);
      if (depth > 0)
        warn(fmt::format("rigid_walls.{}", k), name, depth, fmt::format("behind rigid wall '{}'", wall.name));
    }
    for (std::size_t k = 0; k < input.symmetry.size(); ++k) {
      const scene::Symmetry& plane = input.symmetry[k];
      const Vec3 normal = towards(plane.point, plane.normal.normalized(), parts[p]);
      const double depth = pushed_behind(plane.point, normal, parts[p]);
      if (depth > 0) warn(fmt::format("symmetry.{}", k), name, depth, "across the plane of symmetry");
    }
  }
  return warnings;
}

}  // namespace brunt::app
