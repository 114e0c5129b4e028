// SPDX-License-Identifier: Apache-2.0
// What is said of an implicit run: its stability, its energy, its part of the summary.
#pragma once
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "app/state/prepared.hpp"

namespace brunt::app {

/// The name in a scene.
const char* name_of(model::Scheme scheme);

/// Warnings about the stability of static states that have not been given. Collective.
std::vector<std::string> warnings_of_stability(Prepared& run);

/// Rounding of positions in the balance of energy: forces that Newton's method cannot resolve, times displacements of
/// the size of the model [energy].
double implicit_rounding(const Prepared& run, double extent);

/// Walls at rest supply no energy, but newmark and hht generate energy when bodies hit them.
bool walls_make_energy(const Prepared& run, const time::Ledger& ledger, double largest_energy);

/// "implicit" of summary.json. The same on all ranks.
nlohmann::ordered_json implicit_summary(const Prepared& run);

}  // namespace brunt::app
