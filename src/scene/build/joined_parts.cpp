// SPDX-License-Identifier: Apache-2.0
// Several parts as one rigid body: parts that join another one, which names the body.
#include <fmt/format.h>

#include <algorithm>

#include "core/excerpt.hpp"
#include "scene/build/rigid_parts.hpp"

namespace brunt::scene {
namespace {

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
  if (rigid.mass || rigid.centre || rigid.inertia)
    fault(fmt::format(
        "invalid mass, centre or inertia: they belong to the whole body; expected these keys in parts.{}.rigid",
        excerpt(rigid.joins)));
}

}  // namespace

const std::string& lead_of(const Input& input, const std::string& part) {
  const Part* found = find_part(input, part);
  return found != nullptr && joins_another(*found) ? found->rigid->joins : part;
}

bool are_one_body(const Input& input, const std::string& a, const std::string& b) {
  return names_rigid_part(input, a) && names_rigid_part(input, b) && lead_of(input, a) == lead_of(input, b);
}

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

}  // namespace brunt::scene
