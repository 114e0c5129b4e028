// SPDX-License-Identifier: Apache-2.0
// Poses of the members of an assembly, and the overlapping pairs.
#pragma once
#include <vector>

#include "depth/assembly.hpp"
#include "depth/encounter.hpp"

namespace brunt::depth {

struct Pose {
  std::vector<RigidMotion> motions;  ///< of each member, in the common axes
};

/// Geometric queries for poses of one assembly.
class Standing {
 public:
  explicit Standing(const Assembly& assembly);

  [[nodiscard]] const Assembly& assembly() const { return assembly_; }
  [[nodiscard]] const Member& member(std::size_t k) const { return assembly_.members[k]; }
  [[nodiscard]] const Body& surface(std::size_t k, std::size_t s) const { return *assembly_.members[k].surfaces[s]; }
  [[nodiscard]] double radius() const { return radius_; }  ///< largest of a surface that may move [length]
  [[nodiscard]] Pose start() const;

  [[nodiscard]] Placement placement(const Pose& pose, std::size_t k) const {
    return moved({}, pose.motions[k], member(k).centroid);
  }
  /// Motion of surface a of the pair relative to surface b.
  [[nodiscard]] Placement relative(const Pose& pose, const MemberPair& pair) const;
  [[nodiscard]] Encounter encounter(const Pose& pose, const MemberPair& pair) const {
    return {surface(pair.a, pair.a_surface), surface(pair.b, pair.b_surface), relative(pose, pair)};
  }
  /// Whether the distance of the surfaces' bounding spheres is below `reach` [length].
  [[nodiscard]] bool near(const Pose& pose, const MemberPair& pair, double reach) const;
  [[nodiscard]] bool collides(const Pose& pose, const MemberPair& pair) const;
  [[nodiscard]] bool free(const Pose& pose) const;
  [[nodiscard]] std::vector<std::size_t> overlapping(const Pose& pose) const;  ///< pairs

  /// sqrt(sum m sigma / sum m) over members that may move [length].
  [[nodiscard]] double length(const Pose& pose) const;
  /// Largest displacement of a point of the member [length].
  [[nodiscard]] double farthest(const Pose& pose, std::size_t k) const;

 private:
  const Assembly& assembly_;
  double radius_ = 0, mass_ = 0;
};

/// Each member at the same fraction of its own screw; outwards for fractions above 1.
[[nodiscard]] Pose along_screws(const Pose& pose, double s);

}  // namespace brunt::depth
