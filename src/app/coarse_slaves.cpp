// SPDX-License-Identifier: Apache-2.0
#include "coarse_slaves.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <set>

#include "brunt/contact/likely_slaves.hpp"
#include "brunt/geometry/closest_point.hpp"
#include "brunt/mesh/topology.hpp"
#include "brunt/scene/build.hpp"
#include "brunt/scene/select.hpp"
#include "weights.hpp"

namespace brunt::app {
namespace {

/// Blocks of rubber that slide on finer ones at 5 m/s, with edges 1.5, 1.9, 2.2, 3.3, 6.7 times as long: nodes of the
/// master that are not held (all with `one`) sink by 3, 10, 24, 42, 105 % of an edge of theirs. Up to twice that is
/// what one pass leaves anyway.
constexpr double much_coarser = 2;

class Pairs {
 public:
  Pairs(const scene::Input& input, const mesh::CanonicalMesh& whole)
      : mesh_(whole.mesh),
        blocks_(block_materials(input, mesh_)),
        sides_(contact_faces(input, mesh_)),
        velocity_(scene::initial_velocities(input, mesh_.coordinates, whole.origin, mesh_.node_sets)),
        duration_(input.run.end.value_or(std::numeric_limits<double>::infinity())) {}

  [[nodiscard]] const std::string& part(std::size_t block) const { return blocks_.part[block]; }

  /// Median of the longest edges of the block's faces that may meet the other's [length]; 0 where none may.
  [[nodiscard]] double edge(std::size_t block, std::size_t other) const {
    const std::set<Direction> met = directions(near(other, block));
    std::vector<double> edges;
    for (const Face& face : near(block, other))
      if (std::ranges::any_of(met, [&](const Direction& direction) { return faces_it(face.normal, direction); }))
        edges.push_back(face.edge);
    if (edges.empty()) return 0;
    const auto middle = edges.begin() + static_cast<std::ptrdiff_t>(edges.size() / 2);
    std::ranges::nth_element(edges, middle);
    return *middle;
  }

 private:
  struct Face {
    double edge = 0;  ///< the longest [length]
    Vec3 normal;      ///< unit, outwards
  };
  using Direction = std::array<int, 3>;
  static constexpr int notches = 8;  // normals are sorted into so many a side, or large meshes would cost seconds

  static std::set<Direction> directions(const std::vector<Face>& faces) {
    std::set<Direction> found;
    const auto notch = [](double component) { return static_cast<int>(std::lround(notches * component)); };
    for (const Face& face : faces) found.insert({notch(face.normal[0]), notch(face.normal[1]), notch(face.normal[2])});
    return found;
  }

  /// Sides of a bar that stands on its end are near the ground, but do not meet it.
  static bool faces_it(const Vec3& normal, const Direction& direction) {
    const Vec3 other(direction[0], direction[1], direction[2]);
    return normal.dot(other) < -0.5 * other.norm();
  }

  /// The block's faces that are near the other's or fly on towards them.
  [[nodiscard]] std::vector<Face> near(std::size_t block, std::size_t other) const {
    const auto own = static_cast<std::int32_t>(block);
    contact::PairTable pair(static_cast<std::int32_t>(mesh_.blocks.size()), contact::PairRule::apart);
    pair.set(own, static_cast<std::int32_t>(other), contact::PairRule::slave);
    std::vector<Face> faces;
    for (const mesh::Side& side : contact::likely_slaves(mesh_, sides_, pair, {blocks_.density, velocity_, duration_}))
      if (side.block == own) faces.push_back(measure(side));
    return faces;
  }

  [[nodiscard]] Face measure(const mesh::Side& side) const {
    const mesh::Block& block = mesh_.blocks[static_cast<std::size_t>(side.block)];
    std::vector<Vec3> corners;
    for (const LocalIndex node : mesh::face_nodes(block.shape, block.element(side.element), side.face))
      if (node != no_index) corners.push_back(mesh_.coordinates[static_cast<std::size_t>(node)]);
    return {geometry::longest_edge(corners), geometry::area_vector(corners).normalized()};
  }

  const mesh::Mesh& mesh_;
  BlockMaterials blocks_;
  std::vector<mesh::Side> sides_;
  std::vector<Vec3> velocity_;
  double duration_;
};

std::string describe(const scene::Input& input, const std::string& slave, const std::string& master, double coarse,
                     double fine, bool tied) {
  const std::string finer = fmt::format(
      "{}: part '{}' is the slave of '{}', whose faces are much finer where they meet (edges of {:.3g} "
      "against {:.3g})",
      input.at(scene::contact_key(input, slave, master) + ".slave"), slave, master, fine, coarse);
  if (tied) return finer + fmt::format(": '{}' hangs on few nodes; say slave: {}", master, master);
  return finer + fmt::format(
                     ": its nodes sink in between those of '{}', or pass through, and max_penetration does not "
                     "count them; say slave: {}, or passes: two",
                     slave, master);
}

}  // namespace

std::vector<std::string> warn_of_coarse_slaves(const scene::Input& input, const mesh::CanonicalMesh& whole) {
  std::vector<std::string> warnings;
  const BlockMaterials blocks = block_materials(input, whole.mesh);
  const model::ContactRule rule = scene::contact_rule(input, blocks.part);
  if (std::ranges::all_of(rule.forced_slave, [](std::int8_t forced) { return forced == 0; })) return warnings;
  const Pairs pairs(input, whole);
  const std::size_t n = blocks.part.size();
  for (std::size_t slave = 0; slave < n; ++slave)
    for (std::size_t master = 0; master < n; ++master) {
      const std::size_t pair = slave * n + master;
      const bool one_pass =
          rule.passes[pair] == contact::Passes::one || rule.passes[pair] == contact::Passes::automatic;
      if (slave == master || rule.active[pair] == 0 || rule.forced_slave[pair] <= 0 || !one_pass) continue;
      const double coarse = pairs.edge(slave, master), fine = pairs.edge(master, slave);
      if (fine == 0 || coarse <= much_coarser * fine) continue;
      const bool tied = !rule.tied.empty() && rule.tied[pair] == contact::Tied::yes;
      warnings.push_back(describe(input, pairs.part(slave), pairs.part(master), coarse, fine, tied));
    }
  return warnings;
}

}  // namespace brunt::app
