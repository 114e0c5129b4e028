// SPDX-License-Identifier: Apache-2.0
// The steps of an implicit run, and the output at each t_n.
#pragma once
#include "app/report/results.hpp"
#include "app/state/prepared.hpp"
#include "implicit/ledger.hpp"
#include "implicit/solver.hpp"

namespace brunt::app {

/// One step from t_n to t_{n+1}. Throws GuardError if none is found, with the state of t_n; also if it is found, but
/// supports separate the two sides of a tie. Collective.
void implicit_step(Prepared& run);

/// Fields, history and table at t_n, between steps.
struct ImplicitRecord {
  bool fields = false, row = false, line = false;
};
void write_implicit_record(Prepared& run, Results& results, const ImplicitRecord& record, double seconds_left);

}  // namespace brunt::app
