// SPDX-License-Identifier: Apache-2.0
#include "slave_choice.hpp"

#include <array>

#include "brunt/contact/likely_slaves.hpp"
#include "brunt/scene/build.hpp"
#include "contact_setup.hpp"
#include "weights.hpp"

namespace brunt::app {

SlaveChoice::SlaveChoice(const scene::Input& input, const mesh::Mesh& mesh) {
  const BlockMaterials blocks = block_materials(input, mesh);
  pairs_ = pair_table(scene::contact_rule(input, blocks.part), blocks.part.size());
  bodies_ = contact::body_figures(mesh, contact_faces(input, mesh), blocks.density);
}

bool SlaveChoice::is_slave(std::size_t block, std::int32_t body, std::size_t other_block,
                           std::int32_t other_body) const {
  const std::array own{static_cast<std::int32_t>(block)};
  return contact::leads(pairs_, bodies_, {own, body}, static_cast<std::int32_t>(other_block), other_body);
}

bool SlaveChoice::is_held_off(std::size_t block, std::int32_t body, std::size_t other_block,
                              std::int32_t other_body) const {
  const std::array own{static_cast<std::int32_t>(block)};
  return contact::may_meet(pairs_, bodies_, {own, body}, static_cast<std::int32_t>(other_block), other_body);
}

}  // namespace brunt::app
