// SPDX-License-Identifier: Apache-2.0
#include "contact/enforcement/impact_law.hpp"

#include <algorithm>
#include <cmath>

namespace brunt::contact {

bool opens(const ImpactState& state, const ImpactStep& step) {
  if (!(state.bank > 0)) return false;
  if (step.pressing < impact_numbers.early * state.pressed) return true;
  return step.push == 0 && step.after >= impact_numbers.early * step.pressing;
}

double energy_to_return(const ImpactState& state, double flow) {
  if (!(state.bank > 0) || !std::isfinite(flow) || flow != state.flow) return 0;
  if (!(state.most > 0)) return state.bank;
  return std::clamp(4 * state.recent / state.most - 2, 0.0, 1.0) * state.bank;
}

double returning_rate(const ImpactStep& step, double energy, double answer) {
  const double linear = answer * step.push + step.before + step.after, twice = 2 * answer * energy;
  const double root = std::sqrt(linear * linear + 4 * twice);
  // without cancellation
  const double more = linear > 0 ? 2 * twice / (linear + root) : 0.5 * (root - linear);
  return step.after + more;
}

ImpactState closed_state(ImpactState state, const ImpactStep& step, double work, double fading) {
  if (state.flow < 0) state.flow = step.flow;
  state.bank -= work;
  state.recent = std::max(step.pressing, state.recent + std::min(1.0, fading) * (step.pressing - state.recent));
  state.pressed = step.pressing;
  state.most = std::max(state.most, step.pressing);
  return state;
}

}  // namespace brunt::contact
