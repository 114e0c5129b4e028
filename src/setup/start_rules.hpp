// SPDX-License-Identifier: Apache-2.0
// Rules of a scene for its initial geometry: which blocks may touch, and how their overlaps are treated.
#pragma once
#include <optional>
#include <vector>

#include "contact/data/specification.hpp"
#include "contact/surface/surface.hpp"
#include "mesh/mesh.hpp"

namespace brunt::setup {

using contact::OverlapRule;

/// Of the blocks of one mesh, in their order.
struct StartRules {
  std::vector<std::optional<OverlapRule>> overlap;  ///< of blocks (a, b) at a * blocks + b; none: they have no contact
  contact::Specification contact;
  std::vector<double> density;                     ///< [mass/length^3]
  std::vector<std::vector<LocalIndex>> symmetric;  ///< nodes in each plane of symmetry, ascending

  [[nodiscard]] std::optional<OverlapRule> overlap_of(std::size_t a, std::size_t b) const {
    return overlap[a * density.size() + b];
  }
};

/// Exterior faces except those in planes of symmetry, which touch nothing.
std::vector<mesh::Side> contact_faces(const mesh::Mesh& mesh, const std::vector<std::vector<LocalIndex>>& symmetric);

}  // namespace brunt::setup
