// SPDX-License-Identifier: Apache-2.0
// The stable step of the assembled mesh (scene: run.step_bound: assembled), longer than that of its elements.
//
// Lanczos' iteration from a random motion finds the largest frequency of the mesh of linear elements that resist at
// least as much as the elements do now. It underestimates, by a known share at most but for a
// known probability (J. Kuczynski, H. Wozniakowski, SIAM J. Matrix Anal. Appl. 13 (1992) 1094-1122, theorem 4.2): after
// k products with an operator of n unknowns
//   probability(largest - found > share largest) <= 1.648 sqrt(n) exp(-sqrt(share) (2 k - 1)),
// so that k follows from the share that is added and the probability that is taken. Fixed nodes, rigid bodies, ties and
// planes of symmetry take motions away, removed elements leave their masses: all lower the largest frequency
// (Rayleigh's quotient), and the free mesh bounds them.
//
// Between two estimates the bound grows with the element that has stiffened most since (its own bound, or the frequency
// of plane waves), and is never above the elements' bound. A new estimate is made where one may give more: elements
// have stiffened or softened, or were removed.
#pragma once
#include <vector>

#include "brunt/force/assembled.hpp"
#include "brunt/model/model.hpp"
#include "brunt/model/registry.hpp"
#include "brunt/time/links.hpp"

namespace brunt::time {

/// By what share the largest squared frequency found is raised.
constexpr double lanczos_share = 0.1;
/// Probability with which that is not enough in one estimate.
constexpr double lanczos_risk = 1e-6;
/// Steps for each estimate after the first: some thirty products at .6 steps each are less than 2 % of them.
constexpr int estimate_span = 1000;
/// Steps between two estimates at least: within them the step follows the quickest one lately (time::rate_span).
constexpr int estimate_pause = 100;
/// What the mesh gives over its elements matters beyond this share of the step.
constexpr double worth_a_step = 0.02;
/// And this change of the elements' bounds is worth a new estimate, paid for as it is.
constexpr double worth_an_estimate = 0.005;

/// Part of the state: saved and hashed.
struct AssembledStep {
  double rate = 0;           ///< 1/(stable step) of the mesh at the last estimate [1/time]; 0: there is none
  double element_rate = 0;   ///< of its elements then
  double step = -1;          ///< at which it was tried last
  double estimates = 0;      ///< so many so far
  double outdated = 0;       ///< 1: a new one may give longer steps
  force::Baseline baseline;  ///< how stiff elements were then
};

/// Products with the mesh that bound n unknowns by lanczos_share and lanczos_risk.
int lanczos_products(double unknowns);

/// Is an estimate to be made with the forces of the state's step? It may have been asked for these forces before. The
/// first one at once; others where they may give more and steps enough have been made for their cost.
bool estimate_is_due(const AssembledStep& assembled, const model::State& state);

/// A new estimate may give longer steps: elements have been removed.
void outdate(AssembledStep& assembled);

/// 1/(stable step) of the mesh of these elements, whose own bound is `element_rate`; element_rate where the mesh allows
/// no more. The dashpots of `linear` become springs. Collective.
double assembled_rate(const model::Model& model, const model::State& state, Links& links, force::LinearElements& linear,
                      double element_rate);

/// An estimate for t_n; without `linear` none is made now. Collective.
void estimate(const model::Model& model, const model::State& state, Links& links, force::LinearElements& linear,
              double element_rate, AssembledStep& assembled);

/// What bounds the step at t_n, where elements have grown by `growth` (force::ElementReport) over the last estimate;
/// also tells whether that is outdated.
double bounding_rate(AssembledStep& assembled, const model::State& state, double growth, double element_rate);

/// To the arrays of the state.
void add_arrays(const model::Model& model, AssembledStep& assembled, std::vector<model::StateArray>& arrays);

}  // namespace brunt::time
