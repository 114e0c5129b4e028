// SPDX-License-Identifier: Apache-2.0
// Sums over one part: mass, momenta, energies. They go over the elements, each of which gives equal shares of its mass
// to its corners, so that nodes that parts share are divided among them; all sums are exact, hence the same on any
// number of ranks. Every function is collective.
#pragma once
#include <span>
#include <string>
#include <vector>

#include "app/state/prepared.hpp"

namespace brunt::app {

/// The parts and nodes of a probe of a part, on this rank.
struct PartNodes {
  std::size_t block = 0;
  std::vector<LocalIndex> own;  ///< nodes that this rank owns and no other part has
};
PartNodes nodes_of_part(const Prepared& run, const std::string& part);

double part_mass(const Prepared& run, const PartNodes& part);
/// Centre of mass at x_n, in the scene's coordinates [length].
Vec3 part_center(const Prepared& run, const PartNodes& part);
/// Sum of m v at the half step [momentum].
Vec3 part_momentum(const Prepared& run, const PartNodes& part);
/// Sum of m (x - about) x v [mass length^2/time]. After the step from t_n: x_n and x_{n+1} = x_n + dt v give the same.
Vec3 part_angular_momentum(const Prepared& run, const PartNodes& part, const Vec3& about);

struct PartEnergy {
  double kinetic = 0, internal = 0, hourglass = 0, bulk = 0;
};
/// At t_n, as the ledger has them, after the step from there. `before`: v_{n-1/2} by node; dt_mean: of that step.
PartEnergy part_energy(const Prepared& run, const PartNodes& part, std::span<const Vec3> before, double dt_mean);

}  // namespace brunt::app
