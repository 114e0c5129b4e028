// SPDX-License-Identifier: Apache-2.0
// A kept row where the bodies are now: its normal, its gap, and weights that have followed the slip.
#pragma once
#include <span>

#include "contact/data/mortar_history.hpp"
#include "contact/mortar_rows/covers.hpp"

namespace brunt::contact {

/// Terms of nodes, then of facets, and where they are.
struct KeptRow {
  const MortarHead& head;
  std::span<const MortarTerm> terms;
  std::span<const LocalIndex> places;
  std::size_t nodes = 0;  ///< of the terms, those of nodes
};
KeptRow kept_row(const MortarHistory& history, std::span<const LocalIndex> places, std::size_t r);

struct PlacedRow {
  Vec3 normal = Vec3::Zero();  ///< unit, out of the master
  double gap = 0;              ///< without what was born [length]
};
/// facet_normal: of the candidates, unit. apart: sum of kept weights and present positions [length]. weights: the kept
/// ones of nodes, which follow the slip.
PlacedRow place_row(const KeptRow& row, const MortarScene& scene, std::span<const Vec3> facet_normal, const Vec3& apart,
                    std::span<double> weights);

}  // namespace brunt::contact
