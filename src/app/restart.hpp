// SPDX-License-Identifier: Apache-2.0
// Going on from a checkpoint: which one, whether it fits the scene, and what to do where it is damaged.
#pragma once
#include <string>

#include "brunt/io/checkpoint.hpp"
#include "prepare.hpp"

namespace brunt::app {

/// The checkpoint that `--restart` means: a file, or the latest of a folder. Collective; throws InputError.
std::string checkpoint_of(const comm::Communicator& ranks, const std::string& restart);

/// Makes the state that of the checkpoint. Collective; throws InputError that says which keys of the scene differ, or
/// which whole checkpoint stands before a damaged one.
io::CheckpointHeader restart_from(Prepared& run, const std::string& checkpoint);

}  // namespace brunt::app
