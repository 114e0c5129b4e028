// SPDX-License-Identifier: Apache-2.0
#include "mortar_slaves.hpp"

#include <algorithm>

#include "core/sorted.hpp"
#include "geometry/box.hpp"
#include "geometry/closest_point.hpp"
#include "mesh/topology.hpp"
#include "scene/build/build.hpp"
#include "scene/build/select.hpp"

namespace brunt::app {
namespace {

using Slave = scene::ContactEntry::Slave;

/// The faces of one part.
struct Surface {
  std::vector<mesh::Side> sides;
  std::vector<geometry::Box> boxes;  ///< of each
  geometry::Box box;                 ///< of all
  double longest = 0, sum = 0;       ///< edges: the longest of all, the sum of the longest of each [length]

  [[nodiscard]] bool finer_than(const Surface& other) const {
    return sum * static_cast<double>(other.sides.size()) < other.sum * static_cast<double>(sides.size());
  }
};

Surface surface_of(const scene::Input& input, const mesh::Mesh& mesh, const std::vector<mesh::Side>& exterior,
                   const std::string& part) {
  const std::vector<std::size_t> part_of_block = scene::parts_of_blocks(input, mesh);
  Surface surface;
  std::vector<Vec3> corners;
  for (const mesh::Side& side : exterior) {
    const auto b = static_cast<std::size_t>(side.block);
    if (input.parts[part_of_block[b]].name != part) continue;
    corners.clear();
    for (const LocalIndex node :
         mesh::face_nodes(mesh.blocks[b].shape, mesh.blocks[b].element(side.element), side.face))
      if (node != no_index) corners.push_back(nth(mesh.coordinates, node));
    surface.sides.push_back(side);
    surface.boxes.push_back(geometry::bounding_box(corners));
    for (const Vec3& corner : corners) geometry::extend(surface.box, corner);
    const double edge = geometry::longest_edge(corners);
    surface.longest = std::max(surface.longest, edge);
    surface.sum += edge;
  }
  return surface;
}

}  // namespace

std::vector<mesh::Side> mortar_slaves(const scene::Input& input, const mesh::Mesh& mesh) {
  std::vector<mesh::Side> all;
  if (std::ranges::none_of(input.contact, &scene::ContactEntry::mortar)) return all;
  const std::vector<mesh::Side> exterior = mesh::exterior_sides(mesh);
  for (const scene::ContactEntry& entry : input.contact) {
    if (!entry.mortar) continue;
    const Surface first = surface_of(input, mesh, exterior, entry.between[0]),
                  second = surface_of(input, mesh, exterior, entry.between[1]);
    const bool swapped = entry.slave == Slave::second || (entry.slave == Slave::automatic && second.finer_than(first));
    const Surface &slave = swapped ? second : first, &master = swapped ? first : second;
    const geometry::Box reach = geometry::grown(master.box, std::max(slave.longest, master.longest));
    const std::size_t before = all.size();
    for (std::size_t k = 0; k < slave.sides.size(); ++k)
      if (geometry::overlaps(reach, slave.boxes[k])) all.push_back(slave.sides[k]);
    if (all.size() == before) all.insert(all.end(), slave.sides.begin(), slave.sides.end());
  }
  sort_unique(all);
  return all;
}

}  // namespace brunt::app
