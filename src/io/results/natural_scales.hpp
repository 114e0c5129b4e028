// SPDX-License-Identifier: Apache-2.0
// What a quantity is compared with that is a small difference of large ones, so that its own size says nothing about
// its accuracy: gaps are differences of places, energies are terms of one balance, momenta are sums over bodies. 0: the
// quantity's own largest value is its scale.
#pragma once
#include <string>
#include <vector>

#include "io/hdf5.hpp"
#include "io/results/history.hpp"

namespace brunt::io {

/// Diagonal of the box around the nodes of a state file [length]. Collective.
[[nodiscard]] double size_of_mesh(const Hdf5File& file);

/// Of a field of the state. size: of the mesh [length].
[[nodiscard]] double natural_scale(const std::string& field, double size);

/// Of each column of A. size: of the mesh [length], 0 where it is not known.
[[nodiscard]] std::vector<double> natural_scales(const History& a, const History& b, double size);

}  // namespace brunt::io
