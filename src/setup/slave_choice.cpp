// SPDX-License-Identifier: Apache-2.0
#include "setup/slave_choice.hpp"

#include <array>

#include "setup/likely_slaves.hpp"

namespace brunt::setup {

SlaveChoice::SlaveChoice(const mesh::Mesh& mesh, const StartRules& rules)
    : specification_(rules.contact), bodies_(body_figures(mesh, contact_faces(mesh, rules.symmetric), rules.density)) {}

bool SlaveChoice::is_slave(std::size_t block, std::int32_t body, std::size_t other_block,
                           std::int32_t other_body) const {
  const std::array own{static_cast<std::int32_t>(block)};
  return contact::is_primary_slave(specification_, bodies_, {own, body}, static_cast<std::int32_t>(other_block),
                                   other_body);
}

bool SlaveChoice::is_held_off(std::size_t block, std::int32_t body, std::size_t other_block,
                              std::int32_t other_body) const {
  const std::array own{static_cast<std::int32_t>(block)};
  return contact::may_meet(specification_, bodies_, {own, body}, static_cast<std::int32_t>(other_block), other_body);
}

}  // namespace brunt::setup
