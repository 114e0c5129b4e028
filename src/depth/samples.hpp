// SPDX-License-Identifier: Apache-2.0
// Starts from samples of the contact space, for many queries of one pair: placements of A that touch B are computed
// once, and the local search of a query begins at the nearest ones.
//
// L. Zhang, Y. J. Kim, D. Manocha, A fast and practical algorithm for generalized penetration depth computation (2007),
// section IV.D: a contact placement lies between a colliding and a free random one; at run time the K nearest in the
// metric of the query are taken, at a distance from each other. Figures: README.md, "Starts from samples".
#pragma once
#include <cstddef>
#include <optional>
#include <vector>

#include "depth/encounter.hpp"
#include "depth/starts.hpp"

namespace brunt::depth {

struct SampleSearch {
  std::size_t nearest = 10;  ///< K
  double spacing = 0.1;      ///< of the length: samples nearer to each other share a walk
};

/// Free placements that touch, in the coordinates of B. A fixed sequence of numbers, so the same everywhere; fewer than
/// asked for where the bodies hardly ever collide.
[[nodiscard]] std::vector<Placement> sample_contacts(const Body& a, const Body& b, std::size_t count);

/// The samples nearest to the given placement, the shortest motions first.
[[nodiscard]] std::vector<Start> nearest_samples(const Encounter& encounter, Metric metric,
                                                 const std::vector<Placement>& samples,
                                                 const SampleSearch& options = {});

/// The end of the best walk from the nearest samples: for `Query::tries`. None for translations, which cannot turn into
/// a sample, and where no sample can be freed.
[[nodiscard]] std::optional<Placement> best_from_samples(Encounter& encounter, Metric metric,
                                                         const std::vector<Placement>& samples,
                                                         const SampleSearch& options = {});

}  // namespace brunt::depth
