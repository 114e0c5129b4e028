// SPDX-License-Identifier: Apache-2.0
#include "block_loop.hpp"
#include "brunt/element/hex8_full.hpp"
#include "kernels.hpp"
#include "response_choice.hpp"

namespace brunt::force {
namespace {

struct Hex8FullChoice {
  template <class Use>
  static auto with_kernel(const model::ElementBlock& block, bool viscous, Use&& use) {
    const element::BulkViscosity bulk = viscous ? block.bulk : element::BulkViscosity{0, 0};
    return with_response(block.law, [&](const auto& response) {
      using Response = std::decay_t<decltype(response)>;
      if (block.kind == element::ElementKind::hex8_bbar) return use(element::Hex8Full<Response, true>{response, bulk});
      return use(element::Hex8Full<Response, false>{response, bulk});
    });
  }
};

}  // namespace

constinit const Kernels hex8_full_kernels = kernels_of<Hex8FullChoice>();

}  // namespace brunt::force
