// SPDX-License-Identifier: Apache-2.0
// Crushable foam: uncoupled principal stresses (Poisson's ratio 0), elastic up to a yield stress that increases with
// the volumetric strain in compression, and up to a tensile strength. Unloading is elastic (J. O. Hallquist, LS-DYNA
// theory manual, material 63).
//
// The modulus relates the nominal stress to the reference length: d(stress) = E J d(strain), J the relative volume. In
// compression without lateral motion the stress before yield is therefore E (1 - J) at any compression. Beyond the last
// point of the table the yield stress increases with slope E in 1 - J: the foam has locked and is elastic.
#pragma once
#include <array>

#include "material/circumstances.hpp"
#include "material/elastic.hpp"
#include "material/principal.hpp"
#include "material/yield_curve.hpp"

namespace brunt::material {

struct FoamResponse {
  static constexpr bool thermodynamic = true;
  using Step = Circumstances;
  static constexpr bool hyperelastic = false;
  static constexpr bool logarithmic = false;
  static constexpr int tensors = 0;
  static constexpr int scalars = 1;
  static constexpr int at_volume = 0;  ///< position of the relative volume

  explicit FoamResponse(const Foam& law)
      : density(law.density),
        lambda(0),
        mu(0.5 * law.young),
        young(law.young),
        tension(law.tension),
        locking(law.table.back()[0]),
        locked(law.table.back()[1]),
        curve(law.table, law.young) {}

  static std::array<ScalarField, scalars> fields() { return {{{"relative_volume", 1}}}; }

  /// Stress and relative volume at the end of the step; returns the remaining share of the trial stress.
  Pack update(const Pack (&de)[6], const Circumstances& step, Pack (&stress)[6], Pack* volume) const {
    const Pack stiffness = (0.5 * young) * (step.volume + volume[0]);
    for (int c = 0; c < 6; ++c) stress[c] += stiffness * de[c];
    volume[0] = step.volume;
    const Pack most = yield(1.0 - step.volume);
    const Pack norm = norm_of(stress);
    const PackMask beyond = norm > pack_min(most, broadcast(tension));
    if (!any(beyond)) return broadcast(1.0);
    Principal principal(stress);
    for (Pack& value : principal.value) value = pack_min(pack_max(value, -most), broadcast(tension));
    Pack cut[6];
    principal.compose(cut);
    for (int c = 0; c < 6; ++c) stress[c] = select(beyond, cut[c], stress[c]);
    return select(beyond, norm_of(cut) / norm, broadcast(1.0));
  }

  [[nodiscard]] Pack modulus(const Pack (&)[6], const Pack* volume) const { return young * volume[0]; }

  void tangent(const Pack (&stress)[6], const Pack* volume, Pack& lambda_bound, Pack& mu_bound) const {
    rate_law_tangent(Pack{}, 0.5 * young * volume[0], stress, lambda_bound, mu_bound);
  }

  double density, lambda, mu;
  double young, tension, locking, locked;
  YieldCurve curve;

 private:
  static Pack norm_of(const Pack (&s)[6]) {
    return pack_sqrt(s[0] * s[0] + s[1] * s[1] + s[2] * s[2] + 2.0 * (s[3] * s[3] + s[4] * s[4] + s[5] * s[5]));
  }
  [[nodiscard]] Pack yield(Pack lost) const {
    Pack value;
    for (int lane = 0; lane < pack_width; ++lane)
      value[lane] =
          lost[lane] > locking ? locked + young * (lost[lane] - locking) : curve.at(lost[lane] > 0 ? lost[lane] : 0.0);
    return value;
  }
};

}  // namespace brunt::material
