// SPDX-License-Identifier: Apache-2.0
// Rigid parts: what their keys, supports, probes and methods may be.
#include <fmt/format.h>

#include <algorithm>

#include "core/excerpt.hpp"
#include "scene/build/rigid_parts.hpp"
#include "scene/reported.hpp"
#include "scene/rules/rules.hpp"

namespace brunt::scene {
namespace {

bool turns(const Fixed& entry) {
  return std::ranges::find(entry.turns, true) != entry.turns.end();
}

const Part* find_part(const Input& input, const std::string& name) {
  const auto part = std::ranges::find(input.parts, name, &Part::name);
  return part == input.parts.end() ? nullptr : &*part;
}

bool joins_another(const Part& part) {
  return part.rigid && !part.rigid->joins.empty();
}

void check_join(const Input& input, const Part& part, std::vector<std::string>& faults) {
  const RigidGiven& rigid = *part.rigid;
  const std::string key = "parts." + part.name + ".rigid";
  const auto fault = [&](const std::string& what) { faults.push_back(fmt::format("{}: {}", input.at(key), what)); };
  const Part* lead = find_part(input, rigid.joins);
  if (lead == nullptr) return;  // reported when names are resolved
  if (lead == &part)
    fault("invalid joins: the part refers to itself; expected the name of another rigid part");
  else if (!is_rigid(input, *lead))
    fault(fmt::format("invalid joins: part '{}' is not rigid; expected a part whose material has model: rigid",
                      excerpt(lead->name)));
  else if (joins_another(*lead))
    fault(fmt::format("invalid joins: part '{}' itself joins '{}'; expected joins: {}", excerpt(lead->name),
                      excerpt(lead->rigid->joins), excerpt(lead->rigid->joins)));
  if (rigid.mass || rigid.centre || rigid.inertia || rigid.reference)
    fault(
        fmt::format("invalid mass, centre, inertia or reference: they belong to the whole body; expected these keys in "
                    "parts.{}.rigid",
                    excerpt(rigid.joins)));
}

/// Parts that join others, and keys of a joined part that belong to its body.
void check_joins(const Input& input, std::vector<std::string>& faults) {
  for (const Part& part : input.parts)
    if (joins_another(part) && is_rigid(input, part)) check_join(input, part, faults);
  const auto of_the_body = [&](const std::string& key, const std::string& where) {
    if (const std::string& lead = lead_of(input, where); lead != where)
      faults.push_back(fmt::format("{}: invalid part '{}': it is one rigid body with '{}'; expected part: {}",
                                   input.at(key), excerpt(where), excerpt(lead), excerpt(lead)));
  };
  for (std::size_t k = 0; k < input.initial.size(); ++k)
    of_the_body(fmt::format("initial.{}", k), input.initial[k].where);
  for (std::size_t k = 0; k < input.fixed.size(); ++k) of_the_body(fmt::format("fixed.{}", k), input.fixed[k].where);
  for (std::size_t k = 0; k < input.prescribed.size(); ++k)
    of_the_body(fmt::format("prescribed.{}", k), input.prescribed[k].where);
  for (std::size_t k = 0; k < input.probes.size(); ++k)
    if (input.probes[k].kind == Probe::Kind::part) of_the_body(fmt::format("probes.{}", k), input.probes[k].where);
  for (std::size_t k = 0; k < input.contact.size(); ++k) {
    const auto& pair = input.contact[k].between;
    if (pair.size() == 2 && pair[0] != pair[1] && are_one_body(input, pair[0], pair[1]))
      faults.push_back(
          fmt::format("{}: invalid pair: '{}' and '{}' are one rigid body, which has no contact with itself; expected "
                      "parts of two bodies",
                      input.at(fmt::format("contact.{}", k)), excerpt(pair[0]), excerpt(pair[1])));
  }
}

/// The degrees of freedom that entries of one list give to a part, as in `dofs`.
std::string dof_name(int dof) {
  return fmt::format("{}{}", dof < 3 ? "" : "r", "xyz"[dof % 3]);
}

/// Probes of fields that only rigid bodies have, and of sections, which they do not have.
void check_probes(const Input& input, std::vector<std::string>& faults) {
  for (std::size_t k = 0; k < input.probes.size(); ++k) {
    const Probe& probe = input.probes[k];
    const bool of_body = probe.field == "force" || probe.field == "moment";
    if (of_body && probe.kind != Probe::Kind::joint && !names_rigid_part(input, probe.where))
      faults.push_back(
          reported(input, fmt::format("probes.{}.field", k),
                   "invalid field '{}': it exists for rigid parts only, and '{}' is deformable; expected displacement, "
                   "velocity, position, rotation, angular_velocity, reaction, reaction_moment, mass, center, momentum, "
                   "angular_momentum or energy",
                   probe.field, excerpt(probe.where)));
    for (const std::string& part : probe.parts)
      if (names_rigid_part(input, part))
        faults.push_back(reported(input, fmt::format("probes.{}.section", k),
                                  "invalid part '{}': a rigid part has no internal forces; expected a deformable part",
                                  excerpt(part)));
  }
}

/// A degree of freedom that is driven twice, or driven and fixed.
void refuse_two_supports(const Input& input, std::vector<std::string>& faults) {
  for (std::size_t k = 0; k < input.prescribed.size(); ++k) {
    const Prescribed& entry = input.prescribed[k];
    if (!names_rigid_part(input, entry.where)) continue;
    const auto clash = [&](const char* list, std::size_t other) {
      faults.push_back(reported(
          input, fmt::format("prescribed.{}", k),
          "invalid motion: {} of '{}' is also constrained by {}.{}; expected one entry for each degree of freedom",
          dof_name(entry.dof), excerpt(entry.where), list, other));
    };
    for (std::size_t other = 0; other < k; ++other)
      if (input.prescribed[other].where == entry.where && input.prescribed[other].dof == entry.dof)
        clash("prescribed", other);
    for (std::size_t other = 0; other < input.fixed.size(); ++other) {
      const Fixed& fixed = input.fixed[other];
      const auto c = static_cast<std::size_t>(entry.dof % 3);
      if (fixed.where == entry.where && (entry.dof < 3 ? fixed.dofs[c] : fixed.turns[c])) clash("fixed", other);
    }
  }
}

}  // namespace

std::vector<std::string> faults_of_rigid_parts(const Input& input) {
  std::vector<std::string> faults;
  for (const Part& part : input.parts)
    if (part.rigid && !is_rigid(input, part))
      faults.push_back(reported(input, fmt::format("parts.{}.rigid", part.name),
                                "invalid material '{}': it is not rigid; expected a material of model: rigid",
                                excerpt(part.material)));
  const bool any_shell = std::ranges::any_of(input.parts, is_shell);  // else its nodes are judged when they are known
  const auto rotation_of_nodes = [&](const std::string& key) {
    if (any_shell) return;
    faults.push_back(reported(input, key,
                              "invalid rotation rx, ry or rz of nodes without shells; expected part: a rigid part, "
                              "nodes of shells, or x, y, z"));
  };
  for (std::size_t k = 0; k < input.fixed.size(); ++k)
    if (turns(input.fixed[k]) && !names_rigid_part(input, input.fixed[k].where))
      rotation_of_nodes(fmt::format("fixed.{}.dofs", k));
  for (std::size_t k = 0; k < input.prescribed.size(); ++k)
    if (input.prescribed[k].dof >= 3 && !names_rigid_part(input, input.prescribed[k].where))
      rotation_of_nodes(fmt::format("prescribed.{}.dof", k));
  refuse_two_supports(input, faults);
  check_probes(input, faults);
  check_joins(input, faults);
  const contact::Method method = input.enforcement.settings.method;
  const bool holds_bodies = method == contact::Method::rate || method == contact::Method::row_sum;
  const auto rigid = [&](const Part& part) { return is_rigid(input, part); };
  if (!input.parts.empty() && !input.implicit && std::ranges::all_of(input.parts, rigid) && !input.run.step)
    faults.push_back(reported(input, "run",
                              "missing step: all parts are rigid, and no element limits the step; expected step: a "
                              "time > 0 during which bodies rotate by a few hundredths of a radian"));
  if (!input.contact.empty() && !holds_bodies && std::ranges::any_of(input.parts, rigid))
    faults.push_back(reported(input, "enforcement.method", "invalid method for rigid parts; expected rate or row_sum"));
  if (input.relaxation && std::ranges::all_of(input.parts, rigid))
    faults.push_back(reported(input, "relaxation",
                              "invalid relaxation: all parts are rigid; expected at least one deformable part"));
  return faults;
}

}  // namespace brunt::scene
