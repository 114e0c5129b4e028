// SPDX-License-Identifier: Apache-2.0
// Rules of blocks that all may touch each other, and themselves where asked.
#pragma once
#include "setup/start_rules.hpp"

namespace brunt::test {

inline setup::StartRules all_touch(std::size_t blocks, setup::OverlapRule rule, bool self) {
  setup::StartRules rules;
  rules.density.assign(blocks, 1.0);
  rules.contact.pairs = contact::PairTable(blocks, {contact::PairRule::automatic});
  rules.overlap.assign(blocks * blocks, rule);
  for (std::size_t b = 0; b < blocks && !self; ++b) {
    rules.overlap[b * blocks + b].reset();
    rules.contact.pairs.set(static_cast<std::int32_t>(b), static_cast<std::int32_t>(b), {});
  }
  return rules;
}

}  // namespace brunt::test
