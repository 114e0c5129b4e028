// SPDX-License-Identifier: Apache-2.0
#include "block_loop.hpp"
#include "brunt/element/tet4.hpp"
#include "kernels.hpp"
#include "response_choice.hpp"

namespace brunt::force {
namespace {

/// Calls `use(kernel)` with the kernel of the block.
template <class Use>
auto with_kernel(const model::ElementBlock& block, Use&& use) {
  return with_response(block.law, [&](const auto& response) {
    using Response = std::decay_t<decltype(response)>;
    return use(element::Tet4<Response>{response, block.bulk});
  });
}

}  // namespace

std::vector<element::HistoryField> tet4_history(const model::ElementBlock& block) {
  return with_kernel(block, [](const auto& kernel) { return kernel.history(); });
}

void tet4_forces(const model::ElementBlock& block, LocalIndex block_index, const BlockPass& pass) {
  with_kernel(block, [&](const auto& kernel) { run_block(kernel, block, block_index, pass); });
}

}  // namespace brunt::force
