// SPDX-License-Identifier: Apache-2.0
// The fields of state.h5, read from the state at t_n.
#pragma once
#include <string>
#include <vector>

#include "brunt/contact/contact.hpp"
#include "brunt/io/state_file.hpp"
#include "prepare.hpp"

namespace brunt::app {

/// In the order of `io::state_mesh`: owned nodes, elements block by block.
std::vector<io::StateField> state_fields(const Prepared& run, const contact::Contact* contact);

}  // namespace brunt::app
