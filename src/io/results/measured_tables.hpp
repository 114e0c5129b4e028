// SPDX-License-Identifier: Apache-2.0
// The group /measured of a checkpoint (io/results/measured_work.hpp).
#pragma once
#include <string>
#include <vector>

#include "checkpoint_tables.hpp"
#include "io/hdf5.hpp"
#include "io/results/measured_work.hpp"
#include "model/registry.hpp"

namespace brunt::io {

/// Collective.
void write_measured(Hdf5File& file, const RankWork& work, const model::Registry& registry, const TableLayout& layout);

/// The tables of the file that are of the state. Collective.
[[nodiscard]] std::vector<std::string> state_tables(const Hdf5File& file);

}  // namespace brunt::io
