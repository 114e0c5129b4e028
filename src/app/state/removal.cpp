// SPDX-License-Identifier: Apache-2.0
#include "removal.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "contact_setup.hpp"
#include "core/error.hpp"
#include "scene/build/build.hpp"
#include "time/erosion.hpp"
#include "time/removal.hpp"
#include "time/step.hpp"

namespace brunt::app {
namespace {

std::string reasons(const time::ErosionCount& count) {
  std::string text;
  const auto add = [&](GlobalIndex elements, const char* by) {
    if (elements > 0) text += fmt::format("{}{} by {}", text.empty() ? "" : ", ", elements, by);
  };
  add(count.damage, "damage");
  add(count.plastic_strain, "plastic strain");
  add(count.pressure, "pressure");
  add(count.volume, "volume");
  add(count.step, "step");
  return text;
}

std::string reported(const Prepared& run, const std::vector<GlobalIndex>& lost) {
  std::string parts;
  for (std::size_t b = 0; b < lost.size(); ++b)
    if (lost[b] > 0)
      parts += fmt::format("{}{} element{} of {}", parts.empty() ? "" : ", ", lost[b], lost[b] == 1 ? "" : "s",
                           run.model.blocks[b].part);
  return parts;
}

/// Elements that meet a criterion leave; true if any did. The first of each part is told, the rest are counted.
bool erode(Prepared& run, Log& log) {
  ErosionAccount& account = run.erosion;
  if (!time::erode(run.links.ranks, run.model, run.state, run.scratch, account.now)) return false;
  for (std::size_t b = 0; b < account.now.size(); ++b) {
    if (account.now[b].all() == 0) continue;
    if (account.counts[b].all() == 0)
      log.line(fmt::format("erosion of {} begins at t = {:g}, step {}: {}", run.model.blocks[b].part, run.state.time,
                           static_cast<GlobalIndex>(run.state.step), reasons(account.now[b])));
    account.counts[b] += account.now[b];
  }
  ++account.steps;
  return true;
}

/// What becomes of nodes without an element, on all ranks.
std::string reported_of_nodes(const Prepared& run) {
  const surface::BareNodes bare = surface::bare_nodes(run.links.ranks, run.model.mesh, run.state.alive);
  std::array<GlobalIndex, 2> count{};
  for (const LocalIndex node : bare.kept) count[0] += std::ranges::binary_search(run.model.owned, node) ? 1 : 0;
  for (const LocalIndex node : bare.dropped) count[1] += std::ranges::binary_search(run.model.owned, node) ? 1 : 0;
  run.links.ranks.sum(count);
  std::string text;
  if (count[0] > 0) text = fmt::format("; mass points now: {}", count[0]);
  if (count[1] > 0) text += fmt::format("; nodes dropped: {}", count[1]);
  return text;
}

}  // namespace

void expose(const scene::Input& input, const model::Model& model, const model::State& state, const time::Links& links,
            contact::Contact& contact) {
  contact::Remains remains{
      surface::exposed_surface(links.ranks, model.mesh, links.inner_faces, state.alive), {}, state.alive};
  remains.excluded = scene::in_symmetry_plane(input, model.mesh, remains.outside.faces);
  contact::update_surface(contact, model.mesh, remains, inverse_masses(state), model.supports.nodes);
}

void demand_first_step(Prepared& run) {
  if (!run.erosion.any) return;
  const time::StepReport step = time::evaluate(run.model, run.state, run.scratch, run.links, step_control(run));
  if (std::isfinite(step.dt)) return;
  const auto part = std::ranges::find_if(run.input.parts, [](const scene::Part& p) { return p.erosion.has_value(); });
  throw InputError(run.input.at(fmt::format("parts.{}.erosion", part->name)) +
                   ": invalid criteria: every element that could determine the step meets one at the start; expected "
                   "criteria that are not met at the start, or run.step");
}

void remove_due(Prepared& run, Log& log) {
  const time::Links& links = run.links;
  const bool due = time::removal_is_due(run.model, run.state);
  if (!due && !run.erosion.any) return;
  std::vector<GlobalIndex> lost(run.model.blocks.size(), 0);
  if (due) lost = time::remove_elements(links.ranks, run.model, run.state);
  const bool removed = std::ranges::any_of(lost, [](GlobalIndex count) { return count > 0; });
  const bool eroded = run.erosion.any && erode(run, log);
  if (!removed && !eroded) return;  // all were gone before
  time::outdate(run.assembled);
  run.links.flow.planned = false;
  if (run.contact) {
    const auto timed = run.links.timers.measure(Phase::search);
    expose(run.input, run.model, run.state, links, *run.contact);
    run.contact->births_due = true;
  }
  if (removed)
    log.line(fmt::format("removed at t = {:g}, step {}: {}{}", run.state.time, static_cast<GlobalIndex>(run.state.step),
                         reported(run, lost), reported_of_nodes(run)));
}

void report_erosion(const Prepared& run, Log& log) {
  for (std::size_t b = 0; b < run.erosion.counts.size(); ++b)
    if (const time::ErosionCount& count = run.erosion.counts[b]; count.all() > 0)
      log.line(
          fmt::format("eroded of {} in {} steps: {}", run.model.blocks[b].part, run.erosion.steps, reasons(count)));
}

void follow_alive(Prepared& run) {
  if (run.state.alive.empty()) return;
  time::follow_alive(run.links.ranks, run.model, run.state);
  if (run.contact) expose(run.input, run.model, run.state, run.links, *run.contact);
}

}  // namespace brunt::app
