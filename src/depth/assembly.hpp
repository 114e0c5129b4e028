// SPDX-License-Identifier: Apache-2.0
// Several rigid bodies at once: the smallest motions after which none of the listed pairs overlaps.
//
//   minimise sum_k m_k sigma_k,   sigma_k = |T_k|^2 + 4 v_k^T J_k v_k   (the object norm squared, see metric.hpp)
//
// over all members that may move. It is the metric of Zhang, Kim, Manocha (2007) for one body, which is additive over
// bodies: m sigma is the integral of rho |d|^2. Two free bodies that overlap by d along a line move by d m_2/(m_1 +
// m_2) and d m_1/(m_1 + m_2), and without constrained partners sum_k m_k T_k = 0.
//
// First, free configurations are determined: by translations along the normals of separating planes of the pairs, and
// by the screws of single pairs, divided in the ratio of the masses. From each a descent as in walk.hpp follows, with a
// quadratic program over all members. The result is free and a local minimum. It is a function of the input only.
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "depth/body.hpp"
#include "depth/rigid_motion.hpp"

namespace brunt::depth {

/// Surfaces that move as one, in the common axes in which all members are given.
struct Member {
  std::vector<const Body*> surfaces;
  double mass = 0;                ///< [mass]
  Vec3 centroid = Vec3::Zero();   ///< of mass [length]
  Mat3 gyration = Mat3::Zero();   ///< J: inertia about the centroid / mass [length^2]
  Mat3 basis = Mat3::Identity();  ///< of admitted translations: orthonormal columns, zero ones for those forbidden
  bool turns = true;
  [[nodiscard]] bool moves() const { return turns || !basis.isZero(0); }
};

/// A member without constraints. densities: of each surface, positive [mass/length^3].
[[nodiscard]] Member make_member(std::span<const Body* const> surfaces, std::span<const double> densities);

/// Surfaces that must not overlap.
struct MemberPair {
  std::size_t a = 0, a_surface = 0;  ///< member, and one of its surfaces
  std::size_t b = 0, b_surface = 0;
};

struct Assembly {
  std::vector<Member> members;
  std::vector<MemberPair> pairs;  ///< of different members
};

struct AssemblyOptions {
  double clearance = 1e-8;  ///< left between surfaces, in units of the largest radius of a member that moves
  int most_steps = 100;     ///< of one walk
};

struct AssemblyAnswer {
  bool found = false;                ///< no pair overlaps after the motions
  std::vector<RigidMotion> motions;  ///< of each member about its centroid, in the common axes; none if not found
  std::vector<double> farthest;      ///< largest displacement of a point of each member [length]
  double length = 0;                 ///< sqrt(sum m sigma / sum m) over the members that may move [length]
  std::vector<std::size_t> left;     ///< not found: pairs that could not be separated
  int walks = 0, steps = 0;
};

/// Pairs that only touch count as overlapping: they end with the clearance. Throws std::invalid_argument for a pair
/// within one member.
[[nodiscard]] AssemblyAnswer place_apart(const Assembly& assembly, const AssemblyOptions& options = {});

}  // namespace brunt::depth
