// SPDX-License-Identifier: Apache-2.0
// Which of two bodies contact will take as the slave, foretold from the whole mesh.
#pragma once
#include <cstdint>
#include <vector>

#include "brunt/contact/surface/surface.hpp"
#include "brunt/mesh/mesh.hpp"
#include "brunt/scene/input.hpp"

namespace brunt::app {

class SlaveChoice {
 public:
  /// mesh: with the selections of the scene.
  SlaveChoice(const scene::Input& input, const mesh::Mesh& mesh);
  /// Is a node of this block and body the slave of faces of the other, were there one pass?
  [[nodiscard]] bool is_slave(std::size_t block, std::int32_t body, std::size_t other_block,
                              std::int32_t other_body) const;
  /// May it be held off by them, in two passes too?
  [[nodiscard]] bool is_held_off(std::size_t block, std::int32_t body, std::size_t other_block,
                                 std::int32_t other_body) const;

 private:
  contact::PairTable pairs_;
  std::vector<contact::BodyFigures> bodies_;
};

}  // namespace brunt::app
