// SPDX-License-Identifier: Apache-2.0
// Restart from a checkpoint: its choice, whether it belongs to the scene, and the alternative to a damaged one.
#pragma once
#include <string>

#include "app/state/prepared.hpp"
#include "io/results/checkpoint.hpp"

namespace brunt::app {

/// The checkpoint of `--restart`: a file, or the latest one of a folder. Collective; throws InputError.
std::string checkpoint_of(const comm::Communicator& ranks, const std::string& restart);

/// Sets the state to that of the checkpoint. Collective; throws InputError with the keys of the scene that differ, or
/// with the last intact checkpoint before a damaged one.
io::CheckpointHeader restart_from(Prepared& run, const std::string& checkpoint);

}  // namespace brunt::app
