// SPDX-License-Identifier: Apache-2.0
// The part of Results that evaluates guards and warnings.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "app/start/implicit_rules.hpp"
#include "app/watch/driven_apart.hpp"
#include "app/watch/element_place.hpp"
#include "app/watch/stop_causes.hpp"
#include "contact/data/tolerances.hpp"
#include "core/error.hpp"
#include "force/folded.hpp"
#include "implicit/solver.hpp"
#include "implicit_report.hpp"
#include "results.hpp"
#include "scene/text/units.hpp"

namespace brunt::app {
namespace {

bool all_rigid(const model::Model& model) {
  return std::ranges::all_of(model.blocks,
                             [](const model::ElementBlock& block) { return material::is_rigid(block.law); });
}

/// Empty where something deforms.
std::string cause_if_rigid(const Prepared& run) {
  if (!all_rigid(run.model)) return {};
  return cause_among_rigid_bodies(
      {.contact = !run.input.contact.empty(),
       .walls = !run.model.touching.walls.empty(),
       .drives = !run.input.prescribed.empty(),
       .moving_walls = std::ranges::any_of(run.model.touching.walls, &model::RigidWall::moves),
       .joints = !run.model.joints.empty(),
       .at_limit = run.contact && run.contact->ledger.statistics.steps_at_limit > 0});
}

/// Work of the forces on bodies over the rounding of places that joints hold: 4 eps of the distance, and of a turn
/// [energy].
double rounding_of_joints(const model::Scratch& scratch, double extent) {
  double work = 0;
  for (const model::BodyStep& body : scratch.bodies)
    work +=
        extent * (body.loads.force + body.elements.force).norm() + (body.loads.moment + body.elements.moment).norm();
  return 4 * std::numeric_limits<double>::epsilon() * work;
}

/// What contact of this run may give. Mortar contact of the implicit schemes gives within a step what it took in
/// another.
Gives gives(const Prepared& run) {
  if (run.overlaps.recovered) return Gives::parting;
  const contact::EnforcementSettings& settings = run.model.touching.contact.enforcement;
  const contact::Method method = settings.method;
  const bool springs = method == contact::Method::gap_penalty || method == contact::Method::penalty;
  const bool elastic = settings.impact == contact::Impact::elastic;  // what rows keep as a bank is booked as taken
  return run.implicit || springs || elastic ? Gives::stored : Gives::nothing;
}

/// Whether faults of energies are judged at the end, as shares of the energy of the whole run: see note_worst.
bool judged_at_end(const Prepared& run) {
  return run.implicit && run.implicit->settings.scheme == model::Scheme::statics;
}

/// The row by which friction gave most in the last step. Collective.
std::string where_friction_gives(const Prepared& run) {
  if (!run.contact) return "";
  const comm::Communicator& ranks = run.links.ranks;
  const contact::RubbingRow here = contact::most_given_by_friction(*run.contact);
  const bool any = here.slave_gid != no_index;
  const double least = ranks.min(any ? here.work : std::numeric_limits<double>::infinity());
  const bool least_here = any && here.work == least;
  const GlobalIndex slave = ranks.max(least_here ? here.slave_gid : GlobalIndex{-1});
  if (slave < 0) return "";
  const bool mine = least_here && here.slave_gid == slave;
  std::array<double, 3> place;
  place.fill(-std::numeric_limits<double>::infinity());
  if (mine) place = {here.position[0], here.position[1], here.position[2]};
  ranks.max(place);
  const GlobalIndex master = ranks.max(mine ? GlobalIndex{here.master_block} : GlobalIndex{-2});
  return fmt::format("; in the last step the largest contribution was at {} on {}",
                     text_of_point(run, {place[0], place[1], place[2]}),
                     master < 0 ? "a rigid wall" : "part '" + nth(run.model.blocks, master).part + "'");
}

/// Elastic hourglass springs differ from those of `stiffness` only in plastic flow.
const char* remedy_of_folds(const model::ElementBlock& block) {
  const auto* metal = std::get_if<material::Metal>(&block.law);
  if (metal != nullptr && metal->shear == 0)
    return "element: hex8_full, and a shorter run: nothing in a fluid (shear: 0) resists a change of shape, so its "
           "elements fold where it flows far";
  if (block.kind != element::ElementKind::hex8) return "smaller elements there";
  if (std::holds_alternative<material::J2>(block.law)) return "hourglass: {kind: elastic} or element: hex8_full";
  if (std::holds_alternative<material::NeoHookean>(block.law)) return "element: hex8_full";
  return "element: hex8_full or hex8_bbar";
}

}  // namespace

/// The element or contact with the fault: a search, for messages only. Collective.
std::string Results::where(Fault fault) const {
  if (fault == Fault::hourglass || fault == Fault::bulk) {
    const ElementPlace place = place_of_least(run_, fault == Fault::hourglass ? "hourglass_energy" : "bulk_energy");
    return place.element < 0 ? "" : "; the smallest value is in " + text_of(place);
  }
  return fault == Fault::friction ? where_friction_gives(run_) : "";
}

std::string Results::cause_of(Fault fault) const {
  if (run_.implicit) return likely_cause_in_implicit(fault, run_.model, run_.implicit->settings.scheme);
  if (fault != Fault::internal || all_rigid(run_.model)) return likely_cause(fault, cause_if_rigid(run_));
  return cause_of_given_work(run_.model, run_.links.ranks.sum(force::folded_elements(run_.model, run_.state).count));
}

double Results::rounding(const time::Ledger& ledger) const {
  double rounding =
      rounding_energy(ledger.mass, extent_, run_.contact ? run_.contact->surface.mean_edge : 0.0, run_.state.dt);
  if (run_.contact && !run_.model.bodies.empty())
    rounding += settling_energy(ledger.mass, run_.model.loads.gravity.norm(), run_.state.dt,
                                run_.model.touching.contact.enforcement.tolerance,
                                run_.contact->derived.detection.tolerances->recovery);
  if (run_.implicit) rounding += implicit_rounding(run_, extent_);
  if (!run_.model.joints.empty()) rounding += rounding_of_joints(run_.scratch, extent_);
  return rounding;
}

void Results::watch(const time::Ledger& ledger, double time) {
  last_ledger_ = ledger;
  observe(ledger, run_.extremes);
  const scene::Guards& limits = run_.input.guards;
  const double of_rounding = rounding(ledger);
  const bool later = judged_at_end(run_);
  if (later) note_worst(ledger, gives(run_), time, run_.extremes);
  // Once exact multipliers alternate from step to step they supply energy in every step, so an energy above the warning
  // continues to grow.
  const bool trapezoidal = run_.input.implicit && run_.input.implicit->scheme == model::Scheme::newmark;
  const std::string growth =
      energy_growth(ledger, run_.extremes, run_.overlaps.recovered, of_rounding, cause_if_rigid(run_), limits);
  for (const Finding& finding : judge(ledger, run_.extremes, of_rounding, gives(run_), limits)) {
    if (later && finding.fault != Fault::balance) continue;
    bool& reported = nth(reported_, finding.fault);
    const bool makes_energy = trapezoidal && finding.fault == Fault::contact;
    const bool stop = (finding.stop || makes_energy) && growth.empty();
    if (reported && !stop) continue;
    reported = true;
    const std::string text = fmt::format(
        "{}{}; {}", text_of(finding, time), where(finding.fault),
        makes_energy ? "the trapezoidal rule with exact multipliers generates energy: use scheme: contact_implicit"
                     : cause_of(finding.fault));
    if (stop) throw GuardError(text);
    log_.warning(text + " (reported once)");
  }
  if (walls_make_energy(run_, ledger, run_.extremes.largest_energy))
    throw GuardError(
        fmt::format("walls at rest have supplied {:.3g} by t = {:g}, more than {:g} % of the largest energy so far; "
                    "the exact constraints of newmark and hht generate energy in impacts: use scheme: contact_implicit",
                    -ledger.walls, time, 100 * limits.energy_warning));
  if (!growth.empty())
    throw GuardError(fmt::format("energy grows at t = {:g}: {}{}", time, growth,
                                 folded_ > 0 ? fmt::format(" ({} elements are folded)", folded_) : ""));
}

void Results::judge_whole_run(bool complete) {
  if (!judged_at_end(run_) || judged_) return;
  judged_ = true;
  const Extremes& seen = run_.extremes;
  const char* of = complete ? "the largest energy of the run" : "the largest energy so far";
  for (const Finding& finding : judge_whole(seen, rounding(last_ledger_), run_.input.guards)) {
    const std::string text = fmt::format("{} ({:.3g}; external work {:.3g}){}; {}",
                                         text_of(finding, nth(seen.worst_time, finding.fault), of), seen.largest_energy,
                                         last_ledger_.external, where(finding.fault), cause_of(finding.fault));
    if (finding.stop && complete) throw GuardError(text);
    log_.warning(text);
  }
}

void Results::watch_folds() {
  const comm::Communicator& ranks = run_.links.ranks;
  const Recording recording = record();
  const force::FoldedElements here = force::folded_elements(run_.model, run_.state);
  const GlobalIndex count = ranks.sum(here.count);
  if (count > 0 && folded_ == 0) {
    const double worst = ranks.min(here.worst);
    const GlobalIndex element = ranks.max(here.worst == worst ? here.element : -1);
    const auto block = static_cast<std::size_t>(ranks.max(GlobalIndex{here.element == element ? here.block : -1}));
    log_.warning(
        fmt::format("{} {} element{} folded at t = {:g}, step {}, with an inverted corner; the worst is element {} "
                    "(position in the input) of part '{}'. Contact loses nodes behind folded faces and may generate "
                    "energy. Use {} (reported once; folded_elements in summary.json is the largest number)",
                    count, element::name_of(run_.model.blocks[block].kind), count == 1 ? " is" : "s are",
                    run_.state.time, static_cast<GlobalIndex>(run_.state.step), element + 1,
                    run_.model.blocks[block].part, remedy_of_folds(run_.model.blocks[block])));
  }
  folded_ = std::max(folded_, count);
}

void Results::watch_driven() {
  const Recording recording = record();
  if (run_.implicit) {
    for (const std::string& warning : watch_driven_through(run_)) log_.warning(warning);
    for (const std::string& warning :
         implicit::warnings_of_roles(run_.links.ranks, run_.model.mesh.origin, run_.implicit->contact))
      log_.warning(warning);
  }
  if (!run_.contact || run_.implicit) return;
  for (const std::string& warning : run_.driven.look(run_.links.ranks, *run_.contact, run_.model, run_.state,
                                                     scene::find_unit_system(run_.input.units)->length))
    log_.warning(warning);
}

void Results::watch_depth(bool always) {
  if (!always && !depth_.is_due(run_)) return;
  const Recording recording = record();
  for (const std::string& warning : depth_.look(run_)) log_.warning(warning);
}

void Results::stop_if_driven() {
  if (!run_.contact || run_.implicit) return;
  const bool certain = run_.contact->unmet.excess > 1;
  if (certain) watch_driven();
  const std::string text =
      run_.driven.beyond_limit(run_.model, run_.state.time, scene::find_unit_system(run_.input.units)->length, certain);
  if (!text.empty()) throw GuardError(text);
}

void Results::report_at_end() {
  judge_whole_run(false);
  report_hourglass();
  report_parted();
  report_scaled();
  report_turned();
}

void Results::report_turned() {
  const double error = angular_error(last_ledger_, run_.extremes, extent_);
  if (!(error > run_.input.guards.angular_momentum)) return;
  const bool rests = run_.input.implicit && run_.input.implicit->scheme == model::Scheme::statics;
  log_.warning(fmt::format(
      "contact {}: angular_momentum_error is {:.2g}, {:g} at most is usual. Nodes beyond a rim are supported at the "
      "rim, and deep ones far from where they touch: use smaller elements there{}",
      rests ? "forces of bodies on each other have a moment" : "between bodies has supplied angular momentum", error,
      run_.input.guards.angular_momentum, run_.input.implicit ? "" : ", or passes: two"));
}

void Results::report_scaled() {
  if (contact_.scaled_steps == 0) return;
  log_.warning(fmt::format(
      "contact would have generated energy in {} of {} steps whose iteration ended early: the impulses of the bodies "
      "concerned were reduced, to {:.2g} of their value at least, and bodies may have penetrated further; increase "
      "enforcement.max_iterations",
      contact_.scaled_steps, contact_.steps_at_limit, contact_.least_share));
}

void Results::report_parted() {
  // For two equal bodies, one of them initially at rest, a share of 0.03 is a restitution of 0.97: (1 - e^2)/2.
  const double tolerated = run_.input.guards.parted;
  const double share = taken_by_parted(last_ledger_, run_.extremes);
  if (!(share > tolerated) || all_rigid(run_.model)) return;
  log_.warning(fmt::format(
      "contact dissipated {:.2g} % of the largest energy of the bodies, which have separated again, although an "
      "elastic impact is lossless. Contact removes the momentum difference of the first layer of elements, so bodies "
      "with few elements through their thickness rebound too slowly. Use more elements in the direction of impact{}",
      100 * share,
      run_.model.bodies.empty() ? "" : " (for rigid parts that hit each other or a rigid wall the loss is correct)"));
}

void Results::report_hourglass() {
  // 10 % is the usual bound in crash analysis; relative to the largest value, since bodies that separate after an
  // impact have little internal energy.
  const double tolerated = run_.input.guards.hourglass;
  const double hourglass = last_ledger_.hourglass, internal = run_.extremes.largest_internal;
  if (!(hourglass > tolerated * internal) || hourglass < 1e-3 * run_.extremes.largest_energy) return;
  log_.warning(
      fmt::format("hourglass energy is {:.2g} % of the largest internal energy (10 % is the usual bound): the hex8 "
                  "elements are too coarse to represent bending. Use smaller elements, or element: hex8_bbar where "
                  "metal bends and folds, or hourglass: {{kind: elastic}} where corners or edges of solid bodies hit",
                  100 * hourglass / internal));
}

}  // namespace brunt::app
