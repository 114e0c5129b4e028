// SPDX-License-Identifier: Apache-2.0
// The steps of an implicit run, and what is to be written about each t_n.
#pragma once
#include <nlohmann/json.hpp>

#include "brunt/implicit/ledger.hpp"
#include "brunt/implicit/solver.hpp"
#include "prepare.hpp"
#include "results.hpp"

namespace brunt::app {

/// As a scene names it.
const char* name_of(model::Scheme scheme);

/// The four that implicit steps see of a prepared run.
implicit::Scene implicit_scene(Prepared& run);

/// One step from t_n to t_{n+1}. Throws GuardError where none can be found: the state is that of t_n then. Also where
/// it is found, but supports drive the two sides of a tie apart. Collective.
void implicit_step(Prepared& run);

/// Fields, history and table at t_n, between steps.
struct ImplicitRecord {
  bool fields = false, row = false, line = false;
};
void write_implicit_record(Prepared& run, Results& results, const ImplicitRecord& record, double seconds_left);

/// What rounding of places leaves in the balance of energy: forces that Newton's iteration cannot see, along travels of
/// the size of the model [energy].
double implicit_rounding(const Prepared& run, double extent);

/// Walls that do not move give nothing, but newmark and hht make energy where bodies meet them.
bool walls_make_energy(const Prepared& run, const time::Ledger& ledger, double largest_energy);

/// "implicit" of summary.json. The same on all ranks.
nlohmann::ordered_json implicit_summary(const Prepared& run);

}  // namespace brunt::app
