// SPDX-License-Identifier: Apache-2.0
// The constants of each material law, as the user gives them. What a law does with them stands in its own header.
#pragma once
#include <array>
#include <variant>
#include <vector>

namespace brunt::material {

/// Objective rate of the Cauchy stress in laws in rate form.
enum class StressRate {
  jaumann,     ///< stress turns with the material's spin; wrong from a few tenths of elastic shear on
  logarithmic  ///< stress turns so that the stretching is the rate of the logarithmic strain ln V
};

/// Isotropic linear elasticity in rate form (hypoelastic).
struct Elastic {
  double density = 0;  ///< [mass/length^3] > 0
  double young = 0;    ///< [stress] > 0
  double poisson = 0;  ///< -1 < nu < 0.5
  StressRate stress_rate = StressRate::jaumann;
};

/// J2 plasticity with associated flow; hardening linear or by table, isotropic to kinematic.
struct J2 {
  double density = 0, young = 0, poisson = 0;
  double yield = 0;      ///< [stress] initial yield stress
  double hardening = 0;  ///< [stress] d(yield)/d(plastic strain), used where the table is empty
  std::vector<std::array<double, 2>>
      table;             ///< (equivalent plastic strain, yield stress), first at 0; flat beyond the last
  double kinematic = 0;  ///< 0 isotropic .. 1 kinematic share of the hardening
  StressRate stress_rate = StressRate::jaumann;  ///< of stress and back stress
};

/// Compressible neo-Hookean solid: psi = mu/2 (I1 - 3) - mu ln J + lambda/2 (ln J)^2.
struct NeoHookean {
  double density = 0;
  double lambda = 0, mu = 0;  ///< [stress] Lame constants (the scene gives young and poisson, or bulk and shear)
};

/// A part of it is a rigid body: its elements give mass and inertia, and have neither strain nor stress.
struct Rigid {
  double density = 0;  ///< [mass/length^3] > 0
};

using Law = std::variant<Elastic, J2, NeoHookean, Rigid>;

inline bool is_rigid(const Law& law) {
  return std::holds_alternative<Rigid>(law);
}

/// Lame constants and density of any law in its initial, elastic state; a rigid part has no moduli (zero).
struct ElasticModuli {
  double density = 0, lambda = 0, mu = 0;
};
ElasticModuli initial_moduli(const Law& law);

}  // namespace brunt::material
