// SPDX-License-Identifier: Apache-2.0
// One time step of the central difference method: `evaluate` computes the forces at t_n, `advance` the step to t_{n+1}.
//
//   f  = - internal(u_n, history) + loads(t_n)             summed over elements in canonical order
//   v* = v_{n-1/2} + (dt_{n-1/2} + dt_{n+1/2})/2 W f       W the mobility: inverse mass times the free directions, and
//                                                          mass damping with it: see motion.hpp
//   v_{n+1/2} = v* + W G^T impulses                        contact and walls
//   u_{n+1} = u_n + dt_{n+1/2} v_{n+1/2}
//
// Fields written for t_n are those between the two calls: u_n and stresses of t_n.
#pragma once
#include <limits>

#include "force/internal.hpp"
#include "model/model.hpp"
#include "time/assembled_step.hpp"
#include "time/links.hpp"

namespace brunt::contact {
struct Contact;
}

namespace brunt::time {

/// dt follows the smallest stable step of the last `rate_span` to 2 `rate_span` steps, not the current one. A step that
/// varies with the vibration it integrates supplies energy to it: central differences become unstable if the step
/// varies in time with the motion (R. D. Skeel, BIT 33 (1993) 172-175). So dt is constant over periods below the span,
/// and for small gains.
constexpr int rate_span = 100;

struct StepControl {
  double cfl = 0.9;      ///< share of the stable step that is used
  double growth = 1.02;  ///< largest ratio of successive steps; dt grows by this factor or not at all
  double largest = std::numeric_limits<double>::infinity();  ///< upper bound of dt [time]
  AssembledStep* assembled = nullptr;  ///< set if the assembled mesh bounds the steps of the run; null: its elements do
};

/// Data of the step at t_n, known to all ranks.
struct StepReport {
  double dt = 0;                  ///< t_{n+1} - t_n
  double rate = 0;                ///< largest 1 / (stable step) of the elements of all ranks at t_n
  double dt_mean = 0;             ///< (dt_{n-1/2} + dt_{n+1/2}) / 2: the time over which forces at t_n act
  double bound = 0;               ///< bound of the step: `rate`, or less by the assembled mesh [1/time]
  double stable_dt = 0;           ///< limit by `bound` and StepControl::largest, before those of growth and damping
  double alpha = 0;               ///< of the mass damping that acts at t_n [1/time]
  force::ElementReport elements;  ///< of this rank
  bool stop = false;              ///< a rank requests a stop (one of its guards)
  [[nodiscard]] double drag() const { return 0.5 * alpha * dt_mean; }
};

/// Forces, stresses and history at t_n, and the length of the next step. Collective.
StepReport evaluate(const model::Model& model, model::State& state, model::Scratch& scratch, Links& links,
                    const StepControl& control);

/// The rigid walls as input of contact: position at t_n, velocity at `time`.
std::vector<contact::Wall> walls_at(const model::Model& model, const model::State& state, double time);

/// From t_n to t_{n+1}. `contact` is null if the scene has neither contact nor walls. Collective.
void advance(const model::Model& model, model::State& state, model::Scratch& scratch, Links& links,
             contact::Contact* contact, const StepReport& step);

}  // namespace brunt::time
