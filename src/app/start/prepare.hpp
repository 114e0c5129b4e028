// SPDX-License-Identifier: Apache-2.0
// From a scene file to all data of a run, on all ranks.
#pragma once
#include <memory>
#include <string>
#include <vector>

#include "app/state/prepared.hpp"

namespace brunt::app {

/// `partition`: a file with the rank of each element; empty: the partition is computed here. Collective; throws
/// InputError on all ranks.
std::unique_ptr<Prepared> prepare(const comm::Communicator& ranks, const std::string& scene_file,
                                  const std::vector<std::string>& overrides, const std::string& partition = "");

/// Rejects initial overlaps that the scene does not admit; the others become warnings. Collective; throws InputError on
/// all ranks.
void refuse_overlaps(Prepared& run);

}  // namespace brunt::app
