// SPDX-License-Identifier: Apache-2.0
// The mesh of the caller of ContactStep, whole and in canonical order, and where its elements came from.
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "brunt/contact_step.hpp"
#include "comm/communicator.hpp"
#include "mesh/canonical.hpp"

namespace brunt::api {

/// Of the root; empty elsewhere.
struct GatheredMesh {
  mesh::CanonicalMesh mesh;  ///< a block for each part and shape; node_id: the caller's numbers
  std::vector<Rank> rank_of_element;
};

/// Throws std::invalid_argument on all ranks where the pieces do not fit together. Collective.
GatheredMesh gather(const comm::Communicator& ranks, const ContactMesh& given);

/// Position of each of `wanted` in `numbers`, where each occurs.
std::vector<std::size_t> places_of(std::span<const std::int64_t> numbers, std::span<const GlobalIndex> wanted);

}  // namespace brunt::api
