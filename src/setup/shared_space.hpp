// SPDX-License-Identifier: Apache-2.0
// Elements of one solid inside another although every surface node of both lies on the other's surface. Neither nodes
// nor edges show this (two bodies of the same shape in the same place).
#pragma once
#include <cstddef>

#include "setup/solids.hpp"

namespace brunt::setup {

struct ElementsInside {
  std::size_t count = 0;
  LocalIndex first = no_index;  ///< of the block
};

/// Elements of block `one` whose centre lies in an element of block `other`.
ElementsInside elements_inside(const mesh::Mesh& mesh, const mesh::Block& one, const mesh::Block& other,
                               const contact::Tolerances& tolerances);

}  // namespace brunt::setup
