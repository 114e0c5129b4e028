// SPDX-License-Identifier: Apache-2.0
#include "block_loop.hpp"
#include "brunt/element/tet4.hpp"
#include "kernels.hpp"
#include "response_choice.hpp"

namespace brunt::force {
namespace {

struct Tet4Choice {
  template <class Use>
  static auto with_kernel(const model::ElementBlock& block, bool viscous, Use&& use) {
    const element::BulkViscosity bulk = viscous ? block.bulk : element::BulkViscosity{0, 0};
    return with_response(block.law, [&](const auto& response) {
      using Response = std::decay_t<decltype(response)>;
      return use(element::Tet4<Response>{response, bulk});
    });
  }
};

}  // namespace

constinit const Kernels tet4_kernels = kernels_of<Tet4Choice>();

}  // namespace brunt::force
