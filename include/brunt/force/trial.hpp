// SPDX-License-Identifier: Apache-2.0
// The internal force as a function of where the nodes are, how they came there and what the elements remember: it can
// be asked as often as an implicit step likes before one answer is kept.
#pragma once
#include <span>
#include <vector>

#include "brunt/force/internal.hpp"
#include "brunt/model/model.hpp"

namespace brunt::force {

/// What elements remember, by block: [batch][component][lane], as State::history.
using History = std::vector<AlignedVector<double>>;

/// One step of the nodes, from x - v dt to x.
struct Motion {
  std::span<const model::NodeLine> nodes;  ///< positions x at its end, mean velocities v of it; masses are not read
  double dt = 1;        ///< its length [time]; where there is no time (a static state) 1, and v is the increment
  bool viscous = true;  ///< with bulk viscosity, and the viscous hourglass control of one-point hexahedra
  std::span<const std::vector<std::uint8_t>> living{};  ///< lanes as model::Living has them; none: all elements live
  StepWatch watch{};
};

/// Forces at the end of the step in `scratch`, as internal_forces leaves them. Histories go from `committed`, at its
/// start, to `trial`, at its end: sized and begun as a copy of the committed ones, since masses are not written. The
/// two may be the same, as they are in an explicit step; else the committed ones stay as they are.
ElementReport trial_forces(const model::Model& model, const Motion& motion, const History& committed, History& trial,
                           model::Scratch& scratch);

/// Keeps a trial: its values are copied, so that whoever points into the committed histories (the registry) still does.
void commit(const History& trial, History& committed);

}  // namespace brunt::force
