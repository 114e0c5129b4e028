// SPDX-License-Identifier: Apache-2.0
#include "results.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <limits>
#include <nlohmann/json.hpp>

#include "app/program/commands.hpp"
#include "app/program/failure.hpp"
#include "core/error.hpp"
#include "fields.hpp"
#include "implicit/driven_apart.hpp"
#include "implicit_report.hpp"
#include "io/results/checkpoint.hpp"
#include "io/results/summary.hpp"
#include "model/hash.hpp"
#include "parallel_report.hpp"
#include "scene/text/units.hpp"
#include "time/initialise.hpp"
#include "time/removal.hpp"

namespace brunt::app {
namespace {

const scene::UnitSystem& units_of(const Prepared& run) {
  return *scene::find_unit_system(run.input.units);
}

std::vector<io::HistoryColumn> ledger_columns(const scene::UnitSystem& units) {
  std::vector<io::HistoryColumn> columns{{"time", units.time}, {"dt", units.time}};
  for (const char* term : {"kinetic", "internal", "hourglass", "bulk", "damping", "contact", "friction", "walls",
                           "external", "eroded", "total"})
    columns.push_back({term, units.energy});
  columns.push_back({"mass", units.mass});
  for (const char* c : {"x", "y", "z"}) columns.push_back({fmt::format("momentum_{}", c), units.momentum});
  columns.push_back({"active_contacts", ""});
  columns.push_back({"max_penetration", units.length});
  columns.push_back({"driven", units.energy});
  return columns;
}

/// Name of the element that controls the step, told to the root by the rank that has it.
std::string controlling_element(const Prepared& run, const time::StepReport& step) {
  const double largest = run.links.ranks.max(step.elements.rate);
  const bool mine = step.elements.rate == largest && step.elements.block >= 0;
  GlobalIndex gid = -1;
  if (mine) gid = nth(run.model.blocks, step.elements.block).input[static_cast<std::size_t>(step.elements.element)];
  gid = run.links.ranks.max(gid);                     // where two have the same rate, one of them is named
  return gid < 0 ? "-" : fmt::format("{}", gid + 1);  // rigid bodies alone: run.step
}

nlohmann::ordered_json energy_summary(const time::Ledger& e, double error_ratio) {
  return {{"kinetic", e.kinetic},      {"internal", e.internal}, {"hourglass", e.hourglass}, {"bulk", e.bulk},
          {"damping", e.damping},      {"contact", e.contact},   {"friction", e.friction},   {"walls", e.walls},
          {"external", e.external},    {"driven", e.driven},     {"eroded", e.eroded},       {"total", e.total()},
          {"error_ratio", error_ratio}};
}

/// Half of the diagonal of the model at the start [length]. Collective.
double half_diagonal(const Prepared& run) {
  std::array<double, 6> far;
  far.fill(-std::numeric_limits<double>::infinity());
  for (const Quad& place : run.model.reference)
    for (std::size_t c = 0; c < 3; ++c) {
      far[c] = std::max(far[c], place[static_cast<int>(c)]);
      far[3 + c] = std::max(far[3 + c], -place[static_cast<int>(c)]);
    }
  run.links.ranks.max(far);
  return 0.5 * std::hypot(far[0] + far[3], far[1] + far[4], far[2] + far[5]);
}

}  // namespace

Results::Results(Prepared& run, std::string folder, const std::optional<KeptRecords>& kept, Log& log)
    : run_(run), folder_(std::move(folder)), log_(log), probes_(run, units_of(run)) {
  std::vector<io::HistoryColumn> columns = ledger_columns(units_of(run));
  columns.insert(columns.end(), probes_.columns().begin(), probes_.columns().end());
  on_root(run.links.ranks, [&] {  // a history that does not fit is refused on all ranks
    history_ = std::make_unique<io::HistoryFile>(folder_ + "/history.csv", columns,
                                                 kept ? std::optional(kept->rows) : std::nullopt);
  });
  io::StateMesh mesh = io::state_mesh(run.model.mesh, run.links.ranks.rank());
  for (std::size_t b = 0; b < mesh.blocks.size(); ++b) mesh.blocks[b].part = run.model.blocks[b].part;
  states_ = std::make_unique<io::StateFile>(run.links.ranks, folder_, std::move(mesh),
                                            kept ? std::optional(kept->fields) : std::nullopt);
  const scene::UnitSystem& units = units_of(run);
  if (units.metre > 0)
    for (const auto& [quantity, unit] : {std::pair{"time", units.time},
                                         {"length", units.length},
                                         {"mass", units.mass},
                                         {"velocity", units.velocity},
                                         {"stress", units.stress}})
      states_->name_unit(quantity, unit);
  extent_ = half_diagonal(run);
}

void Results::warn_of_missing_rows(const io::CheckpointHeader& checkpoint) {
  if (!history_ || checkpoint.history_rows < 0) return;
  const std::string path = folder_ + "/history.csv";
  if (const auto gap = io::history_gap(path, checkpoint.history_rows, checkpoint.time))
    log_.warning(
        fmt::format("{}: {} of the {} rows up to this checkpoint are missing (largest gap: from t = {:g} to t = {:g}); "
                    "the run continues without them",
                    path, gap->missing, checkpoint.history_rows, gap->from, gap->to));
}

void Results::read_fields() {
  const Recording recording = record();
  fields_ = state_fields(run_);
  fields_step_ = run_.state.step;
  fields_time_ = run_.state.time;
}

void Results::write_fields(const time::StepReport* step) {
  const Recording recording = record();
  const std::vector<io::StateField> contact = contact_fields(run_, step ? step->dt_mean : 0.0);
  fields_.insert(fields_.end(), contact.begin(), contact.end());
  states_->write(static_cast<GlobalIndex>(fields_step_), fields_time_, fields_);
  fields_.clear();
}

void Results::write_history(const time::Ledger& ledger, const time::StepReport& step, const RecordTime& at) {
  const Recording recording = record();
  const std::vector<double> probes = probes_.values(run_, ledger.contact_totals, step.dt_mean);
  if (!history_) return;
  std::vector<double> row{at.time,
                          step.dt,
                          ledger.kinetic,
                          ledger.internal,
                          ledger.hourglass,
                          ledger.bulk,
                          ledger.damping,
                          ledger.contact,
                          ledger.friction,
                          ledger.walls,
                          ledger.external,
                          ledger.eroded,
                          ledger.total(),
                          ledger.mass,
                          ledger.momentum[0],
                          ledger.momentum[1],
                          ledger.momentum[2],
                          static_cast<double>(ledger.contact_totals.active),
                          ledger.contact_totals.penetration,
                          ledger.driven};
  row.insert(row.end(), probes.begin(), probes.end());
  history_->write(at.step, row);
}

void Results::remember_good() {
  watch_driven();
  const Recording recording = record();
  last_good_.take(run_.registry());
}

void Results::accept(double step) {
  if (checkpoint_step_ < 0 || checkpoint_step_ > step || accepted_step_ == checkpoint_step_) return;
  accepted_step_ = checkpoint_step_;
  accepted_ = checkpoint_;
}

std::string Results::save_last_good() {
  if (checkpoint_step_ > accepted_step_) {
    on_root(run_.links.ranks, [&] { std::filesystem::remove(checkpoint_); });
    checkpoint_step_ = accepted_step_;
  }
  if (last_good_.empty()) return accepted_;
  const double step_of_guard = run_.state.step;
  const Extremes seen = run_.extremes;  // the summary is about all that was seen
  const std::vector<double> driven = run_.driven.saved();
  last_good_.give_back(run_.registry());
  run_.after_restart();
  // an implicit step that fails leaves the state of t_n, which was right
  const bool before = run_.implicit ? run_.state.step <= step_of_guard : run_.state.step < step_of_guard;
  const bool newer = run_.state.step > checkpoint_step_ && before;
  std::string saved = newer ? write_checkpoint() : accepted_;
  run_.extremes = seen;
  std::ranges::copy(driven, run_.driven.saved().begin());
  return saved;
}

std::string Results::write_checkpoint() {
  watch_driven();
  const Recording recording = record();
  checkpoint_step_ = run_.state.step;
  io::CheckpointHeader header{static_cast<GlobalIndex>(run_.state.step), run_.state.time, run_.fingerprint,
                              run_.scene_values};
  // after a guard the file has rows of later steps
  const bool rows_known = history_ && static_cast<double>(history_->last_step()) < run_.state.step;
  header.program = version();
  header.history_rows = run_.links.ranks.max(rows_known ? history_->rows() : GlobalIndex{-1});
  const auto settle = [&](std::string path) {
    checkpoint_ = std::move(path);
    // the state of an implicit step was judged in that step, and one before t = 0 has no guards
    if (run_.implicit || run_.state.relaxation.under_way != 0) accept(checkpoint_step_);
    return checkpoint_;
  };
  if (run_.work.steps == 0) return settle(io::write_checkpoint(run_.links.ranks, folder_, header, run_.registry()));
  const io::RankWork work{run_.work.of_elements() / run_.work.steps, run_.work.of_contact() / run_.work.steps,
                          pairs_of_elements(run_.model, run_.contact.get())};
  return settle(io::write_checkpoint(run_.links.ranks, folder_, header, run_.registry(), &work));
}

void Results::seal() {
  const comm::Communicator& ranks = run_.links.ranks;
  hash_ = static_cast<std::uint64_t>(
      ranks.sum(static_cast<GlobalIndex>(model::hash_of_rank(run_.registry(), ranks.is_root()))));
  steps_ = run_.state.step;
  end_time_ = run_.state.time;
  if (run_.contact) contact_ = run_.contact->ledger.statistics;
}

void Results::write_summary(const std::string& stopped_by, int exit_code, double wall_seconds, const LoopCost& cost) {
  const comm::Communicator& ranks = run_.links.ranks;
  std::array<double, phases> seconds{};
  for (std::size_t p = 0; p < phases; ++p) seconds[p] = cost.timers.seconds(static_cast<Phase>(p));
  ranks.max(seconds);  // the slowest rank in each phase
  const double output = nth(seconds, Phase::output);
  const double loop = std::max(cost.seconds - output, 1e-12);
  const GlobalIndex removed = time::removed_elements(ranks, run_.state);
  double measured = 0;
  for (std::size_t p = 0; p < phases; ++p)
    if (p != static_cast<std::size_t>(Phase::output)) measured += seconds[p];
  const nlohmann::ordered_json parallel = parallel_summary(ranks, run_.model, {cost.passes, cost.sent, cost.timers});
  const nlohmann::ordered_json start_up = run_.start_up.report(ranks);
  if (!ranks.is_root()) return;

  const auto elements = static_cast<double>(run_.model.mesh.global_elements);
  const time::Ledger& e = last_ledger_;
  nlohmann::ordered_json summary;
  summary["version"] = version();
  summary["title"] = run_.input.title;
  summary["units"] = run_.input.units;
  summary["steps"] = static_cast<GlobalIndex>(steps_);
  summary["end_time"] = end_time_;
  summary["elements"] = run_.model.mesh.global_elements;
  summary["nodes"] = run_.model.mesh.global_nodes;
  summary["rigid_bodies"] = run_.model.bodies.size();
  summary["ranks"] = ranks.size();
  summary["wall_s"] = wall_seconds;
  summary["loop_s"] = cost.seconds;
  summary["start_up"] = start_up;
  summary["ns_per_element_step"] = cost.passes > 0 ? loop * 1e9 * ranks.size() / (elements * cost.passes) : 0.0;
  const char* names[phases] = {"element", "search", "enforcement", "halo", "other", "output"};
  const double scale = std::max(loop, measured);
  double booked = 0;
  for (std::size_t p = 0; p < phases; ++p) {
    if (p == static_cast<std::size_t>(Phase::output) || p == static_cast<std::size_t>(Phase::other)) continue;
    summary["share"][names[p]] = seconds[p] / scale;
    booked += seconds[p] / scale;
  }
  summary["share"]["other"] = 1.0 - booked;
  summary["parallel"] = parallel;
  summary["warnings"] = log_.warnings();
  summary["folded_elements"] = folded_;
  summary["removed_elements"] = removed;
  summary["relaxation"] = {{"steps", static_cast<GlobalIndex>(run_.state.relaxation.steps)},
                           {"residual", run_.model.relaxes ? run_.state.relaxation.residual : 0.0}};
  summary["energy"] = energy_summary(e, error_ratio(run_.extremes));
  summary["momentum_error"] = run_.extremes.momentum_error;
  summary["angular_momentum_error"] = angular_error(e, run_.extremes, extent_);
  summary["max_penetration"] = e.contact_totals.penetration;
  const contact::DeepNode& deepest = depth_.deepest();
  summary["deepest_penetration"] = {{"depth", deepest.depth}, {"elements", deepest.share}};
  summary["driven_penetration"] = run_.implicit ? implicit::driven_penetration(*run_.implicit) : run_.driven.largest();
  const auto solved = static_cast<double>(std::max<GlobalIndex>(contact_.solved_steps, 1));
  summary["contact"] = {{"searches", contact_.searches},
                        {"pairs", e.contact_totals.pairs},
                        {"active", e.contact_totals.active},
                        {"iterations_mean", static_cast<double>(contact_.iterations) / solved},
                        {"iterations_max", contact_.most_iterations},
                        {"residual_max", contact_.largest_residual},
                        {"steps", run_.implicit ? run_.implicit->work.contact_steps : contact_.solved_steps},
                        {"steps_at_limit", contact_.steps_at_limit},
                        {"steps_scaled", contact_.scaled_steps},
                        {"least_share", contact_.least_share}};
  if (run_.implicit) summary["implicit"] = implicit_summary(run_);
  summary["state_hash"] = model::hash_digits(hash_);
  summary["stopped_by"] = stopped_by;
  summary["exit_code"] = exit_code;
  io::write_summary(folder_, summary);
}

void Results::table_header() {
  const scene::UnitSystem& units = units_of(run_);
  log_.line(fmt::format("{:>8} {:>11} {:>10} {:>9} {:>11} {:>11} {:>11} {:>9} {:>7} {:>10} {:>8}", "step", "time", "dt",
                        "by elem", "kinetic", "internal", "total", "error", "active", "penetr.", "left"));
  log_.line(fmt::format("{:>8} {:>11} {:>10} {:>9} {:>11} {:>11} {:>11} {:>9} {:>7} {:>10} {:>8}", "", units.time,
                        units.time, "", units.energy, units.energy, units.energy, "", "", units.length, "h:mm:ss"));
}

void Results::table_line(const time::Ledger& ledger, const time::StepReport& step, const RecordTime& at,
                         double seconds_left) {
  const Recording recording = record();
  const std::string element = controlling_element(run_, step);
  log_.line(fmt::format("{:>8} {:>11.4e} {:>10.3e} {:>9} {:>11.4e} {:>11.4e} {:>11.4e} {:>9.1e} {:>7} {:>10.2e} {:>8}",
                        at.step, at.time, step.dt, element, ledger.kinetic, ledger.internal, ledger.total(),
                        energy_change(ledger, run_.extremes), ledger.contact_totals.active,
                        ledger.contact_totals.penetration, clock_text(seconds_left)));
}

}  // namespace brunt::app
