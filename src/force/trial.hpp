// SPDX-License-Identifier: Apache-2.0
// The internal force as a function of the motion of the nodes and the history of the elements. An implicit step can
// evaluate it any number of times before one result is committed.
#pragma once
#include <span>
#include <vector>

#include "force/internal.hpp"
#include "model/model.hpp"

namespace brunt::force {

/// History of the elements, by block: [batch][component][lane], as State::history.
using History = std::vector<AlignedVector<double>>;

/// One step of the nodes, from x - v dt to x.
struct Motion {
  std::span<const model::NodeLine> nodes;  ///< positions x at its end, mean velocities v of it; masses are not read
  double dt = 1;        ///< its length [time]; 1 if there is no time (a static state), and v is then the increment
  bool viscous = true;  ///< with bulk viscosity, and the viscous hourglass control of one-point hexahedra
  std::span<const std::vector<std::uint8_t>> living{};  ///< lanes as model::Living has them; none: all elements live
  StepWatch watch{};
  std::span<const model::RotationLine> rotations{};  ///< by node: rates of rotation of the step; none without shells
};

/// Forces at the end of the step in `scratch`, as after internal_forces. Histories advance from `committed`, at the
/// start of the step, to `trial`, at its end. `trial` must be a copy of `committed` initially, since masses are not
/// written. The two may be the same, as in an explicit step; otherwise `committed` is unchanged.
ElementReport trial_forces(const model::Model& model, const Motion& motion, const History& committed, History& trial,
                           model::Scratch& scratch);

/// Commits a trial: its values are copied, so that pointers into the committed histories (the registry) remain valid.
void commit(const History& trial, History& committed);

}  // namespace brunt::force
