// SPDX-License-Identifier: Apache-2.0
// Converts the entries of `contact`, which name parts and may override each other, to a setting for each pair of
// blocks.
#include <fmt/core.h>

#include <algorithm>

#include "scene/build/build.hpp"
#include "scene/build/rigid_parts.hpp"

namespace brunt::scene {
namespace {

bool names_pair(const ContactEntry& entry, const std::string& a, const std::string& b) {
  return entry.between.empty() || (entry.between[0] == a && entry.between[1] == b);
}

bool excludes(const ContactEntry& entry, const std::string& a, const std::string& b) {
  return std::ranges::any_of(entry.exclude, [&](const std::array<std::string, 2>& pair) {
    return (pair[0] == a && pair[1] == b) || (pair[0] == b && pair[1] == a);
  });
}

/// Entries with `all` leave tied parts tied; an entry that releases the tie must name both parts.
bool leaves_tied(const ContactEntry& entry, bool tied) {
  return tied && entry.between.empty();
}

/// The rule for a pair with contact by an entry.
contact::PairRule rule_of(const ContactEntry& entry, bool straight) {
  using contact::PairRule;
  if (entry.slave == ContactEntry::Slave::automatic || entry.between.empty()) return PairRule::automatic;
  return (entry.slave == ContactEntry::Slave::first) == straight ? PairRule::slave : PairRule::master;
}

/// Self-contact is part of `all` unless the entry excludes it; a rigid part cannot fold.
bool never_meets_itself(const Input& input, const ContactEntry& entry, const std::string& part) {
  return (entry.between.empty() && !entry.self) || names_rigid_part(input, part);
}

bool erodes(const Input& input, const std::string& part) {
  return std::ranges::any_of(input.parts, [&](const Part& p) { return p.name == part && p.erosion.has_value(); });
}

/// An eroding part exposes other faces than the initial ones, from whose sizes a slave would be chosen.
contact::Passes passes_of(const Input& input, const ContactEntry& entry, const std::string& a, const std::string& b) {
  using contact::Passes;
  if (entry.tied) return Passes::one;
  if (entry.passes != Passes::automatic) return entry.passes;
  if (entry.friction.lag > 0) return Passes::one;
  const bool chosen = !entry.between.empty() && entry.slave != ContactEntry::Slave::automatic;
  return !chosen && (erodes(input, a) || erodes(input, b)) ? Passes::two : Passes::automatic;
}

/// The setting of an entry for two blocks (one twice, or two) of parts a and b; whether the entry applies.
bool apply(const Input& input, const ContactEntry& entry, const std::string& a, const std::string& b, bool itself,
           contact::PairSpecification& pair) {
  using contact::Tied;
  const bool straight = names_pair(entry, a, b);
  if (!straight && !names_pair(entry, b, a)) return false;
  if (are_one_body(input, a, b) && !itself) {
    pair.rule = contact::PairRule::apart;
    return true;
  }
  pair.friction = entry.friction;
  if (leaves_tied(entry, pair.tied != Tied::no)) {
    if (excludes(entry, a, b)) pair.tied = Tied::alone;
    return true;
  }
  pair.tied = entry.tied ? Tied::yes : Tied::no;
  pair.passes = passes_of(input, entry, a, b);
  const bool apart = excludes(entry, a, b) || (itself && never_meets_itself(input, entry, a));
  pair.rule = apart ? contact::PairRule::apart : rule_of(entry, straight);
  return true;
}

}  // namespace

contact::Specification contact_specification(const Input& input, std::span<const std::string> part_of_block) {
  const auto n = static_cast<std::int32_t>(part_of_block.size());
  contact::Specification specification;
  specification.pairs = contact::PairTable(part_of_block.size(), {});
  specification.enforcement = input.enforcement.settings;
  specification.criterion = input.enforcement.competing;
  specification.rebuild = input.enforcement.rebuild;
  for (const ContactEntry& entry : input.contact)
    for (std::int32_t a = 0; a < n && !entry.mortar; ++a)
      for (std::int32_t b = a; b < n; ++b) {
        const std::string &first = nth(part_of_block, a), &second = nth(part_of_block, b);
        contact::PairSpecification pair = specification.pairs.at(a, b);
        if (apply(input, entry, first, second, a == b, pair)) specification.pairs.set(a, b, pair);
      }
  return specification;
}

std::optional<std::size_t> deciding_entry(const Input& input, const std::string& a, const std::string& b) {
  std::optional<std::size_t> deciding;
  bool tied = false;
  for (std::size_t k = 0; k < input.contact.size(); ++k) {
    const ContactEntry& entry = input.contact[k];
    if ((!names_pair(entry, a, b) && !names_pair(entry, b, a)) || leaves_tied(entry, tied)) continue;
    tied = entry.tied;
    const bool itself = a == b ? never_meets_itself(input, entry, a) : are_one_body(input, a, b);
    deciding = itself || excludes(entry, a, b) ? std::nullopt : std::optional(k);
  }
  return deciding;
}

std::optional<contact::OverlapRule> overlap_rule(const Input& input, const std::string& a, const std::string& b) {
  const std::optional<std::size_t> entry = deciding_entry(input, a, b);
  return entry ? std::optional(input.contact[*entry].initial_overlap) : std::nullopt;
}

std::string contact_key(const Input& input, const std::string& a, const std::string& b) {
  const std::optional<std::size_t> entry = deciding_entry(input, a, b);
  return entry ? fmt::format("contact.{}", *entry) : "contact";
}

}  // namespace brunt::scene
