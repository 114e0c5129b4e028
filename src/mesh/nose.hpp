// SPDX-License-Identifier: Apache-2.0
// Noses on the upper end of cylinders and tubes, with the nodes of that end.
#pragma once
#include <vector>

#include "hex_body.hpp"
#include "outline.hpp"

namespace brunt::mesh {

/// Which surfaces a node of a round body is on, one bit each.
using Marks = unsigned char;
constexpr Marks on_side = 1, on_inner = 2, on_nose = 4, on_bottom = 8, on_top = 16;

/// A round body, built upwards.
struct RoundBody {
  Hexahedra cells;
  std::vector<Marks> mark;  ///< of each node
  LocalIndex end = 0;       ///< the first node of its upper end, which has the nodes of the section in order
};

/// Layers of the section that become narrower along the outline, up to a flat tip. `inner` is the constant inner
/// radius.
void add_blunt_nose(RoundBody& body, const Section& section, const Outline& outline, double inner, int layers);

/// A half ball on the disk of the same map, moved to the outline.
void add_pointed_nose(RoundBody& body, const Section& section, const RoundedCore& core, const Half& half,
                      const Outline& outline);

/// A quarter of a disk, rotated about the axis with the rays and moved to the outline.
void add_pointed_nose(RoundBody& body, const Rays& rays, const Outline& outline);

}  // namespace brunt::mesh
