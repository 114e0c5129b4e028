// SPDX-License-Identifier: Apache-2.0
// Faces against the boxes of possible contact partners: near now, or on a straight path.
#include "setup/likely_slaves.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <utility>

#include "contact/data/tolerances.hpp"
#include "contact/surface/passes.hpp"
#include "core/cells.hpp"
#include "core/error.hpp"
#include "flight_shadow.hpp"
#include "geometry/box.hpp"
#include "geometry/closest_point.hpp"
#include "geometry/shortest_edge.hpp"
#include "mesh/topology.hpp"

namespace brunt::setup {
namespace {

struct Face {
  geometry::Box box{};
  Vec3 area = Vec3::Zero(), velocity = Vec3::Zero();
  double size = 0, shortest = 0;  ///< longest edge, shortest edge [length]
  std::int32_t body = 0, block = 0;
};

/// The faces of one body that belong to one block.
struct Patch {
  std::vector<std::size_t> faces;
  geometry::Box box;
  Vec3 velocity = Vec3::Zero();  ///< mean
};

using Patches = std::map<std::pair<std::int32_t, std::int32_t>, Patch>;

std::vector<LocalIndex> corners_of(const mesh::Mesh& mesh, const mesh::Side& side) {
  const mesh::Block& block = nth(mesh.blocks, side.block);
  const auto nodes = mesh::face_nodes(block.shape, block.element(side.element), side.face);
  std::vector<LocalIndex> corners(nodes.begin(), nodes.end());
  std::erase(corners, no_index);
  return corners;
}

Face measure(const mesh::Mesh& mesh, const mesh::Side& side, std::span<const Vec3> velocity, std::int32_t body) {
  Face face{.body = body, .block = side.block};
  std::vector<Vec3> corners;
  for (const LocalIndex node : corners_of(mesh, side)) {
    corners.push_back(nth(mesh.coordinates, node));
    face.velocity += nth(velocity, node);
  }
  face.velocity /= static_cast<double>(corners.size());
  face.box = geometry::bounding_box(corners);
  face.area = geometry::area_vector(corners);
  face.size = geometry::longest_edge(corners);
  face.shortest = geometry::shortest_edge(corners);
  return face;
}

std::vector<Face> measure_faces(const mesh::Mesh& mesh, std::span<const mesh::Side> sides,
                                std::span<const Vec3> velocity, std::span<const std::int32_t> body_of_element) {
  std::vector<LocalIndex> first{0};
  for (const mesh::Block& block : mesh.blocks) first.push_back(first.back() + block.count());
  std::vector<Face> faces;
  faces.reserve(sides.size());
  for (const mesh::Side& side : sides) {
    const LocalIndex element = nth(first, side.block) + side.element;
    faces.push_back(measure(mesh, side, velocity, nth(body_of_element, element)));
  }
  return faces;
}

/// Volume by tetrahedra: exact for plane faces.
double volume(const mesh::Mesh& mesh, const mesh::Block& block, LocalIndex element) {
  const LocalIndex* nodes = block.element(element);
  const auto corner = [&](int c) -> const Vec3& { return nth(mesh.coordinates, nodes[c]); };
  const auto of = [&](const std::array<int, 4>& tet) {
    const Vec3& first = corner(tet[0]);
    return (corner(tet[1]) - first).cross(corner(tet[2]) - first).dot(corner(tet[3]) - first) / 6;
  };
  double sum = 0;
  for (const cells::Tetrahedron& tet : cells::of(block.shape).tetrahedra) sum += of(tet);
  return sum;
}

std::vector<double> mass_of_nodes(const mesh::Mesh& mesh, std::span<const double> density) {
  std::vector<double> mass(mesh.coordinates.size(), 0.0);
  for (std::size_t b = 0; b < mesh.blocks.size(); ++b) {
    const mesh::Block& block = mesh.blocks[b];
    const int corners = mesh::nodes_per_element(block.shape);
    for (LocalIndex e = 0; e < block.count(); ++e) {
      const double share = density[b] * volume(mesh, block, e) / corners;
      for (int c = 0; c < corners; ++c) nth(mass, block.element(e)[c]) += share;
    }
  }
  return mass;
}

std::vector<contact::BodyFigures> figures_of(const mesh::Mesh& mesh, std::span<const mesh::Side> sides,
                                             std::span<const Face> faces, std::span<const double> density) {
  std::int32_t last_body = no_index;
  for (const Face& face : faces) last_body = std::max(last_body, face.body);
  std::vector<contact::BodyFigures> bodies(static_cast<std::size_t>(last_body + 1));
  std::vector<double> face_count(bodies.size(), 0.0), node_count(bodies.size(), 0.0);
  const std::vector<double> mass = mass_of_nodes(mesh, density);
  std::vector<char> counted(mass.size(), 0);
  for (std::size_t f = 0; f < faces.size(); ++f) {
    const auto body = static_cast<std::size_t>(faces[f].body);
    bodies[body].mean_area += faces[f].area.norm();
    bodies[body].longest_edge = std::max(bodies[body].longest_edge, faces[f].size);
    bodies[body].shortest_edge = std::min(bodies[body].shortest_edge, faces[f].shortest);
    ++face_count[body];
    for (const LocalIndex node : corners_of(mesh, sides[f])) {
      const auto i = static_cast<std::size_t>(node);
      if (std::exchange(counted[i], 1) != 0) continue;
      bodies[body].mean_mass += mass[i];
      ++node_count[body];
    }
  }
  for (std::size_t body = 0; body < bodies.size(); ++body) {
    bodies[body].mean_area /= std::max(face_count[body], 1.0);
    bodies[body].mean_mass /= std::max(node_count[body], 1.0);
  }
  return bodies;
}

Patches patches_of(std::span<const Face> faces) {
  Patches patches;
  for (std::size_t f = 0; f < faces.size(); ++f) {
    Patch& patch = patches[{faces[f].body, faces[f].block}];
    patch.faces.push_back(f);
    geometry::extend(patch.box, faces[f].box.low);
    geometry::extend(patch.box, faces[f].box.high);
    patch.velocity += faces[f].velocity;
  }
  for (auto& [key, patch] : patches) patch.velocity /= static_cast<double>(patch.faces.size());
  return patches;
}

/// Whether the straight path from `start` intersects the box.
bool passes_through(const geometry::Box& box, const Vec3& start, const Vec3& way) {
  double enter = 0, leave = 1;
  for (int a = 0; a < 3; ++a) {
    if (way[a] == 0) {
      if (start[a] < box.low[a] || start[a] > box.high[a]) return false;
      continue;
    }
    const double one = (box.low[a] - start[a]) / way[a], other = (box.high[a] - start[a]) / way[a];
    enter = std::max(enter, std::min(one, other));
    leave = std::min(leave, std::max(one, other));
  }
  return enter <= leave;
}

/// farthest: longer paths are truncated.
bool may_reach(const Face& face, const Patch& other, double duration, double farthest) {
  const geometry::Box near = geometry::grown(face.box, face.size);
  if (geometry::overlaps(near, other.box)) return true;
  const Vec3 velocity = face.velocity - other.velocity;
  const double speed = velocity.norm();
  if (!(speed > 0) || velocity.dot(face.area) <= 0) return false;  // at rest, or moving into its own body
  const Vec3 way = std::min(duration, farthest / speed) * velocity;
  const Vec3 reach = 0.5 * (near.high - near.low);
  return passes_through({other.box.low - reach, other.box.high + reach}, 0.5 * (near.low + near.high), way);
}

/// The patch's nodes, projected along the direction `way` of the motion.
FlightShadow shadow_of(const mesh::Mesh& mesh, std::span<const mesh::Side> sides, const Patch& patch, const Vec3& way) {
  std::vector<Vec3> nodes;
  for (const std::size_t f : patch.faces)
    for (const LocalIndex node : corners_of(mesh, sides[f])) nodes.push_back(nth(mesh.coordinates, node));
  return {way, nodes};
}

/// Whether all nodes of the face have coincident nodes there. In the second of two passes they then have no rows (see
/// detect_faces).
bool has_coincident_nodes(const mesh::Mesh& mesh, const mesh::Side& side, double within, const FlightShadow& others) {
  return std::ranges::all_of(corners_of(mesh, side),
                             [&](LocalIndex node) { return others.passes_by(nth(mesh.coordinates, node), within); });
}

double span_of(const geometry::Box& a, const geometry::Box& b) {
  return (a.high.cwiseMax(b.high) - a.low.cwiseMin(b.low)).norm();
}

}  // namespace

std::vector<contact::BodyFigures> body_figures(const mesh::Mesh& mesh, std::span<const mesh::Side> sides,
                                               std::span<const double> density) {
  demand(density.size() == mesh.blocks.size(), "one density for each block");
  const std::vector<Vec3> at_rest(mesh.coordinates.size(), Vec3::Zero());
  return figures_of(mesh, sides, measure_faces(mesh, sides, at_rest, mesh::bodies(mesh)), density);
}

std::vector<mesh::Side> likely_slaves(const mesh::Mesh& mesh, std::span<const mesh::Side> sides,
                                      const contact::Specification& specification, const Outlook& outlook) {
  demand(outlook.density.size() == mesh.blocks.size(), "one density for each block");
  demand(outlook.velocity.size() == mesh.coordinates.size(), "one velocity for each node");
  const std::vector<Face> faces = measure_faces(mesh, sides, outlook.velocity, mesh::bodies(mesh));
  const std::vector<contact::BodyFigures> bodies = figures_of(mesh, sides, faces, outlook.density);
  const Patches patches = patches_of(faces);
  std::vector<char> likely(faces.size(), 0);
  bool any_pair = false;
  for (const auto& [own, slave] : patches)
    for (const auto& [others, master] : patches) {
      if (own.first == others.first) continue;  // self-contact is not predicted
      const contact::SurfaceNode node{{&own.second, 1}, own.first};
      if (!contact::may_meet(specification, bodies, node, others.second, others.first)) continue;
      any_pair = true;
      const double farthest = span_of(slave.box, master.box);
      const bool second = !contact::is_primary_slave(specification, bodies, node, others.second, others.first);
      std::optional<FlightShadow> shadow;
      for (const std::size_t f : slave.faces) {
        if (likely[f] != 0 || !may_reach(faces[f], master, outlook.duration, farthest)) continue;
        if (second && !shadow) shadow = shadow_of(mesh, sides, master, slave.velocity - master.velocity);
        if (!second ||
            !has_coincident_nodes(mesh, sides[f], specification.tolerances->coincidence * faces[f].size, *shadow))
          likely[f] = 1;
      }
    }
  if (!any_pair) return {};
  const bool nothing_near = std::ranges::find(likely, 1) == likely.end();
  std::vector<mesh::Side> chosen;
  for (std::size_t f = 0; f < sides.size(); ++f)
    if (nothing_near || likely[f] != 0) chosen.push_back(sides[f]);
  return chosen;
}

}  // namespace brunt::setup
