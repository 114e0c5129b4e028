// SPDX-License-Identifier: Apache-2.0
#include "driven_apart.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "app/state/driven_words.hpp"
#include "app/state/prepared.hpp"
#include "core/error.hpp"
#include "implicit/driven_apart.hpp"
#include "scene/build/select.hpp"
#include "scene/text/units.hpp"

namespace brunt::app {
namespace {

/// The entries of supports that hold the node along a direction, in the order of `fixed`, `symmetry`, `prescribed`.
GlobalIndex support_at(const Prepared& run, GlobalIndex gid, const Vec3& direction) {
  const model::Model& model = run.model;
  const scene::Input& input = run.input;
  const auto here = std::ranges::find(model.mesh.node_gid, gid);
  if (here == model.mesh.node_gid.end()) return -1;
  const auto node = static_cast<LocalIndex>(here - model.mesh.node_gid.begin());
  GlobalIndex entry = -1, found = -1;
  const auto look = [&](const char* kind, std::size_t k, bool holds) {
    ++entry;
    if (holds && std::ranges::binary_search(model.mesh.node_sets.at(scene::selection_name(kind, k)), node))
      found = entry;
  };
  constexpr double along = 1e-3;  // least part of a direction that makes a support worth naming
  for (std::size_t k = 0; k < input.fixed.size(); ++k) {
    bool holds = false;
    for (int c = 0; c < 3; ++c) holds = holds || (nth(input.fixed[k].dofs, c) && std::abs(direction[c]) > along);
    look("fixed", k, holds);
  }
  for (std::size_t k = 0; k < input.symmetry.size(); ++k)
    look("symmetry", k, std::abs(input.symmetry[k].normal.normalized().dot(direction)) > along);
  for (std::size_t k = 0; k < input.prescribed.size(); ++k)
    look("prescribed", k, std::abs(direction[input.prescribed[k].dof % 3]) > along);
  return found;
}

/// The same on all ranks. Collective.
std::string name_of_support(const Prepared& run, GlobalIndex gid, const Vec3& direction) {
  const auto found = static_cast<std::size_t>(run.links.ranks.max(support_at(run, gid, direction)) + 1);
  const std::size_t fixed = run.input.fixed.size(), symmetry = run.input.symmetry.size();
  if (found == 0) return run.model.touching.walls.empty() ? "other ties" : "a rigid wall or other ties";
  if (found <= fixed) return fmt::format("fixed.{}", found - 1);
  if (found <= fixed + symmetry) return fmt::format("symmetry.{}", found - 1 - fixed);
  return fmt::format("prescribed.{}", found - 1 - fixed - symmetry);
}

std::string text_of(const Prepared& run, const implicit::DrivenApart& found, double time) {
  const contact::MortarPair& pair = run.implicit->contact.interfaces[found.interface].pair;
  const auto part = [&](std::int32_t block) -> const std::string& { return nth(run.model.blocks, block).part; };
  const Vec3 direction = found.apart.normalized(), place = found.place + run.model.mesh.origin;
  return fmt::format(
      "{}: invalid tie: at [{:g}, {:g}, {:g}] part '{}', moved by {}, and part '{}', moved by {}, are separated by {} "
      "at t = {:g}, and the tie cannot hold there",
      pair.entry, place[0], place[1], place[2], part(pair.slave), name_of_support(run, found.slave, direction),
      part(pair.master), name_of_support(run, found.master, direction),
      scene::with_length(found.apart.norm(), run.input.units, 3), time);
}

}  // namespace

void refuse_driven_apart(Prepared& run) {
  if (!run.implicit || !run.input.run.end || run.input.run.steps) return;
  const implicit::MortarContact& contact = run.implicit->contact;
  if (std::ranges::none_of(contact.interfaces, [](const implicit::Interface& face) { return face.pair.tied; })) return;
  for (const double time : implicit::turning_times(run.model, *run.input.run.end))
    if (const auto found = implicit::driven_apart_at(run.links.ranks, run.model, time, contact))
      throw InputError(text_of(run, *found, time) + "; expected the same motion on both sides");
}

void stop_where_driven_apart(Prepared& run) {
  if (const auto found = implicit::driven_apart(run.links.ranks, run.implicit->contact))
    throw GuardError(text_of(run, *found, run.state.time));
}

std::vector<std::string> watch_driven_through(Prepared& run) {
  const scene::UnitSystem& units = *scene::find_unit_system(run.input.units);
  std::vector<std::string> warnings;
  for (const implicit::DrivenThrough& pair : implicit::watch_driven(implicit_scene(run), *run.implicit))
    warnings.push_back(
        driven_through(run.model, pair.block, pair.other, pair.since, pair.depth, units.metre > 0 ? units.length : ""));
  return warnings;
}

}  // namespace brunt::app
