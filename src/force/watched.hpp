// SPDX-License-Identifier: Apache-2.0
// Corners of elements whose forces are needed individually: those of sections, and those on nodes of several parts.
#pragma once
#include <span>
#include <vector>

#include "model/model.hpp"

namespace brunt::force {

/// The corners of the block on `nodes` (ascending, all of them in Model::watched or shared by ranks), ascending by
/// element, then by corner. Call it after the slots are numbered.
std::vector<model::WatchedCorner> watched_corners(const model::ElementBlock& block, std::span<const LocalIndex> nodes);

/// Force of the element on the corner's node at t_n (minus the internal force).
inline Vec3 corner_force(const model::Scratch& scratch, const model::WatchedCorner& corner) {
  const double* f = &scratch.slots[4 * static_cast<std::size_t>(corner.slot)];
  return {f[0], f[1], f[2]};
}

/// Likewise of a shell: its moment about the node.
inline Vec3 corner_moment(const model::Scratch& scratch, const model::WatchedCorner& corner) {
  const double* m = &scratch.moment_slots[4 * static_cast<std::size_t>(corner.slot)];
  return {m[0], m[1], m[2]};
}

/// After the step from t_n: adds to State::interface_work the work of the elements on nodes between parts, each impulse
/// times the mean of the velocities before and after.
void book_interface(const model::Model& model, model::State& state, const model::Scratch& scratch, double dt_mean);

/// Adds to State::interface_work the work of the elements on nodes between parts that move with their present
/// velocities for a given time.
void add_interface_work(const model::Model& model, model::State& state, const model::Scratch& scratch, double time);

}  // namespace brunt::force
