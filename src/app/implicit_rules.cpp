// SPDX-License-Identifier: Apache-2.0
#include "implicit_rules.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

#include "brunt/comm/linear_system.hpp"
#include "brunt/element/options.hpp"
#include "brunt/force/tangent.hpp"

namespace brunt::app {
namespace {

/// Keys of explicit scenes, and why they mean nothing here.
constexpr std::array<std::pair<const char*, const char*>, 7> explicit_keys{{
    {"run.cfl", "no stable step bounds an implicit scene; accepted: solver.step"},
    {"run.step_bound", "no stable step bounds an implicit scene; accepted: solver.step"},
    {"run.step", "the step of an implicit scene is the solver's; accepted: solver.step"},
    {"run.min_step_ratio", "the least step of an implicit scene is the solver's; accepted: solver.min_step"},
    {"enforcement", "contact of implicit scenes is not enforced by the rate constraint; accepted: no enforcement"},
    {"relaxation", "a static state is found directly; accepted: solver.scheme: static"},
    {"damping", "is for explicit scenes; accepted: solver.scheme: hht, which damps what the step does not resolve"},
}};

void check_part(const scene::Input& input, const model::ElementBlock& block, std::vector<std::string>& faults) {
  const std::string key = "parts." + block.part;
  if (material::is_rigid(block.law)) return;
  if (!force::gives_tangents(block.kind))
    faults.push_back(
        fmt::format("{}: {} has no stiffness against its hourglass modes; accepted in an implicit scene: hex8_full, "
                    "hex8_bbar, tet4",
                    input.at(key + ".element"), element::name_of(block.kind)));
  else if (!force::gives_tangents(block.law))
    faults.push_back(fmt::format("{}: {} has no tangent; accepted in an implicit scene: elastic, j2, neo_hookean",
                                 input.at(key + ".material"), block.material));
  if (block.erosion)
    faults.push_back(fmt::format("{}: is for explicit scenes; accepted: no erosion in an implicit scene",
                                 input.at(key + ".erosion")));
}

/// Rigid parts: what schemes, mortar contact and walls can do with them.
void check_bodies(const scene::Input& input, const model::Model& model, std::vector<std::string>& faults) {
  if (model.bodies.empty()) return;
  const auto rigid = [&](std::int32_t b) { return material::is_rigid(model.blocks[static_cast<std::size_t>(b)].law); };
  const auto part = [&](std::int32_t b) { return model.blocks[static_cast<std::size_t>(b)].part; };
  const model::Scheme scheme = input.implicit->scheme;
  if (scheme == model::Scheme::statics &&
      std::ranges::all_of(model.blocks, [](const model::ElementBlock& block) { return material::is_rigid(block.law); }))
    faults.push_back(
        fmt::format("{}: all parts are rigid, and nothing deforms; accepted: contact_implicit, or a part "
                    "that deforms",
                    input.at("solver.scheme")));
  if (scheme == model::Scheme::newmark || scheme == model::Scheme::hht)
    faults.push_back(
        fmt::format("{}: has no rotations of rigid parts; accepted with rigid parts: contact_implicit, static",
                    input.at("solver.scheme")));
  for (const contact::MortarPair& pair : model.mortar)
    if (rigid(pair.slave) && rigid(pair.master))
      faults.push_back(
          fmt::format("{}: {} and {} are both rigid, and mortar contact is of a part that deforms; accepted: between a "
                      "deformable part and another",
                      pair.entry, part(pair.slave), part(pair.master)));
    else if (rigid(pair.slave) && !pair.choose_slave)
      faults.push_back(fmt::format("{}: {} is rigid and cannot be the slave; accepted: slave: {}", pair.entry,
                                   part(pair.slave), part(pair.master)));
}

}  // namespace

std::vector<std::string> faults_of_implicit(const scene::Input& input, const model::Model& model) {
  std::vector<std::string> faults;
  if (!input.implicit) {
    for (std::size_t k = 0; k < input.contact.size(); ++k)
      if (input.contact[k].mortar)
        faults.push_back(
            fmt::format("{}: mortar contact is for implicit scenes; accepted in an explicit one: method: rate "
                        "(the default) and the others, or solver: implicit",
                        input.at(fmt::format("contact.{}.method", k))));
    return faults;
  }
  for (const auto& [key, why] : explicit_keys)
    if (input.places.has(key)) faults.push_back(fmt::format("{}: {}", input.at(key), why));
  for (const model::ElementBlock& block : model.blocks) check_part(input, block, faults);
  check_bodies(input, model, faults);
  if (!model.removals.empty())
    faults.push_back(fmt::format("{}: is for explicit scenes; accepted: no removals", input.at("remove")));
  for (std::size_t w = 0; w < model.walls.size(); ++w)
    if (const contact::FrictionLaw& law = model.walls[w].friction; law.kinetic != law.fixed || law.lag > 0)
      faults.push_back(fmt::format("{}: an implicit scene has one coefficient; accepted: a number, 0 or more",
                                   input.at(fmt::format("rigid_walls.{}.friction", w))));
  for (std::size_t k = 0; k < input.contact.size(); ++k)
    if (input.contact[k].mortar && !input.contact[k].tied &&
        input.contact[k].initial_overlap == contact::OverlapRule::offset)
      faults.push_back(fmt::format(
          "{}: offset is for explicit scenes as yet; accepted in an implicit scene: error, warn, move, place",
          input.at(fmt::format("contact.{}.initial_overlap", k))));
  for (std::size_t k = 0; k < input.contact.size(); ++k)
    if (!input.contact[k].mortar)
      faults.push_back(
          fmt::format("{}: an implicit scene has mortar contact alone; accepted: {{between: [a, b], method: "
                      "mortar}}",
                      input.at(fmt::format("contact.{}", k))));
  if (model.books_interface)
    faults.push_back(fmt::format(
        "{}: energies of parts that share nodes are for explicit scenes; accepted: other probes", input.at("probes")));
  return faults;
}

std::string likely_cause_in_implicit(Fault fault) {
  switch (fault) {
    case Fault::internal:
      return "likely cause: a hypoelastic law (elastic, j2) that is strained far and in turns, whose stresses have no "
             "potential. Take neo_hookean, or smaller elements";
    case Fault::friction:
      return "likely cause: sticking rows that take back what they stored while their facets turn; take a smaller "
             "solver.step, or smaller elements";
    case Fault::contact:
      return "likely cause: bodies that meet at more than a facet's depth in one step, or (but with contact_implicit) "
             "slide "
             "over coarse facets; take a smaller solver.step, or smaller elements";
    default:
      break;
  }
  return "likely cause: motions that the step does not resolve; take a smaller solver.step, or a smaller "
         "solver.tolerance where Newton's iteration leaves too much";
}

std::vector<std::string> notes_of_overlaps(const scene::Input& input) {
  std::vector<std::string> notes;
  if (!input.implicit) return notes;
  const bool keeps = input.implicit->scheme == model::Scheme::contact_implicit;
  for (std::size_t k = 0; k < input.contact.size(); ++k) {
    const scene::ContactEntry& entry = input.contact[k];
    if (!entry.mortar || entry.tied || entry.initial_overlap != contact::OverlapRule::warn) continue;
    const bool penalty = entry.enforce == contact::MortarPair::Enforce::penalty;
    notes.push_back(fmt::format(
        "{}: {}", input.at(fmt::format("contact.{}.initial_overlap", k)),
        penalty ? "an overlap of the start has the pressure of the penalty from the first step on"
        : keeps ? "an overlap of the start stays: contact_implicit recovers of it what contact has taken in energy, "
                  "which is nothing for bodies at rest"
                : "the first step closes an overlap of the start, which strains the bodies"));
  }
  return notes;
}

std::vector<std::string> warnings_of_implicit(const scene::Input& input, const model::Model& model) {
  std::vector<std::string> warnings;
  const GlobalIndex unknowns = 3 * model.mesh.global_nodes;
  if (input.implicit && input.implicit->linear == model::LinearSolver::direct &&
      unknowns > comm::LinearSystem::most_for_direct)
    warnings.push_back(
        fmt::format("{}: direct factorises {} unknowns on one rank, which may take minutes and tens of GB a time; "
                    "mumps uses all ranks (its results have not the same bits on other numbers of ranks)",
                    input.at("solver.linear"), unknowns));
  return warnings;
}

}  // namespace brunt::app
