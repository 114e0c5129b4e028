// SPDX-License-Identifier: Apache-2.0
#include "block_loop.hpp"
#include "brunt/element/hex8.hpp"
#include "kernels.hpp"
#include "response_choice.hpp"

namespace brunt::force {
namespace {

struct Hex8Choice {
  template <class Use>
  static auto with_kernel(const model::ElementBlock& block, Use&& use) {
    return with_response(block.law, [&](const auto& response) {
      using Response = std::decay_t<decltype(response)>;
      using element::HourglassKind;
      if (block.hourglass.kind == HourglassKind::viscous)
        return use(element::Hex8<Response, HourglassKind::viscous>{response, block.hourglass, block.bulk});
      if (block.hourglass.kind == HourglassKind::stiffness || block.hourglass.kind == HourglassKind::elastic)
        return use(element::Hex8<Response, HourglassKind::stiffness>{response, block.hourglass, block.bulk});
      return use(element::Hex8<Response, HourglassKind::none>{response, block.hourglass, block.bulk});
    });
  }
};

}  // namespace

constinit const Kernels hex8_kernels = kernels_of<Hex8Choice>();

}  // namespace brunt::force
