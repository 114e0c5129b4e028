// SPDX-License-Identifier: Apache-2.0
// Connections between the ranks during a step: built once, used in every step.
#pragma once
#include "comm/communicator.hpp"
#include "comm/exact_sum.hpp"
#include "comm/ordered_sum.hpp"
#include "contact/data/carriers.hpp"
#include "contact/detection/detection.hpp"
#include "core/aligned.hpp"
#include "core/simd.hpp"
#include "core/timers.hpp"
#include "force/loads.hpp"
#include "model/model.hpp"
#include "surface/exposed.hpp"
#include "time/flow.hpp"

namespace brunt::time {

struct Links {
  comm::Communicator ranks;
  comm::OrderedSum corner_forces{};   ///< corner forces of elements at the border between ranks
  comm::OrderedSum corner_moments{};  ///< likewise of shells, if the model has any
  std::vector<force::PressureCorner> pressure_corners{};
  comm::OrderedSum pressure{};
  AlignedVector<Quad> pressure_slots{};
  AlignedVector<Quad> pressure_sum{};  ///< by node; empty without pressure
  std::vector<contact::Wall> walls{};  ///< positions of the model's walls at t_n
  Timers timers{};
  std::vector<comm::ExactAccumulator> body_sums{};  ///< forces and moments on rigid bodies
  std::vector<double> body_forces{};                ///< the same, rounded
  std::vector<contact::Carrier> carriers{};         ///< rigid bodies in the form that contact needs
  std::vector<contact::CoupledBodies> coupled{};    ///< those with joints
  SurfaceFlow flow{};                               ///< for contact with Impact::elastic
  surface::InnerFaces inner_faces{};  ///< faces that removals may expose; none if the scene has no removals
};

/// Numbers the slots of border corners in the model and links the ranks. Collective.
Links link_ranks(const comm::Communicator& ranks, model::Model& model);

}  // namespace brunt::time
