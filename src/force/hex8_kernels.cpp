// SPDX-License-Identifier: Apache-2.0
#include "block_loop.hpp"
#include "element/hex8.hpp"
#include "kernels.hpp"
#include "response_choice.hpp"

namespace brunt::force {
namespace {

struct Hex8Choice {
  template <class Use>
  static auto with_kernel(const model::ElementBlock& block, bool viscous, Use&& use) {
    const element::BulkViscosity bulk = viscous ? block.bulk : element::BulkViscosity{0, 0};
    element::Hourglass hourglass = block.hourglass;
    if (hourglass.kind == element::HourglassKind::viscous && !viscous) hourglass.coefficient = 0;
    return with_response(block.law, [&](const auto& response) {
      using Response = std::decay_t<decltype(response)>;
      using element::HourglassKind;
      if (hourglass.kind == HourglassKind::viscous)
        return use(element::Hex8<Response, HourglassKind::viscous>{response, hourglass, bulk});
      if (hourglass.kind == HourglassKind::stiffness || hourglass.kind == HourglassKind::elastic)
        return use(element::Hex8<Response, HourglassKind::stiffness>{response, hourglass, bulk});
      return use(element::Hex8<Response, HourglassKind::none>{response, hourglass, bulk});
    });
  }
};

}  // namespace

constinit const Kernels hex8_kernels = kernels_of<Hex8Choice>();

}  // namespace brunt::force
