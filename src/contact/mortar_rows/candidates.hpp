// SPDX-License-Identifier: Apache-2.0
// Which facets of slaves and masters may share a segment until the lists are rebuilt, and the numbers that decide about
// mortar rows.
#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "core/ragged.hpp"
#include "core/types.hpp"

namespace brunt::contact {

/// A face of a slave's surface, with contact nodes as corners, counter-clockwise seen from outside.
struct MortarFacet {
  GlobalIndex key = 0;
  std::array<LocalIndex, 4> nodes{};
  std::int32_t corner_count = 4;
  std::int32_t body = 0, block = 0;
  double element_depth = 0;  ///< of the element behind it [length]
};

struct MortarCandidates {
  std::vector<MortarFacet> facets;  ///< around the slaves, by key
  Ragged<LocalIndex> masters;       ///< of each facet: faces, by body and key
  std::vector<LocalIndex> slave;    ///< contact nodes owned here, ascending
  Ragged<LocalIndex> around;        ///< of each slave: facets, by key
  bool any = false;                 ///< on any rank: facets that may share a segment
};

/// Numbers that decide, see README.md.
struct KeptNumbers {
  double motion = 0.05;  ///< of the size: relative motion after which weights are integrated anew
  double steps = 100;    ///< steps after which they are integrated anew in any case
  double weight = 2;     ///< of one node: dual functions with a larger one are replaced by shape functions
};
constexpr KeptNumbers kept_numbers{};

}  // namespace brunt::contact
