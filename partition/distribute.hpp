// SPDX-License-Identifier: Apache-2.0
// From the whole mesh on the root rank to a piece on every rank.
#pragma once
#include <span>

#include "comm/communicator.hpp"
#include "core/types.hpp"
#include "mesh/canonical.hpp"
#include "mesh/local_mesh.hpp"

namespace brunt::partition {

/// The piece of this rank. `whole` and `part` (the rank of each element in canonical order) are read on `root` only.
/// The pieces are made and sent one after the other, so that the root never stores more than the whole mesh and one
/// piece. Collective.
mesh::LocalMesh distribute(const comm::Communicator& ranks, const mesh::CanonicalMesh& whole,
                           std::span<const Rank> part, Rank root = 0);

}  // namespace brunt::partition
