// SPDX-License-Identifier: Apache-2.0
// The nodes of an element's face, for loops over all of them.
#pragma once
#include <array>

#include "core/cells.hpp"
#include "mesh/mesh.hpp"

namespace brunt::mesh {

constexpr std::array<LocalIndex, 4> no_face{no_index, no_index, no_index, no_index};

/// Distinct ones in order, then no_index; `no_face` where fewer than three are distinct.
inline std::array<LocalIndex, 4> without_repeats(const std::array<LocalIndex, 4>& corners) {
  std::array<LocalIndex, 4> nodes = no_face;
  std::size_t count = 0;
  for (const LocalIndex node : corners) {
    const bool repeated =
        (count > 0 && nodes[0] == node) || (count > 1 && nodes[1] == node) || (count > 2 && nodes[2] == node);
    if (!repeated && node != no_index) nodes[count++] = node;
  }
  return count < 3 ? no_face : nodes;
}

/// The one face of a shell seen from below.
inline std::array<LocalIndex, 4> corners_of_bottom(Shape shape, const LocalIndex* element) {
  if (shape == Shape::tri3) return {element[0], element[2], element[1], no_index};
  return {element[0], element[3], element[2], element[1]};
}

/// As mesh::face_nodes; nearly all faces have no node twice.
inline std::array<LocalIndex, 4> corners_of_face(Shape shape, const LocalIndex* element, int face) {
  if (cells::is_surface(shape) && face == 1) return corners_of_bottom(shape, element);
  const cells::Face& c = nth(cells::of(shape).faces, face);
  const std::array<LocalIndex, 4> n{element[c[0]], element[c[1]], element[c[2]], c[3] < 0 ? no_index : element[c[3]]};
  const bool repeats =
      (n[0] == n[1]) | (n[1] == n[2]) | (n[2] == n[3]) | (n[3] == n[0]) | (n[0] == n[2]) | (n[1] == n[3]);
  return repeats ? without_repeats(n) : n;
}

}  // namespace brunt::mesh
