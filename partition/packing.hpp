// SPDX-License-Identifier: Apache-2.0
// A piece of mesh as bytes, sent between ranks of one run (never written to a file: the layout may change).
#pragma once
#include <cstddef>
#include <span>
#include <vector>

#include "mesh/local_mesh.hpp"

namespace brunt::partition {

std::vector<std::byte> pack(mesh::LocalMesh piece);

/// The inverse of `pack`.
mesh::LocalMesh unpack(std::span<const std::byte> bytes);

}  // namespace brunt::partition
