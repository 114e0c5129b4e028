// SPDX-License-Identifier: Apache-2.0
// Constrained and driven nodes over one step.
#include "driven.hpp"
#include "implicit/balance.hpp"
#include "model/curve.hpp"

namespace brunt::implicit {
Given driven(const model::Drive& drive, double velocity_before, double from, double to) {
  const double dt = to - from;
  switch (drive.gives) {
    case model::Drive::Gives::displacement: {
      const double travel = drive.scale * (model::value_at(drive.curve, to) - model::value_at(drive.curve, from));
      return {travel, travel / dt};
    }
    case model::Drive::Gives::acceleration: {
      const double a0 = drive.scale * model::value_at(drive.curve, from);
      const double a1 = drive.scale * model::value_at(drive.curve, to);
      return {dt * velocity_before + dt * dt / 6 * (2 * a0 + a1),
              velocity_before + drive.scale * model::integral(drive.curve, from, to)};
    }
    case model::Drive::Gives::velocity:
      break;
  }
  return {drive.scale * model::integral(drive.curve, from, to), drive.scale * model::value_at(drive.curve, to)};
}

void prescribe(const Scene& scene, Trial& trial) {
  const model::Model& model = scene.model;
  trial.given.assign(model.supports.nodes.size(), Vec3::Zero());
  trial.given_velocity.assign(model.supports.nodes.size(), Vec3::Zero());
  for (std::size_t k = 0; k < model.supports.nodes.size(); ++k) {
    const LocalIndex node = model.supports.nodes[k].node;
    for (int c = 0; c < 3; ++c) {
      const std::int32_t drive = nth(model.supports.drive[k], c);
      if (drive < 0) continue;
      const double before = trial.velocity[3 * static_cast<std::size_t>(node) + static_cast<std::size_t>(c)];
      const Given given = driven(nth(model.supports.drives, drive), before, trial.time_before, trial.time);
      trial.given[k][c] = given.travel;
      trial.given_velocity[k][c] = given.velocity;
    }
  }
}

}  // namespace brunt::implicit
