// SPDX-License-Identifier: Apache-2.0
#include "setup/coarse_slaves.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

#include "contact/data/tolerances.hpp"
#include "geometry/closest_point.hpp"
#include "mesh/topology.hpp"
#include "setup/likely_slaves.hpp"

namespace brunt::setup {
namespace {

class Pairs {
 public:
  Pairs(const mesh::Mesh& mesh, const StartRules& rules, std::span<const Vec3> velocity, double duration)
      : mesh_(mesh),
        tolerances_(*rules.contact.tolerances),
        sides_(contact_faces(mesh, rules.symmetric)),
        outlook_{.density = rules.density, .velocity = velocity, .duration = duration} {}

  /// Median of the longest edges of the block's faces that may meet the other's [length]; 0 if there are none.
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
  static constexpr int notches = 8;  // classes of normals for each axis: without them large meshes would take seconds

  static std::set<Direction> directions(const std::vector<Face>& faces) {
    std::set<Direction> found;
    const auto notch = [](double component) { return static_cast<int>(std::lround(notches * component)); };
    for (const Face& face : faces) found.insert({notch(face.normal[0]), notch(face.normal[1]), notch(face.normal[2])});
    return found;
  }

  /// Whether the face is directed towards the other body: lateral faces near it do not meet it.
  [[nodiscard]] bool faces_it(const Vec3& normal, const Direction& direction) const {
    const Vec3 other(direction[0], direction[1], direction[2]);
    return normal.dot(other) < -tolerances_.facing * other.norm();
  }

  /// The block's faces that are near the other's or move towards them.
  [[nodiscard]] std::vector<Face> near(std::size_t block, std::size_t other) const {
    const auto own = static_cast<std::int32_t>(block);
    contact::Specification alone{.pairs = {mesh_.blocks.size(), {}}};
    alone.pairs.set(own, static_cast<std::int32_t>(other), {.rule = contact::PairRule::slave});
    std::vector<Face> faces;
    for (const mesh::Side& side : likely_slaves(mesh_, sides_, alone, outlook_))
      if (side.block == own) faces.push_back(measure(side));
    return faces;
  }

  [[nodiscard]] Face measure(const mesh::Side& side) const {
    const mesh::Block& block = nth(mesh_.blocks, side.block);
    std::vector<Vec3> corners;
    for (const LocalIndex node : mesh::face_nodes(block.shape, block.element(side.element), side.face))
      if (node != no_index) corners.push_back(nth(mesh_.coordinates, node));
    return {geometry::longest_edge(corners), geometry::area_vector(corners).normalized()};
  }

  const mesh::Mesh& mesh_;
  const contact::Tolerances& tolerances_;
  std::vector<mesh::Side> sides_;
  Outlook outlook_;
};

}  // namespace

std::vector<CoarseSlave> coarse_slaves(const mesh::Mesh& mesh, const StartRules& rules, std::span<const Vec3> velocity,
                                       double duration) {
  std::vector<CoarseSlave> found;
  if (!rules.contact.pairs.forces_a_side()) return found;
  const Pairs pairs(mesh, rules, velocity, duration);
  const std::size_t n = mesh.blocks.size();
  for (std::size_t slave = 0; slave < n; ++slave)
    for (std::size_t master = 0; master < n; ++master) {
      const auto a = static_cast<std::int32_t>(slave), b = static_cast<std::int32_t>(master);
      const contact::PairSpecification& pair = rules.contact.pairs.at(a, b);
      const bool one_pass = pair.passes == contact::Passes::one || pair.passes == contact::Passes::automatic;
      if (slave == master || pair.rule != contact::PairRule::slave || !one_pass) continue;
      const double coarse = pairs.edge(slave, master), fine = pairs.edge(master, slave);
      if (fine > 0 && coarse > rules.contact.tolerances->coarse_slave * fine)
        found.push_back({slave, master, coarse, fine});
    }
  return found;
}

}  // namespace brunt::setup
