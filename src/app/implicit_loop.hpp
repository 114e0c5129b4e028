// SPDX-License-Identifier: Apache-2.0
// The steps of an implicit run, and the output at each t_n.
#pragma once
#include <nlohmann/json.hpp>

#include "brunt/implicit/ledger.hpp"
#include "brunt/implicit/solver.hpp"
#include "prepare.hpp"
#include "results.hpp"

namespace brunt::app {

/// The name in a scene.
const char* name_of(model::Scheme scheme);

/// The parts of a prepared run that implicit steps use.
implicit::Scene implicit_scene(Prepared& run);

/// One step from t_n to t_{n+1}. Throws GuardError if none is found, with the state of t_n; also if it is found, but
/// supports separate the two sides of a tie. Collective.
void implicit_step(Prepared& run);

/// Warnings about the stability of static states that have not been given. Collective.
std::vector<std::string> warnings_of_stability(Prepared& run);

/// Fields, history and table at t_n, between steps.
struct ImplicitRecord {
  bool fields = false, row = false, line = false;
};
void write_implicit_record(Prepared& run, Results& results, const ImplicitRecord& record, double seconds_left);

/// Rounding of positions in the balance of energy: forces that Newton's method cannot resolve, times displacements of
/// the size of the model [energy].
double implicit_rounding(const Prepared& run, double extent);

/// Walls at rest supply no energy, but newmark and hht generate energy when bodies hit them.
bool walls_make_energy(const Prepared& run, const time::Ledger& ledger, double largest_energy);

/// "implicit" of summary.json. The same on all ranks.
nlohmann::ordered_json implicit_summary(const Prepared& run);

}  // namespace brunt::app
