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
  /// May a node of this block and body be held off by faces of the other?
  [[nodiscard]] bool is_slave(std::size_t block, std::int32_t body, std::size_t other_block,
                              std::int32_t other_body) const;

 private:
  contact::PairTable pairs_;
  std::vector<contact::BodyFigures> bodies_;
};

}  // namespace brunt::app
