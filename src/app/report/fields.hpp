// SPDX-License-Identifier: Apache-2.0
// The fields of state.h5, read from the state at t_n.
#pragma once
#include <string>
#include <vector>

#include "app/state/prepared.hpp"
#include "contact/contact.hpp"
#include "io/results/state_file.hpp"

namespace brunt::app {

/// Fields of the motion and the elements, to be read between evaluate and advance, in the order of `io::state_mesh`:
/// owned nodes, elements block by block.
std::vector<io::StateField> state_fields(const Prepared& run);

/// Fields of contact at t_n, to be read after advance; `dt_mean`: the time over which impulses act.
std::vector<io::StateField> contact_fields(const Prepared& run, double dt_mean);

}  // namespace brunt::app
