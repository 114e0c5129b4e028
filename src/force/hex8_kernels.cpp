// SPDX-License-Identifier: Apache-2.0
#include "block_loop.hpp"
#include "brunt/element/hex8.hpp"
#include "kernels.hpp"
#include "response_choice.hpp"

namespace brunt::force {
namespace {

/// Calls `use(kernel)` with the kernel of the block.
template <class Use>
auto with_kernel(const model::ElementBlock& block, Use&& use) {
  return with_response(block.law, [&](const auto& response) {
    using Response = std::decay_t<decltype(response)>;
    using element::HourglassKind;
    if (block.hourglass.kind == HourglassKind::viscous)
      return use(element::Hex8<Response, HourglassKind::viscous>{response, block.hourglass, block.bulk});
    if (block.hourglass.kind == HourglassKind::stiffness)
      return use(element::Hex8<Response, HourglassKind::stiffness>{response, block.hourglass, block.bulk});
    return use(element::Hex8<Response, HourglassKind::none>{response, block.hourglass, block.bulk});
  });
}

}  // namespace

std::vector<element::HistoryField> hex8_history(const model::ElementBlock& block) {
  return with_kernel(block, [](const auto& kernel) { return kernel.history(); });
}

void hex8_forces(const model::ElementBlock& block, LocalIndex block_index, const BlockPass& pass) {
  with_kernel(block, [&](const auto& kernel) { run_block(kernel, block, block_index, pass); });
}

}  // namespace brunt::force
