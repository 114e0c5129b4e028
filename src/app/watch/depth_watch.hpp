// SPDX-License-Identifier: Apache-2.0
// Penetration by positions: nodes and sharp edges inside elements of other bodies, whatever contact knows of them.
#pragma once
#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "app/state/prepared.hpp"
#include "contact/deep_nodes.hpp"

namespace brunt::app {

/// Shares of an element, by the scene's guards. Where contact holds all nodes it leaves less than a hundredth of an
/// element, and at edges between nodes up to a tenth in hard impacts (src/contact/surface/README.md): more is worth a
/// warning. What is deeper than an element has been lost: contact reaches half of one, and the result is wrong there.
/// An edge that passes squarely through a plate of one element is so deep but for rounding.
constexpr double but_for_rounding = 1 - 1e-9;

/// From this depth on nodes and edges are looked for, in shares of an element.
inline double least_depth(const scene::Guards& guards) {
  return std::min({scene::Guards{}.depth_warning, guards.depth_warning, guards.depth_step});
}

/// Candidate lists are made when nodes have moved by ContactSettings::motion_share = 0.3 of the mean element depth:
/// with one look in three, nothing moves by more than an element between two looks.
constexpr GlobalIndex lists_between_looks = 3;

/// The surface that is looked at: of explicit contact, or of implicit scenes with mortar contact.
contact::WatchedSurface watched_surface(const Prepared& run);

/// The elements of this rank in which a node may lie: those within the box of another part that may be met, and those
/// at the surface, which a body meets first where it meets itself. position: of the mesh's local nodes. Collective.
std::vector<contact::GhostElement> elements_within_reach(const Prepared& run, const contact::WatchedSurface& watched,
                                                         const contact::VectorView& position);

/// What a message says of it. Collective.
std::string text_of(const Prepared& run, const contact::DeepNode& deep);

class DepthWatch {
 public:
  /// Looks at x_n. Returns warnings, of each pair of parts one. Throws GuardError where a node or an edge is lost,
  /// unless the scene lets bodies begin inside each other or removes elements. Collective.
  std::vector<std::string> look(const Prepared& run);
  /// Have bodies moved far enough since the last look?
  [[nodiscard]] bool is_due(const Prepared& run) const;
  /// The deepest so far.
  [[nodiscard]] const contact::DeepNode& deepest() const { return deepest_; }

 private:
  contact::DeepNode deepest_{};
  GlobalIndex lists_seen_ = 0;
  std::vector<std::pair<std::int32_t, std::int32_t>> reported_;
};

}  // namespace brunt::app
