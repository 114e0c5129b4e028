// SPDX-License-Identifier: Apache-2.0
// Elements of one solid in the space of another although every surface node of both lies on the other's surface: what
// neither nodes nor edges tell (two bodies of one outline, one put where the other is).
#pragma once
#include <cstddef>

#include "brunt/setup/solids.hpp"

namespace brunt::setup {

struct ElementsInside {
  std::size_t count = 0;
  LocalIndex first = no_index;  ///< of the block
};

/// Elements of block `one` whose middle lies in an element of block `other`.
ElementsInside elements_inside(const mesh::Mesh& mesh, const mesh::Block& one, const mesh::Block& other,
                               const contact::Tolerances& tolerances);

}  // namespace brunt::setup
