// SPDX-License-Identifier: Apache-2.0
// The hexahedra of a ball, or of its halves.
#pragma once
#include "hex_body.hpp"
#include "mesh/mesh.hpp"
#include "mesh/round_form.hpp"

namespace brunt::mesh {

struct Ball {
  Hexahedra cells;
  LocalIndex inner = 0;  ///< so many nodes come before those on the surface
};

/// Centre at the origin: core cells in rows, then shells from the core outwards. Its nodes in the plane z = 0 are those
/// of the disk of the same map.
Ball ball(const RoundedCore& shape, const Half& half);

}  // namespace brunt::mesh
