// SPDX-License-Identifier: Apache-2.0
// Distribution of the work of a run over the ranks: neighbours, imbalance, messages and memory, for summary.json.
#pragma once
#include <nlohmann/json_fwd.hpp>
#include <span>

#include "comm/traffic.hpp"
#include "core/timers.hpp"
#include "model/model.hpp"

namespace brunt::app {

/// The work of one rank in the loop of a run, without output.
struct RankWork {
  double steps = 0;
  comm::Traffic sent;
  Timers timers;
};

struct MeanAndMax {
  double mean = 0, max = 0;
  [[nodiscard]] double imbalance() const { return mean > 0 ? max / mean : 1.0; }  ///< 1 is perfect
};
MeanAndMax mean_and_max(std::span<const double> values);

/// Number of other ranks that hold a node of this one.
int neighbours_of(const mesh::LocalMesh& mesh);

/// The object `parallel` of summary.json: the same on all ranks. Collective.
nlohmann::ordered_json parallel_summary(const comm::Communicator& ranks, const model::Model& model,
                                        const RankWork& work);

}  // namespace brunt::app
