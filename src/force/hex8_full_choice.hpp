// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "element/hex8_full.hpp"
#include "model/model.hpp"
#include "response_choice.hpp"

namespace brunt::force {

template <bool bbar>
struct Hex8FullChoice {
  template <class Use>
  static auto with_kernel(const model::ElementBlock& block, bool viscous, Use&& use) {
    const element::BulkViscosity bulk = viscous ? block.bulk : element::BulkViscosity{0, 0};
    return with_response(block.law, [&](const auto& response) {
      return use(element::Hex8Full<std::decay_t<decltype(response)>, bbar>{response, bulk});
    });
  }
};

}  // namespace brunt::force
