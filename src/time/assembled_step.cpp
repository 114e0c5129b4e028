// SPDX-License-Identifier: Apache-2.0
#include "brunt/time/assembled_step.hpp"

#include <algorithm>
#include <cmath>

#include "brunt/time/lanczos.hpp"

namespace brunt::time {
namespace {

/// Times the elements' stable step: of a length where damping counts as springs. The bound holds for any. Where the
/// mesh allows more, damping counts for too much (by 1 % of the step with the default bulk viscosity); where it allows
/// less, all stiffness counts as if it were damping, which costs more.
constexpr double expected_gain = 1.1;

/// In the place of a removed element its batch kept what a living one has; which one depends on the ranks.
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
  return assembled.step < 0 || state.step - assembled.step >= estimate_span;
}

double assembled_rate(const model::Model& model, const model::State& state, Links& links, force::LinearElements& linear,
                      double element_rate) {
  const double dt = expected_gain / element_rate;
  force::include_damping(linear, dt);
  // elements bound stiffness with damping by 4 rate^2, dashpots of hourglass modes by as much again
  const double scale = 8 * element_rate * element_rate;
  const int products = lanczos_products(3.0 * static_cast<double>(model.mesh.global_nodes));
  const double found = largest_eigenvalue(model, state, links, linear, scale, products);
  const double stiffness = scale * found / (1 - lanczos_share);
  if (!(found > 0)) return element_rate;
  // a shorter step than dt makes damping count for more, by dt over it at most
  const double allowed = 2 / std::sqrt(stiffness);
  const double stable = allowed >= dt ? allowed : 4 / (stiffness * dt);
  return std::min(element_rate, 1 / stable);
}

void estimate(const model::Model& model, const model::State& state, Links& links, force::LinearElements& linear,
              double element_rate, AssembledStep& assembled) {
  assembled.step = state.step;
  assembled.rate = 0;
  if (!(element_rate > 0) || !std::isfinite(element_rate)) return;
  force::take_baseline(linear, assembled.baseline);
  clear_removed(state, assembled.baseline);
  assembled.rate = assembled_rate(model, state, links, linear, element_rate);
}

double bounding_rate(const AssembledStep& assembled, const model::State& state, double growth, double element_rate) {
  if (!(assembled.rate > 0)) return element_rate;
  const double grown = state.step == assembled.step ? 1.0 : std::max(growth, 1.0);
  return std::min(element_rate, assembled.rate * std::sqrt(grown));
}

void add_arrays(const model::Model& model, AssembledStep& assembled, std::vector<model::StateArray>& arrays) {
  using Entity = model::StateArray::Entity;
  for (auto [name, value] :
       {std::pair{"assembled_rate", &assembled.rate}, std::pair{"assembled_step", &assembled.step}})
    arrays.push_back({name, Entity::global, -1, 1, 1, value, 1, 1, 1, 0, true, true});
  for (std::size_t b = 0; b < model.blocks.size(); ++b) {
    const model::ElementBlock& block = model.blocks[b];
    if (material::is_rigid(block.law)) continue;
    arrays.push_back({"block/" + block.part + "/assembled_baseline", Entity::element, static_cast<std::int32_t>(b),
                      block.count, 2, assembled.baseline[b].data(), pack_width, 2 * pack_width, pack_width, 1, true,
                      true});
  }
}

}  // namespace brunt::time
