// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "element/tet4.hpp"
#include "model/model.hpp"
#include "response_choice.hpp"

namespace brunt::force {

struct Tet4Choice {
  template <class Use>
  static auto with_kernel(const model::ElementBlock& block, bool viscous, Use&& use) {
    const element::BulkViscosity bulk = viscous ? block.bulk : element::BulkViscosity{0, 0};
    return with_response(block.law, [&](const auto& response) {
      return use(element::Tet4<std::decay_t<decltype(response)>>{response, bulk});
    });
  }
};

}  // namespace brunt::force
