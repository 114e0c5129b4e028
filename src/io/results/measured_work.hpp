// SPDX-License-Identifier: Apache-2.0
// The work measured by the ranks of a run, stored in a checkpoint beside the state: weights of a later partition. A
// restart does not need it, and it differs between runs.
//
// Layout: /measured/ranks [ranks][2]: processor time of a step in elements and in contact, without messages [s];
//         /measured/elements [elements][2], in canonical order: the rank that computed the element, and the candidate
//         pairs of contact that this rank looked at for its nodes.
#pragma once
#include <string>
#include <vector>

#include "comm/communicator.hpp"
#include "core/types.hpp"

namespace brunt::io {

/// Of one rank.
struct RankWork {
  double element_seconds = 0, contact_seconds = 0;  ///< a step, processor time without messages [s]
  std::vector<std::vector<double>> pairs{};         ///< by block and element: candidate pairs of contact
};

/// Of all ranks.
struct MeasuredWork {
  std::vector<double> element_seconds, contact_seconds;  ///< by rank [s]
  std::vector<Rank> rank;                                ///< of each element in canonical order
  std::vector<double> pairs;                             ///< likewise
};

/// Throws InputError with the file if it is not a checkpoint, has no such data, or they are damaged. Not collective:
/// for the root only.
[[nodiscard]] MeasuredWork read_measured_work(const std::string& checkpoint);

}  // namespace brunt::io
