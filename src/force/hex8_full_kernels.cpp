// SPDX-License-Identifier: Apache-2.0
#include "block_loop.hpp"
#include "brunt/element/hex8_full.hpp"
#include "kernels.hpp"
#include "response_choice.hpp"

namespace brunt::force {
namespace {

/// Calls `use(kernel)` with the kernel of the block.
template <class Use>
auto with_kernel(const model::ElementBlock& block, Use&& use) {
  return with_response(block.law, [&](const auto& response) {
    using Response = std::decay_t<decltype(response)>;
    if (block.kind == element::ElementKind::hex8_bbar)
      return use(element::Hex8Full<Response, true>{response, block.bulk});
    return use(element::Hex8Full<Response, false>{response, block.bulk});
  });
}

}  // namespace

std::vector<element::HistoryField> hex8_full_history(const model::ElementBlock& block) {
  return with_kernel(block, [](const auto& kernel) { return kernel.history(); });
}

void hex8_full_forces(const model::ElementBlock& block, LocalIndex block_index, const BlockPass& pass) {
  with_kernel(block, [&](const auto& kernel) { run_block(kernel, block, block_index, pass); });
}

}  // namespace brunt::force
