// SPDX-License-Identifier: Apache-2.0
// Predicts which of two bodies contact will choose as the slave, from the whole mesh by the rules of contact/surface.
#pragma once
#include <cstdint>
#include <vector>

#include "setup/start_rules.hpp"

namespace brunt::setup {

class SlaveChoice {
 public:
  SlaveChoice(const mesh::Mesh& mesh, const StartRules& rules);
  /// Whether a node of this block and body is the slave of faces of the other one in one-pass contact.
  [[nodiscard]] bool is_slave(std::size_t block, std::int32_t body, std::size_t other_block,
                              std::int32_t other_body) const;
  /// Whether it may be constrained by them, including two-pass contact.
  [[nodiscard]] bool is_held_off(std::size_t block, std::int32_t body, std::size_t other_block,
                                 std::int32_t other_body) const;

 private:
  const contact::Specification& specification_;
  std::vector<contact::BodyFigures> bodies_;
};

}  // namespace brunt::setup
