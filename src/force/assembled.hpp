// SPDX-License-Identifier: Apache-2.0
// The assembled mesh as a linear operator: what its elements, linear ones that resist at least as much as they do now
// (element::BatchStiffness), do to a small motion. An element in a mesh cannot take the shape in which it is quickest
// when it is free, since its neighbours would have to take the opposite one: the mesh is slower than its elements.
#pragma once
#include <span>
#include <vector>

#include "core/aligned.hpp"
#include "model/model.hpp"

namespace brunt::force {

/// Entries for a batch: the six entries of element::BatchStiffness in their order, then the rate.
enum LinearEntry { at_lambda, at_mu, at_viscosity, at_spring, at_dashpot, at_plane2, at_rate, linear_entries };

/// Linear elements, by block: [batch][LinearEntry][lane].
using LinearElements = std::vector<AlignedVector<double>>;

/// Stiffness of the elements at an earlier time, by block: [batch][2][lane], 1/rate^2 and 1/plane2.
using Baseline = std::vector<AlignedVector<double>>;

/// What a pass over the elements keeps for bounds of the assembled mesh; where a span is empty it keeps nothing.
struct StepWatch {
  std::span<const AlignedVector<double>> baseline{};  ///< growth over it is told in ElementReport::growth
  std::span<AlignedVector<double>> linear{};          ///< written
};

/// Sized for all elements of the model, zero; nothing of rigid blocks.
LinearElements sized_linear(const model::Model& model);
Baseline sized_baseline(const model::Model& model);

/// What is written is how stiff the elements are.
void take_baseline(const LinearElements& linear, Baseline& baseline);

/// Dashpots become springs: stiffness plus 2/dt damping. A step dt of central differences with damping taken at the
/// half step before is stable where dt^2 stiffness/4 + dt damping/2 <= mass for every motion, that is where
/// dt^2/4 (stiffness + 2/dt damping) <= mass (of one frequency: element::stable_rate).
void include_damping(LinearElements& linear, double dt);

/// One motion of the mesh and the forces that its elements answer with.
struct LinearMotion {
  std::span<const model::NodeLine> nodes;               ///< x: places; v: the motion
  std::span<const std::vector<std::uint8_t>> living{};  ///< as Motion::living
  std::span<Quad> force;    ///< by node: minus stiffness times motion; border nodes: partial
  std::span<double> slots;  ///< corner forces of border nodes, as Scratch::slots
};

void linear_forces(const model::Model& model, const LinearElements& linear, const LinearMotion& motion);

}  // namespace brunt::force
