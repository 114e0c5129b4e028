// SPDX-License-Identifier: Apache-2.0
// From the options of a block to its kernel: the one place where element and material meet.
#pragma once
#include <type_traits>
#include <utility>
#include <variant>

#include "brunt/core/error.hpp"
#include "brunt/element/hex8.hpp"
#include "brunt/element/hex8_full.hpp"
#include "brunt/element/tet4.hpp"
#include "brunt/material/elastic.hpp"
#include "brunt/material/j2.hpp"
#include "brunt/material/neo_hookean.hpp"
#include "brunt/model/element_block.hpp"

namespace brunt::force {

/// Calls `use(response)` with the response of the law: options are decided here, once a block, never in the loop.
template <class Use>
auto with_response(const material::Law& law, Use&& use) {
  return std::visit(
      [&](const auto& constants) {
        using Constants = std::decay_t<decltype(constants)>;
        if constexpr (std::is_same_v<Constants, material::Elastic>) {
          return use(material::ElasticResponse(constants));
        } else if constexpr (std::is_same_v<Constants, material::J2>) {
          const bool table = !constants.table.empty(), kinematic = constants.kinematic > 0;
          if (table && kinematic) return use(material::J2Response<true, true>(constants));
          if (table) return use(material::J2Response<true, false>(constants));
          if (kinematic) return use(material::J2Response<false, true>(constants));
          return use(material::J2Response<false, false>(constants));
        } else {
          return use(material::NeoHookeanResponse(constants));
        }
      },
      law);
}

/// Calls `use(kernel)` with the kernel of the block.
template <class Use>
auto with_kernel(const model::ElementBlock& block, Use&& use) {
  using element::ElementKind;
  using element::HourglassKind;
  return with_response(block.law, [&](const auto& response) {
    using Response = std::decay_t<decltype(response)>;
    if (block.kind == ElementKind::hex8_full) return use(element::Hex8Full<Response, false>{response, block.bulk});
    if (block.kind == ElementKind::hex8_bbar) return use(element::Hex8Full<Response, true>{response, block.bulk});
    if (block.kind == ElementKind::tet4) return use(element::Tet4<Response>{response, block.bulk});
    if (block.hourglass.kind == HourglassKind::viscous)
      return use(element::Hex8<Response, HourglassKind::viscous>{response, block.hourglass, block.bulk});
    if (block.hourglass.kind == HourglassKind::stiffness)
      return use(element::Hex8<Response, HourglassKind::stiffness>{response, block.hourglass, block.bulk});
    return use(element::Hex8<Response, HourglassKind::none>{response, block.hourglass, block.bulk});
  });
}

}  // namespace brunt::force
