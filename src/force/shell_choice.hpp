// SPDX-License-Identifier: Apache-2.0
// The kernel of a block of shells: options and law are resolved once for each block.
#pragma once
#include <type_traits>
#include <utility>
#include <variant>

#include "core/error.hpp"
#include "material/elastic.hpp"
#include "material/j2.hpp"
#include "material/law.hpp"
#include "material/metal.hpp"
#include "model/model.hpp"

namespace brunt::force {

/// Calls `use(response)` with the response of a law that shells may have (scene/rules refuses others).
template <class Use>
auto with_shell_response(const material::Law& law, Use&& use) {
  return std::visit(
      [&](const auto& constants) {
        using Constants = std::decay_t<decltype(constants)>;
        if constexpr (std::is_same_v<Constants, material::J2>) {
          const bool table = !constants.table.empty(), kinematic = constants.kinematic > 0;
          if (table && kinematic) return use(material::J2Response<true, true>(constants));
          if (table) return use(material::J2Response<true, false>(constants));
          if (kinematic) return use(material::J2Response<false, true>(constants));
          return use(material::J2Response<false, false>(constants));
        } else if constexpr (std::is_same_v<Constants, material::Metal>) {
          demand(!constants.eos, "shells have no equation of state");
          return use(material::MetalResponse<false>(constants));
        } else if constexpr (std::is_same_v<Constants, material::Elastic>) {
          return use(material::ElasticResponse(constants));
        } else {
          demand(false, "this law has no plane stress");
          return decltype(use(std::declval<material::ElasticResponse>()))();
        }
      },
      law);
}

/// `Shell` with control of hourglass modes or without.
template <template <class> class Shell>
struct ShellChoice {
  template <class Use>
  static auto with_kernel(const model::ElementBlock& block, Use&& use) {
    return with_shell_response(block.law, [&](const auto& response) {
      using Kernel = Shell<std::decay_t<decltype(response)>>;
      if constexpr (requires { Kernel{response, block.section, block.hourglass}; })
        return use(Kernel{response, block.section, block.hourglass});
      else
        return use(Kernel{response, block.section});
    });
  }
};

}  // namespace brunt::force
