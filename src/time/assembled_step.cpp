// SPDX-License-Identifier: Apache-2.0
#include "time/assembled_step.hpp"

#include <algorithm>
#include <cmath>

#include "time/lanczos.hpp"

namespace brunt::time {
namespace {

/// Times the elements' stable step: the step for which damping is converted to springs. The bound is valid for any
/// value. If the mesh allows a longer step, damping is overestimated (by 1 % of the step with the default bulk
/// viscosity); if it allows a shorter one, all stiffness is treated as if it were damping, which is a larger loss.
constexpr double expected_gain = 1.1;

/// In the lane of a removed element its batch stored the values of a living one; which one depends on the ranks.
void clear_removed(const model::State& state, force::Baseline& baseline) {
  for (std::size_t b = 0; b < state.living.lanes.size(); ++b)
    for (std::size_t batch = 0; batch < state.living.lanes[b].size() && !baseline[b].empty(); ++batch)
      for (int lane = 0; lane < pack_width; ++lane)
        if ((state.living.lanes[b][batch] >> lane & 1) == 0) {
          double* first = &baseline[b][2 * pack_width * batch + static_cast<std::size_t>(lane)];
          first[0] = first[pack_width] = 0;
        }
}

}  // namespace

int lanczos_products(double unknowns) {
  const double needed = std::log(1.648 * std::sqrt(std::max(unknowns, 1.0)) / lanczos_risk) / std::sqrt(lanczos_share);
  return static_cast<int>(std::ceil(0.5 * (needed + 1)));
}

bool estimate_is_due(const AssembledStep& assembled, const model::State& state) {
  if (assembled.step < 0) return true;
  return assembled.outdated > 0 && state.step >= estimate_span * assembled.estimates &&
         state.step >= assembled.step + estimate_pause;
}

void outdate(AssembledStep& assembled) {
  assembled.outdated = 1;
}

double assembled_rate(const model::Model& model, const model::State& state, Links& links, force::LinearElements& linear,
                      double element_rate) {
  const double dt = expected_gain / element_rate;
  force::include_damping(linear, dt);
  // the bound of the elements: stiffness with damping by 4 rate^2, dashpots of hourglass modes by the same amount
  const double scale = 8 * element_rate * element_rate;
  const int products = lanczos_products(3.0 * static_cast<double>(model.mesh.global_nodes));
  // if damping is so stiff (see below), the mesh allows almost no longer step than its elements
  static_assert(1 + worth_a_step < expected_gain);
  const double no_gain = 4 * element_rate / (dt * (1 + worth_a_step));
  const double enough = no_gain * (1 - lanczos_share) / scale;
  const double found = largest_eigenvalue(model, state, links, linear, scale, products, enough);
  if (!(found > 0) || found >= enough) return element_rate;
  const double stiffness = scale * found / (1 - lanczos_share);
  // for a shorter step than dt the effect of damping increases, at most by dt over the step
  const double allowed = 2 / std::sqrt(stiffness);
  const double stable = allowed >= dt ? allowed : 4 / (stiffness * dt);
  return std::min(element_rate, 1 / stable);
}

void estimate(const model::Model& model, const model::State& state, Links& links, force::LinearElements& linear,
              double element_rate, AssembledStep& assembled) {
  assembled.step = state.step;
  assembled.rate = 0;
  assembled.element_rate = element_rate;
  assembled.outdated = 0;
  if (linear.empty() || !(element_rate > 0) || !std::isfinite(element_rate)) return;
  ++assembled.estimates;
  force::take_baseline(linear, assembled.baseline);
  clear_removed(state, assembled.baseline);
  assembled.rate = assembled_rate(model, state, links, linear, element_rate);
}

double bounding_rate(AssembledStep& assembled, const model::State& state, double growth, double element_rate) {
  if (state.step == assembled.step) growth = 1;
  const double stiffened = std::sqrt(std::max(growth, 1.0)), changed = element_rate / assembled.element_rate;
  constexpr double much = 1 + worth_an_estimate;
  if (stiffened > much || changed * much < 1 || (changed > much && assembled.rate == 0)) outdate(assembled);
  return assembled.rate > 0 ? std::min(element_rate, assembled.rate * stiffened) : element_rate;
}

void add_arrays(const model::Model& model, AssembledStep& assembled, std::vector<model::StateArray>& arrays) {
  using Entity = model::StateArray::Entity;
  for (auto [name, value] :
       {std::pair{"assembled_rate", &assembled.rate}, std::pair{"assembled_element_rate", &assembled.element_rate},
        std::pair{"assembled_step", &assembled.step}, std::pair{"assembled_estimates", &assembled.estimates},
        std::pair{"assembled_outdated", &assembled.outdated}})
    arrays.push_back({name, Entity::global, -1, 1, 1, value, 1, 1, 1, 0, true, true, false});
  for (std::size_t b = 0; b < model.blocks.size(); ++b) {
    const model::ElementBlock& block = model.blocks[b];
    if (material::is_rigid(block.law)) continue;
    arrays.push_back({"block/" + block.part + "/assembled_baseline", Entity::element, static_cast<std::int32_t>(b),
                      block.count, 2, assembled.baseline[b].data(), pack_width, 2 * pack_width, pack_width, 1, true,
                      true, false});
  }
}

}  // namespace brunt::time
