// SPDX-License-Identifier: Apache-2.0
// External forces: gravity, mass-proportional damping, pressure on faces.
#pragma once
#include <span>
#include <vector>

#include "model/model.hpp"

namespace brunt::force {

/// The coefficient alpha of mass damping at this time [1/time]; 0 if it does not act.
double damping_rate(const model::Model& model, double time);

/// Gravity at t_n on every local node, into scratch.load.
void body_loads(const model::Model& model, const model::State& state, model::Scratch& scratch);

/// Forces of pressure on current faces, one Quad for each node of each face of each load, in order; the length of
/// `slots` is that of pressure_corners(model).
void pressure_forces(const model::Model& model, const model::State& state, std::span<Quad> slots);

struct PressureCorner {
  GlobalIndex key = 0;  ///< unique at a node, the same on any number of ranks
  LocalIndex node = 0;
};
std::vector<PressureCorner> pressure_corners(const model::Model& model);

}  // namespace brunt::force
