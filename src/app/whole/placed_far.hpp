// SPDX-License-Identifier: Apache-2.0
// Judges how far a placement moves parts out of the parts that they overlap.
#pragma once
#include <optional>
#include <span>
#include <vector>

#include "scene_assembly.hpp"
#include "setup/initial_gaps.hpp"

namespace brunt::app {

/// A member and a member that it overlaps, as the mesh has them.
struct FarMotion {
  std::size_t member = 0, other = 0;
  std::size_t block = 0, other_block = 0;  ///< the two that overlap deepest
  double overlap = 0;                      ///< [length]
  double motion =
      0;  ///< of the member relative to the other one, as far as its own displacement accounts for it [length]
};

/// The member that the motions carry farthest, in units of the overlap, out of all members that it overlaps; none
/// beyond `scene::most_overlaps`. A member is judged by the neighbour beside which it moves least: a row of parts that
/// are pushed apart one after the other moves far as a whole, and each part little beside the next. Of two members the
/// smaller counts of the relative displacement and of that which the member's own one implies: a neighbour that other
/// overlaps push aside slides along a member, far but not out of it.
///
/// The overlap of two surfaces is the larger of two measures, both of the surfaces as they are given: the depth below
/// which no motion separates them (depth/lower_bound.hpp), and the penetration of the deepest node of either inside the
/// other (setup/initial_gaps.hpp). The first also sees edges without nodes inside, the second overlaps far from all
/// balls. judged: of each member, whether it counts.
[[nodiscard]] std::optional<FarMotion> placed_far(const SceneAssembly& scene, const setup::InitialGaps& gaps,
                                                  const depth::AssemblyAnswer& answer, std::span<const char> judged);

}  // namespace brunt::app
