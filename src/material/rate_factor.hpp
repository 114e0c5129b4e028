// SPDX-License-Identifier: Apache-2.0
// Influence of the strain rate on strength and on the strain at fracture.
#pragma once
#include "material/exponential.hpp"
#include "material/law.hpp"

namespace brunt::material {

/// See RateFactor. rate >= 0.
inline Pack rate_factor(const RateFactor& law, Pack rate) {
  const Pack relative = rate * (1 / law.reference);
  switch (law.form) {
    case RateFactor::Form::logarithm:
      return 1.0 + law.c * pack_log(pack_max(relative, broadcast(1.0)));
    case RateFactor::Form::power:
      return pack_exp(law.c * pack_log(1.0 + relative));
    case RateFactor::Form::cowper_symonds:
      return 1.0 + pack_power(relative, law.c);
    case RateFactor::Form::none:
      break;
  }
  return broadcast(1.0);
}

}  // namespace brunt::material
