// SPDX-License-Identifier: Apache-2.0
// Implicit steps through which nothing passes. Mortar contact sees facets that are near at the iterates of a step. What
// a step moves from one side of a body to the other, or deep into it, it has not seen. Each step is therefore judged by
// positions: on the straight way from x_n to x_{n+1}, in parts no longer than half of the thinnest element, no node and
// no sharp edge may come deeper into another body by more than a fifth of an element, and no rigid body, which walls
// hold by springs, into a rigid wall. Sliding is no crossing: a chord of a convex surface is shallow.
#pragma once
#include <string>
#include <vector>

#include "app/state/prepared.hpp"

namespace brunt::app {

/// Surfaces and pairs, if the scene has mortar contact that is no tie, or rigid bodies at rigid walls. Collective.
void watch_implicit(Prepared& run);

/// Of each rigid body: how deep it lies behind rigid walls, or how much deeper than at t_n, over the depth of its
/// thinnest element. Of a watched run. Collective.
[[nodiscard]] std::vector<double> shares_behind_walls(const Prepared& run, bool since_last);

/// Why the step from x_n (reference + displacement of the state) to the present positions is inadmissible; empty if it
/// is not. The same on all ranks. Collective.
[[nodiscard]] std::string objection_to_step(Prepared& run);

}  // namespace brunt::app
