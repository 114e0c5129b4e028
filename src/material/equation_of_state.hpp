// SPDX-License-Identifier: Apache-2.0
// Pressure of a solid under shocks, from the relative volume J and the energy e per reference volume.
//
// Both forms are linear in e, p = cold(J) + share(J) e, so that the energy of a step, taken with the mean pressure
//   e' = e - (p + p') / 2 (J' - J) + work of viscosity and shear,
// follows in closed form, and is of second order (M. L. Wilkins, Methods in Comput. Physics 3 (1964) 211).
//   Mie-Gruneisen with Gamma rho constant, on the Hugoniot U = c + s u: with h = 1 - J,
//     cold = density c^2 h / (1 - s h)^2 (1 - gamma h / 2), share = gamma;
//     in tension cold = density c^2 h, the tangent at J = 1
//   Linear polynomial in m = 1/J - 1: cold = C0 + C1 m + C2 m^2 + C3 m^3, share = C4 + C5 m + C6 m^2; C2 = C6 = 0 in
//     tension
// (both forms: J. O. Hallquist, LS-DYNA theory manual, equations of state 1 and 4).
#pragma once
#include <limits>

#include "core/simd.hpp"
#include "material/law.hpp"

namespace brunt::material {

class PressureLaw {
 public:
  PressureLaw(const EquationOfState& constants, double density)
      : constants_(constants),
        stiffness_(density * constants.c * constants.c),
        least_(constants.minimum_pressure < 0 ? constants.minimum_pressure : -std::numeric_limits<double>::infinity()) {
  }

  struct Answer {
    Pack pressure, energy;
  };

  /// The end of a step. energy: at its start, plus the work of viscosity and shear; pressure: at its start; change: of
  /// the relative volume, to `volume`; failed: the point carries no tension, so that opening does no work.
  [[nodiscard]] Answer close(Pack volume, Pack change, Pack pressure, Pack energy, PackMask failed) const {
    const Parts now = parts(volume);
    const Pack known = energy - 0.5 * change * pressure;
    Pack next = (now.cold + now.share * known) / (1.0 + 0.5 * change * now.share);
    next = pack_max(next, select(failed, Pack{}, broadcast(least_)));
    return {next, known - 0.5 * change * next};
  }

  /// -J dp/dJ at constant entropy: the current bulk modulus [stress].
  [[nodiscard]] Pack bulk_modulus(Pack volume, Pack pressure, Pack energy) const {
    const Parts now = parts(volume);
    return volume * (now.share * pressure - now.cold_slope - now.share_slope * energy);
  }

 private:
  struct Parts {
    Pack cold, cold_slope, share, share_slope;  ///< and by J
  };

  [[nodiscard]] Parts parts(Pack volume) const {
    return constants_.model == EquationOfState::Model::mie_gruneisen ? on_hugoniot(volume) : polynomial(volume);
  }

  [[nodiscard]] Parts on_hugoniot(Pack volume) const {
    const Pack h = 1.0 - volume, compression = pack_max(h, Pack{});
    // A shock cannot compress to 1 - s h = 0; the lower bound keeps larger compressions finite.
    const Pack left = pack_max(1.0 - constants_.s * compression, broadcast(1e-3));
    const Pack over = 1.0 / left, over2 = over * over;
    const Pack half = 1.0 - 0.5 * constants_.gamma * compression;
    const Pack slope = stiffness_ * over2 *
                       (half * (1.0 + 2.0 * constants_.s * compression * over) - 0.5 * constants_.gamma * compression);
    return {stiffness_ * h * over2 * half, -slope, broadcast(constants_.gamma), Pack{}};
  }

  [[nodiscard]] Parts polynomial(Pack volume) const {
    const auto& C = constants_.polynomial;
    const Pack over = 1.0 / volume, m = over - 1.0, compression = pack_max(m, Pack{});
    const Pack by_volume = -over * over;
    const Pack cold = C[0] + m * (C[1] + C[3] * m * m) + C[2] * compression * compression;
    const Pack cold_slope = C[1] + 3.0 * C[3] * m * m + 2.0 * C[2] * compression;
    const Pack share = C[4] + C[5] * m + C[6] * compression * compression;
    const Pack share_slope = C[5] + 2.0 * C[6] * compression;
    return {cold, by_volume * cold_slope, share, by_volume * share_slope};
  }

  EquationOfState constants_;
  double stiffness_, least_;
};

}  // namespace brunt::material
