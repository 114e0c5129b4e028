// SPDX-License-Identifier: Apache-2.0
// What explicit and implicit scenes may not have of each other.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

#include "scene/build/rigid_parts.hpp"
#include "scene/rules/rules.hpp"

namespace brunt::scene {
namespace {

/// Keys of explicit scenes, and their fault in an implicit one.
constexpr std::array<std::pair<const char*, const char*>, 8> explicit_keys{{
    {"search", "invalid in an implicit scene, whose facets are searched by trees; expected no search"},
    {"run.cfl", "invalid in an implicit scene, which has no stable step; expected solver.step"},
    {"run.step_bound", "invalid in an implicit scene, which has no stable step; expected solver.step"},
    {"run.step", "invalid in an implicit scene; expected solver.step"},
    {"run.min_step_ratio", "invalid in an implicit scene; expected solver.min_step"},
    {"enforcement", "invalid in an implicit scene, whose contact has no rate constraint; expected no enforcement"},
    {"relaxation", "invalid in an implicit scene; expected solver.scheme: static for a static solution"},
    {"damping", "invalid in an implicit scene; expected solver.scheme: hht, which damps the high frequencies"},
}};

using Lines = std::vector<std::string>;

Lines faults_of_explicit_contact(const Input& input) {
  Lines faults;
  for (std::size_t k = 0; k < input.contact.size(); ++k)
    if (input.contact[k].mortar)
      faults.push_back(
          fmt::format("{}: invalid method: mortar contact exists in implicit scenes only; expected method: rate (the "
                      "default) or another explicit one, or solver: implicit",
                      input.at(fmt::format("contact.{}.method", k))));
  return faults;
}

/// Limits of the schemes for rigid parts.
void judge_scheme(const Input& input, Lines& faults) {
  const auto rigid = [&](const Part& part) { return is_rigid(input, part); };
  if (input.parts.empty() || std::ranges::none_of(input.parts, rigid)) return;
  const model::Scheme scheme = input.implicit->scheme;
  if (scheme == model::Scheme::statics && std::ranges::all_of(input.parts, rigid))
    faults.push_back(fmt::format(
        "{}: invalid scheme: all parts are rigid, and nothing deforms; expected contact_implicit, or a deformable part",
        input.at("solver.scheme")));
  if (scheme == model::Scheme::newmark || scheme == model::Scheme::hht)
    faults.push_back(
        fmt::format("{}: invalid scheme for rigid parts: it cannot rotate them; expected contact_implicit or static",
                    input.at("solver.scheme")));
}

/// Erosion, removals, and friction of walls that changes.
void judge_bodies(const Input& input, Lines& faults) {
  for (const Part& part : input.parts)
    if (part.erosion)
      faults.push_back(fmt::format("{}: invalid in an implicit scene; expected no erosion",
                                   input.at(fmt::format("parts.{}.erosion", part.name))));
  if (!input.remove.empty())
    faults.push_back(fmt::format("{}: invalid in an implicit scene; expected no removals", input.at("remove")));
  for (std::size_t w = 0; w < input.rigid_walls.size(); ++w)
    if (const contact::FrictionLaw& law = input.rigid_walls[w].friction; law.kinetic != law.fixed || law.lag > 0)
      faults.push_back(fmt::format("{}: invalid friction of a wall in an implicit scene; expected one coefficient >= 0",
                                   input.at(fmt::format("rigid_walls.{}.friction", w))));
}

void judge_contact(const Input& input, Lines& faults) {
  for (std::size_t k = 0; k < input.contact.size(); ++k) {
    const ContactEntry& entry = input.contact[k];
    const std::string key = fmt::format("contact.{}", k);
    if (entry.mortar && !entry.tied && entry.initial_overlap == contact::OverlapRule::offset)
      faults.push_back(
          fmt::format("{}: invalid initial_overlap: offset in an implicit scene; expected error, warn, move or place",
                      input.at(key + ".initial_overlap")));
    if (entry.consistent && input.implicit->scheme != model::Scheme::statics)
      faults.push_back(
          fmt::format("{}: invalid without scheme: static; expected consistent: false", input.at(key + ".consistent")));
    if (!entry.mortar)
      faults.push_back(fmt::format(
          "{}: invalid contact in an implicit scene; expected {{between: [a, b], method: mortar}}, or [a, a]",
          input.at(key)));
  }
}

}  // namespace

std::vector<std::string> faults_of_solver(const Input& input) {
  if (!input.implicit) return faults_of_explicit_contact(input);
  Lines faults;
  for (const auto& [key, why] : explicit_keys)
    if (input.places.has(key)) faults.push_back(fmt::format("{}: {}", input.at(key), why));
  judge_scheme(input, faults);
  judge_bodies(input, faults);
  judge_contact(input, faults);
  return faults;
}

}  // namespace brunt::scene
