// SPDX-License-Identifier: Apache-2.0
// Mapping from the constants of a material to the response used in the loop of a kernel.
#pragma once
#include <type_traits>
#include <utility>
#include <variant>

#include "core/error.hpp"
#include "material/elastic.hpp"
#include "material/foam.hpp"
#include "material/j2.hpp"
#include "material/law.hpp"
#include "material/metal.hpp"
#include "material/neo_hookean.hpp"

namespace brunt::force {

/// Calls `use(response)` with a rate law of the objective rate chosen.
template <class Response, class Constants, class Use>
auto with_rate(const Constants& constants, const Use& use) {
  if (constants.stress_rate == material::StressRate::logarithmic)
    return use(material::Logarithmic<Response>(constants));
  return use(Response(constants));
}

/// Calls `use(response)` with the response of the law: options are resolved here, once for each block, never in the
/// loop.
template <class Use>
auto with_response(const material::Law& law, Use&& use) {
  return std::visit(
      [&](const auto& constants) {
        using Constants = std::decay_t<decltype(constants)>;
        if constexpr (std::is_same_v<Constants, material::Elastic>) {
          return with_rate<material::ElasticResponse>(constants, use);
        } else if constexpr (std::is_same_v<Constants, material::J2>) {
          const bool table = !constants.table.empty(), kinematic = constants.kinematic > 0;
          if (table && kinematic) return with_rate<material::J2Response<true, true>>(constants, use);
          if (table) return with_rate<material::J2Response<true, false>>(constants, use);
          if (kinematic) return with_rate<material::J2Response<false, true>>(constants, use);
          return with_rate<material::J2Response<false, false>>(constants, use);
        } else if constexpr (std::is_same_v<Constants, material::Metal>) {
          if (constants.eos) return use(material::MetalResponse<true>(constants));
          return use(material::MetalResponse<false>(constants));
        } else if constexpr (std::is_same_v<Constants, material::Foam>) {
          return use(material::FoamResponse(constants));
        } else if constexpr (std::is_same_v<Constants, material::Rigid>) {
          demand(false, "rigid elements have no kernel");
          return decltype(use(std::declval<material::ElasticResponse>()))();
        } else {
          return use(material::NeoHookeanResponse(constants));
        }
      },
      law);
}

}  // namespace brunt::force
