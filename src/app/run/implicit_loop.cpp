// SPDX-License-Identifier: Apache-2.0
#include "implicit_loop.hpp"

#include <utility>

#include "app/watch/driven_apart.hpp"
#include "app/watch/element_place.hpp"
#include "app/watch/implicit_watch.hpp"
#include "implicit/step.hpp"

namespace brunt::app {

void implicit_step(Prepared& run) {
  implicit::advance(
      implicit_scene(run), *run.implicit, [&](GlobalIndex gid) { return name_of_node(run, gid); },
      [&] { return objection_to_step(run); });
  implicit::Solver& solver = *run.implicit;
  const bool acts = solver.contact.counts.active + implicit::pressed(run.links.ranks, solver.walls) > 0;
  solver.work.contact_steps += acts ? 1 : 0;
  stop_where_driven_apart(run);
}

void write_implicit_record(Prepared& run, Results& results, const ImplicitRecord& record, double seconds_left) {
  const auto timed = run.links.timers.measure(Phase::output);
  const RecordTime at{static_cast<GlobalIndex>(run.state.step), run.state.time};
  time::StepReport step;
  step.dt = run.state.dt;
  if (record.fields) {
    results.read_fields();
    results.write_fields(nullptr);
  }
  if (record.row) results.read_probes();
  const time::Ledger ledger = implicit::ledger(implicit_scene(run), *run.implicit);
  if (record.row) results.write_history(ledger, step, at);
  results.watch_depth(true);
  results.watch(ledger, run.state.time);
  if (record.line) results.table_line(ledger, step, at, seconds_left);
}

}  // namespace brunt::app
