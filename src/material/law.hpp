// SPDX-License-Identifier: Apache-2.0
// The constants of each material law, as given by the user. The laws themselves are in their own headers.
#pragma once
#include <array>
#include <optional>
#include <variant>
#include <vector>

namespace brunt::material {

/// Objective rate of the Cauchy stress in laws in rate form.
enum class StressRate {
  jaumann,     ///< stress rotates with the spin of the material; inaccurate for elastic shear above a few tenths
  logarithmic  ///< stress rotates so that the stretching is the rate of the logarithmic strain ln V
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

/// Factor of the yield stress for the rate r of the equivalent strain.
struct RateFactor {
  enum class Form {
    none,           ///< 1
    logarithm,      ///< 1 + c ln max(r / reference, 1)
    power,          ///< (1 + r / reference)^c
    cowper_symonds  ///< 1 + (r / reference)^c, c = 1/p
  } form = Form::none;
  double c = 0;          ///< dimensionless
  double reference = 1;  ///< [1/time] > 0
};

/// Y = (A + B p^n) (rate factor) (1 - T*^m), T* = (T - room) / (melt - room) within 0 .. 1.
struct JohnsonCook {
  double a = 0, b = 0;        ///< [stress] > 0, >= 0
  double n = 1, m = 1;        ///< > 0
  double room = 0, melt = 0;  ///< [temperature]; melt <= room: no influence of temperature
};

/// Y over the plastic strain by table, first at 0, flat beyond the last.
struct TableStrength {
  std::vector<std::array<double, 2>> table;
};

/// Y = yield + hardening p + pressure_yield max(pressure, 0).
struct LinearStrength {
  double yield = 0, hardening = 0;  ///< [stress] >= 0
  double pressure_yield = 0;        ///< dimensionless >= 0
};

/// Work of plastic flow becomes heat: density heat_capacity dT = taylor_quinney Y dp.
struct Heat {
  double capacity = 0;  ///< [energy/(mass temperature)]; 0: constant temperature
  double taylor_quinney = 0.9;
  double start = 0;  ///< [temperature]
};

/// G. R. Johnson, W. H. Cook 1985: D grows by `critical` dp / e_f, and the material fails where D = critical;
/// e_f = (d1 + d2 exp(d3 s)) (rate factor) (1 + d5 T*), s the mean stress over the equivalent stress.
struct Fracture {
  double d1 = 0, d2 = 0, d3 = 0, d5 = 0;
  RateFactor rate;       ///< with d4
  double critical = 1;   ///< > 0, at most 1
  bool softens = false;  ///< the yield stress is (1 - D) Y
};

/// Pressure from relative volume J = density / (current density) and energy e per reference volume.
struct EquationOfState {
  enum class Model { mie_gruneisen, linear_polynomial } model = Model::mie_gruneisen;
  double c = 0, s = 0, gamma = 0;      ///< shock velocity U = c + s u; Gamma rho = gamma density
  std::array<double, 7> polynomial{};  ///< C0 .. C6
  double start_energy = 0;             ///< [energy/volume] e at the start
  double minimum_pressure = 0;         ///< [stress] <= 0; lower bound of the pressure in tension; 0: none
};

/// Metals with plastic flow, heating and failure; with an equation of state or a constant bulk modulus.
struct Metal {
  double density = 0;
  double bulk = 0, shear = 0;  ///< [stress] of the virgin material
  std::variant<JohnsonCook, TableStrength, LinearStrength> strength;
  RateFactor rate;
  double rate_steps = 12;  ///< steps over which the rate is averaged, see metal.hpp
  Heat heat;
  std::optional<Fracture> fracture;
  std::optional<EquationOfState> eos;
};

/// Foam with uncoupled principal stresses: elastic up to a yield stress that depends on the volumetric strain in
/// compression.
struct Foam {
  double density = 0, young = 0;             ///< [mass/length^3], [stress] > 0
  std::vector<std::array<double, 2>> table;  ///< (1 - J, yield stress), first at 0; beyond the last it is elastic
  double tension = 0;                        ///< [stress] >= 0: tensile strength
};

/// A part of this material is a rigid body: its elements give mass and inertia, and have no strain or stress.
struct Rigid {
  double density = 0;  ///< [mass/length^3] > 0
};

using Law = std::variant<Elastic, J2, NeoHookean, Metal, Foam, Rigid>;

inline bool is_rigid(const Law& law) {
  return std::holds_alternative<Rigid>(law);
}

/// Lame constants and density of any law in its initial elastic state; zero moduli for a rigid part.
struct ElasticModuli {
  double density = 0, lambda = 0, mu = 0;
};
ElasticModuli initial_moduli(const Law& law);

}  // namespace brunt::material
