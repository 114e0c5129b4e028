// SPDX-License-Identifier: Apache-2.0
// The stable step of the assembled mesh (scene: run.step_bound: assembled), longer than that of its elements.
//
// Lanczos' iteration from a random motion finds the largest frequency of the mesh of linear elements that resist at
// least as much as the elements do now. It underestimates, by a known share at most but for a
// known probability (J. Kuczynski, H. Wozniakowski, SIAM J. Matrix Anal. Appl. 13 (1992) 1094-1122, theorem 4.2): after
// k products with an operator of n unknowns
//   probability(largest - found > share largest) <= 1.648 sqrt(n) exp(-sqrt(share) (2 k - 1)),
// so that k follows from the added share and the accepted probability. Fixed nodes, rigid bodies, ties and planes of
// symmetry constrain motions, and removed elements leave their masses: all lower the largest frequency (Rayleigh's
// quotient), and the free mesh bounds them.
//
// Between two estimates the bound grows with the element that has stiffened most since (its own bound, or the frequency
// of plane waves), and never exceeds the elements' bound. A new estimate is made when it may allow a longer step:
// elements have stiffened or softened, or were removed.
#pragma once
#include <vector>

#include "force/assembled.hpp"
#include "model/model.hpp"
#include "model/registry.hpp"
#include "time/links.hpp"

namespace brunt::time {

/// Share by which the largest squared frequency found is increased.
constexpr double lanczos_share = 0.1;
/// Probability that this is not sufficient in one estimate.
constexpr double lanczos_risk = 1e-6;
/// Steps for each estimate after the first: about thirty products at 0.6 steps each are less than 2 % of them.
constexpr int estimate_span = 1000;
/// Least number of steps between two estimates: within them the step follows the largest recent rate (time::rate_span).
constexpr int estimate_pause = 100;
/// A gain of the mesh over its elements matters beyond this share of the step.
constexpr double worth_a_step = 0.02;
/// A change of the elements' bounds by this share justifies a new estimate.
constexpr double worth_an_estimate = 0.005;

/// Part of the state: saved and hashed.
struct AssembledStep {
  double rate = 0;           ///< 1/(stable step) of the mesh at the last estimate [1/time]; 0: there is none
  double element_rate = 0;   ///< of its elements then
  double step = -1;          ///< step of the last attempt
  double estimates = 0;      ///< number of estimates
  double outdated = 0;       ///< 1: a new one may allow longer steps
  force::Baseline baseline;  ///< stiffness of the elements at the estimate
};

/// Number of products with the mesh that bounds n unknowns by lanczos_share and lanczos_risk.
int lanczos_products(double unknowns);

/// Whether an estimate is due with the forces of the state's step. It may be called repeatedly for these forces. The
/// first estimate is made immediately; later ones if they may allow longer steps and enough steps have passed for their
/// cost.
bool estimate_is_due(const AssembledStep& assembled, const model::State& state);

/// A new estimate may allow longer steps: elements have been removed.
void outdate(AssembledStep& assembled);

/// 1/(stable step) of the mesh of these elements, whose own bound is `element_rate`; element_rate if the mesh allows no
/// longer step. The dashpots of `linear` are treated as springs. Collective.
double assembled_rate(const model::Model& model, const model::State& state, Links& links, force::LinearElements& linear,
                      double element_rate);

/// An estimate for t_n; without `linear` none is made now. Collective.
void estimate(const model::Model& model, const model::State& state, Links& links, force::LinearElements& linear,
              double element_rate, AssembledStep& assembled);

/// The bound of the step at t_n, for elements whose rates have grown by `growth` (force::ElementReport) since the last
/// estimate; also determines whether that is outdated.
double bounding_rate(AssembledStep& assembled, const model::State& state, double growth, double element_rate);

/// To the arrays of the state.
void add_arrays(const model::Model& model, AssembledStep& assembled, std::vector<model::StateArray>& arrays);

}  // namespace brunt::time
