// SPDX-License-Identifier: Apache-2.0
#include "implicit_rules.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <variant>

#include "comm/linear_system.hpp"
#include "element/options.hpp"
#include "force/tangent.hpp"

namespace brunt::app {
namespace {

/// The kernels must have tangents.
void check_part(const scene::Input& input, const model::ElementBlock& block, std::vector<std::string>& faults) {
  const std::string key = "parts." + block.part;
  if (material::is_rigid(block.law)) return;
  if (!force::gives_tangents(block.kind))
    faults.push_back(
        fmt::format("{}: invalid element {}: it has no stiffness against hourglass modes; expected hex8_full, "
                    "hex8_bbar or tet4 in an implicit scene",
                    input.at(key + ".element"), element::name_of(block.kind)));
  else if (!force::gives_tangents(block.law))
    faults.push_back(fmt::format(
        "{}: invalid material {}: its law has no tangent; expected elastic, j2 or neo_hookean in an implicit scene",
        input.at(key + ".material"), block.material));
}

/// Pairs whose slave is rigid; the slave may follow from the mesh.
void check_pairs(const model::Model& model, std::vector<std::string>& faults) {
  const auto rigid = [&](std::int32_t b) { return material::is_rigid(nth(model.blocks, b).law); };
  const auto part = [&](std::int32_t b) { return nth(model.blocks, b).part; };
  for (const contact::MortarPair& pair : model.touching.mortar)
    if (rigid(pair.slave) && rigid(pair.master))
      faults.push_back(fmt::format(
          "{}: invalid pair: {} and {} are both rigid; expected at least one deformable part in mortar contact",
          pair.entry, part(pair.slave), part(pair.master)));
    else if (rigid(pair.slave) && !pair.choose_slave)
      faults.push_back(fmt::format("{}: invalid slave {}: it is rigid; expected slave: {}", pair.entry,
                                   part(pair.slave), part(pair.master)));
}

/// What contact of a static run gives comes from the form of its forces, not from the step.
std::string cause_of_given_in_statics(const model::Model& model) {
  if (std::ranges::any_of(model.touching.mortar,
                          [](const contact::MortarPair& pair) { return !pair.tied && !pair.consistent; }))
    return "likely cause: facets that slide over curved surfaces, where the forces of mortar contact are not the "
           "gradient of its gaps; shorter steps do not help: use consistent: true in contact, or smaller elements";
  return "likely cause: facets that come into contact, or leave it, at a gap that is not zero; use a smaller "
         "solver.step, or smaller elements";
}

}  // namespace

std::vector<std::string> faults_of_implicit(const scene::Input& input, const model::Model& model) {
  std::vector<std::string> faults;
  if (!input.implicit) return faults;
  for (const model::ElementBlock& block : model.blocks) check_part(input, block, faults);
  check_pairs(model, faults);
  if (model.between_parts.booked)
    faults.push_back(fmt::format(
        "{}: invalid probe of energy for parts that share nodes in an implicit scene; expected other probes",
        input.at("probes")));
  return faults;
}

std::string likely_cause_in_implicit(Fault fault, const model::Model& model, model::Scheme scheme) {
  switch (fault) {
    case Fault::internal:
      if (std::ranges::all_of(model.blocks, [](const model::ElementBlock& block) {
            return std::holds_alternative<material::NeoHookean>(block.law) || material::is_rigid(block.law);
          }))
        break;
      return "likely cause: large cyclic strains of a hypoelastic law (elastic, j2), whose stresses have no potential. "
             "Use neo_hookean, or smaller elements";
    case Fault::friction:
      return "likely cause: sticking nodes release stored energy while their facets rotate; use a smaller solver.step, "
             "or smaller elements";
    case Fault::contact:
    case Fault::returned:
      if (scheme == model::Scheme::statics) return cause_of_given_in_statics(model);
      return "likely cause: bodies that penetrate by more than the size of a facet in one step, or (except with "
             "contact_implicit) slide over coarse facets; use a smaller solver.step, or smaller elements";
    default:
      break;
  }
  return "likely cause: motions that the step does not resolve; use a smaller solver.step, or a smaller "
         "solver.tolerance where the residual of Newton's method is too large";
}

std::vector<std::string> notes_of_overlaps(const scene::Input& input) {
  std::vector<std::string> notes;
  if (!input.implicit) return notes;
  const bool keeps = input.implicit->scheme == model::Scheme::contact_implicit;
  for (std::size_t k = 0; k < input.contact.size(); ++k) {
    const scene::ContactEntry& entry = input.contact[k];
    if (!entry.mortar || entry.tied || entry.initial_overlap != contact::OverlapRule::warn) continue;
    const bool penalty = entry.enforce == contact::MortarPair::Enforce::penalty;
    notes.push_back(fmt::format("{}: {}", input.at(fmt::format("contact.{}.initial_overlap", k)),
                                penalty ? "the penalty pressure acts on an initial overlap from the first step on"
                                : keeps ? "an initial overlap remains: contact_implicit recovers only what contact has "
                                          "dissipated, which is zero for bodies at rest"
                                        : "the first step closes an initial overlap, which strains the bodies"));
  }
  return notes;
}

std::vector<std::string> warnings_of_implicit(const scene::Input& input, const model::Model& model) {
  std::vector<std::string> warnings;
  const GlobalIndex unknowns = 3 * model.mesh.global_nodes;
  if (input.implicit && input.implicit->linear == model::LinearSolver::direct &&
      unknowns > comm::LinearSystem::most_for_direct)
    warnings.push_back(
        fmt::format("{}: direct factorises {} unknowns on one rank, which may take minutes and tens of GB for each "
                    "factorisation; mumps uses all ranks (its results differ in rounding for other numbers of ranks)",
                    input.at("solver.linear"), unknowns));
  return warnings;
}

}  // namespace brunt::app
