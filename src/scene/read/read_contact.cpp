// SPDX-License-Identifier: Apache-2.0
// Contact between parts.
#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "core/excerpt.hpp"
#include "read_enforcement.hpp"
#include "scene/read/sections.hpp"

namespace brunt::scene {
namespace {

using Overlap = contact::OverlapRule;
using Slave = ContactEntry::Slave;

/// Two parts, or one given twice: self-contact.
bool read_pair(const Key& key, std::array<std::string, 2>& pair, std::string_view expected) {
  const std::vector<Key> names = items(key, expected, 2);
  return names.size() == 2 && read(names[0], pair[0], Named::part) && read(names[1], pair[1], Named::part);
}

void read_between(Section& entry, ContactEntry& contact) {
  constexpr std::string_view expected = "all, or two parts [a, b]";
  const Key key = entry.at("between");
  const bool word = key.tree == nullptr || key.tree->kind != Tree::Kind::list;
  if (word) {
    static const Choices<bool> choices{{{"all", true}}, {}};
    bool all = true;
    if (key.tree == nullptr || key.tree->kind != Tree::Kind::value) {
      wrong(key, expected);
    } else {
      read(key, all, choices);
    }
    return;
  }
  std::array<std::string, 2> pair;
  if (read_pair(key, pair, expected)) contact.between = {pair[0], pair[1]};
}

void read_exclude(const Key& key, ContactEntry& contact) {
  for (const Key& entry : items(key, "a list of pairs of parts [[a, b], ...]")) {
    std::array<std::string, 2> pair;
    if (read_pair(entry, pair, "a pair of parts [a, b]")) contact.exclude.push_back(pair);
  }
}

void read_slave(const Key& key, ContactEntry& contact) {
  const std::vector<std::string>& parts = contact.between;
  if (parts.empty() && key.tree->kind == Tree::Kind::value && key.tree->text != "auto")
    return fault(key,
                 fmt::format("invalid slave '{}' for between: all; expected auto, or an entry with between: [a, b]",
                             excerpt(key.tree->text)));
  std::vector<std::string> words{"auto", "first", "second"};
  for (const std::string& part : parts)
    if (words.size() == 3 || part != words.back()) words.push_back(part);
  const std::size_t chosen = read_choice(key, words, {});
  if (chosen == words.size() || chosen == 0) return;
  contact.slave = chosen % 2 == 1 ? Slave::first : Slave::second;
}

/// Keys of which only one value exists in this version.
void read_settled(Section& entry) {
  if (entry.has("thickness") && entry.at("thickness").tree->text != "auto") {
    later(entry.at("thickness"), "a thickness of contact", "auto");
  }
}

/// Warns of settings without effect.
void judge_passes(Section& entry, const ContactEntry& contact, Input& input) {
  if (entry.has("self") && !contact.between.empty())
    warn(entry.at("self"), "no effect with two parts; a part meets itself by between: all, or [a, a]", input);
  const bool two = contact.passes == contact::Passes::two || contact.passes == contact::Passes::averaged;
  if (two && contact.slave != Slave::automatic && entry.has("slave"))
    warn(entry.at("slave"), "no effect with two passes", input);
  if (two && contact.friction.lag > 0)
    fault(entry.has("passes") ? entry.at("passes") : entry.at("friction"),
          "invalid lag of friction with two passes; expected passes: auto or one");
  if (contact.tied && entry.has("passes") && two)
    warn(entry.at("passes"), "no effect with tied: true: a tie has one pass", input);
}

/// Faults of combinations that the present method does not support.
void judge_method(const Key& whole, const ContactEntry& contact, const Input& input) {
  using contact::Method;
  const Method method = input.enforcement.settings.method;
  const bool ties = contact.tied || std::ranges::any_of(input.contact, &ContactEntry::tied);
  if (ties && method != Method::rate && method != Method::row_sum)
    fault(whole, "invalid tied: the enforcement method has no ties; expected method: rate or row_sum");
  if (method != Method::reference) return;
  const bool rubs = contact.friction.any() ||
                    std::ranges::any_of(input.contact, [](const ContactEntry& e) { return e.friction.any(); }) ||
                    std::ranges::any_of(input.rigid_walls, [](const RigidWall& wall) { return wall.friction.any(); });
  if (rubs) fault(whole, "invalid method: reference has no friction; expected friction: 0, on rigid walls as well");
}

void judge_tied(Section& entry, const ContactEntry& contact) {
  const Key key = entry.at("tied");
  const bool all = entry.has("between") && entry.at("between").tree->kind == Tree::Kind::value;
  if (all) fault(key, "invalid tied for between: all; expected tied: true with between: [a, b]");
  if (!contact.between.empty() && contact.between[0] == contact.between[1])
    fault(key, "invalid tied: a part cannot be tied to itself; expected between: [a, b] with two parts");
  if (contact.friction.any()) fault(key, "invalid friction of tied parts; expected no friction with tied: true");
}

/// A later entry that names two tied parts releases their tie; a warning asks for an explicit statement.
void judge_untied(const Key& whole, Section& entry, const ContactEntry& contact, Input& input) {
  if (contact.tied || contact.between.empty() || entry.has("tied")) return;
  const std::set<std::string> pair(contact.between.begin(), contact.between.end());
  const auto names_it = [&](const ContactEntry& earlier) {
    return pair == std::set<std::string>(earlier.between.begin(), earlier.between.end());
  };
  const auto last = std::ranges::find_if(input.contact.rbegin(), input.contact.rend(), names_it);
  if (last == input.contact.rend() || !last->tied) return;
  warn(whole,
       fmt::format(
           "this entry releases the tie of {} and {} defined by contact.{}; tied: false does so without this warning",
           contact.between[0], contact.between[1], input.contact.rend() - last - 1),
       input);
}

/// method: mortar and its keys. For other methods, the keys of enforcement are read.
void read_mortar(Section& entry, ContactEntry& contact) {
  const bool named = entry.has("method") && entry.at("method").tree->kind == Tree::Kind::value;
  contact.mortar = named && entry.at("method").tree->text == "mortar";
  if (!contact.mortar) {
    for (const char* key : {"multiplier", "enforce", "consistent", "edges"})
      if (entry.has(key)) fault(entry.at(key), "invalid without method: mortar; expected no such key");
    return;
  }
  using contact::Multiplier;
  using Enforce = contact::MortarPair::Enforce;
  static const Choices<Multiplier> multipliers{{{"dual", Multiplier::dual}, {"standard", Multiplier::standard}}, {}};
  static const Choices<Enforce> enforces{{{"lagrange", Enforce::lagrange}, {"penalty", Enforce::penalty}}, {}};
  entry.optional("multiplier", contact.multiplier, multipliers);
  entry.optional("enforce", contact.enforce, enforces);
  entry.optional("consistent", contact.consistent);
  entry.optional("edges", contact.edges);
  const auto refuse = [&](bool wrong, const char* key, const char* why) {
    if (wrong) fault(entry.at(key), why);
  };
  const bool itself = contact.between.size() == 2 && contact.between[0] == contact.between[1];
  const bool all =
      entry.has("between") && entry.at("between").tree != nullptr && entry.at("between").tree->text == "all";
  if (all && !contact.tied)  // conflicts with ties are reported elsewhere
    fault(entry.at("between"), "invalid between for method: mortar; expected two parts [a, b], or one twice [a, a]");
  refuse(itself && contact.slave != Slave::automatic, "slave",
         "invalid for a part with itself, whose facets are slaves and masters by turns; expected no such key");
  refuse(itself && contact.initial_overlap != Overlap::error && entry.has("initial_overlap"), "initial_overlap",
         "invalid for method: mortar of a part with itself; expected error");
  refuse(itself && entry.has("edges"), "edges", "invalid for a part with itself; expected no such key");
  refuse(entry.has("exclude"), "exclude", "invalid with method: mortar; expected this key with between: all only");
  refuse(contact.friction.kinetic != contact.friction.fixed || contact.friction.lag > 0, "friction",
         "invalid friction for method: mortar, which has Coulomb's law with one coefficient; expected a number >= 0");
  refuse(contact.tied && contact.enforce == Enforce::penalty, "enforce",
         "invalid enforcement of a tie; expected lagrange");
  refuse(contact.tied && entry.has("consistent"), "consistent",
         "invalid with tied: true, whose forces are consistent; expected no such key");
  refuse(contact.tied && entry.has("edges"), "edges",
         "invalid with tied: true, which holds what meets at the start; expected no such key");
  for (const char* key : {"passes", "tolerance", "max_iterations", "softness", "partition", "stiffness", "damping",
                          "competing", "rebuild"})
    refuse(entry.has(key), key,
           "invalid with method: mortar; expected multiplier, enforce, slave, consistent, edges, friction or tied");
}

ContactEntry read_entry(Section& entry, contact::Passes passes_before) {
  static const Choices<Overlap> overlaps{{{"error", Overlap::error},
                                          {"warn", Overlap::warn},
                                          {"move", Overlap::move},
                                          {"place", Overlap::place},
                                          {"offset", Overlap::offset}},
                                         {}};
  using contact::Passes;
  static const Choices<Passes> passes{
      {{"auto", Passes::automatic}, {"one", Passes::one}, {"two", Passes::two}, {"averaged", Passes::averaged}}, {}};
  ContactEntry contact;
  contact.passes = passes_before;
  read_between(entry, contact);
  if (entry.has("exclude")) read_exclude(entry.at("exclude"), contact);
  read_friction(entry, contact.friction);
  if (entry.has("slave")) read_slave(entry.at("slave"), contact);
  entry.optional("passes", contact.passes, passes);
  entry.optional("self", contact.self);
  if (entry.optional("tied", contact.tied) && contact.tied) {
    judge_tied(entry, contact);
    contact.initial_overlap = Overlap::offset;  // ties keep nodes at their positions
  }
  entry.optional("initial_overlap", contact.initial_overlap, overlaps);
  if (contact.tied && contact.initial_overlap == Overlap::place)
    fault(entry.at("initial_overlap"), "invalid initial_overlap of tied parts; expected error, warn, move or offset");
  entry.optional("limit", contact.limit, positive);
  if (entry.has("limit") && contact.initial_overlap != Overlap::place)
    fault(entry.at("limit"), "invalid without initial_overlap: place; expected no limit");
  read_settled(entry);
  read_mortar(entry, contact);
  return contact;
}

}  // namespace

void read_friction(Section& entry, contact::FrictionLaw& friction) {
  if (!entry.has("friction")) return;
  const Key key = entry.at("friction");
  if (key.tree->kind != Tree::Kind::map) {
    read(key, friction.fixed, not_negative);
    friction.kinetic = friction.fixed;
    return;
  }
  Section law(key, "a map {static: number, kinetic: number, decay: number, lag: number}");
  const bool has_static = law.required("static", friction.fixed, not_negative);
  friction.kinetic = friction.fixed;
  law.optional("kinetic", friction.kinetic, not_negative);
  law.optional("decay", friction.decay, not_negative);
  law.optional("lag", friction.lag, not_negative);
  if (has_static && friction.kinetic > friction.fixed)
    fault(law.at("kinetic"),
          fmt::format("invalid kinetic coefficient {}: larger than the static one, {}; expected at most the static one",
                      friction.kinetic, friction.fixed));
}

void read_search(Section& scene, Input& input) {
  if (!scene.has("search")) return;
  using contact::SearchMethod;
  static const Choices<SearchMethod> methods{{{"auto", SearchMethod::automatic},
                                              {"blocks", SearchMethod::blocks},
                                              {"binary", SearchMethod::binary},
                                              {"bucket", SearchMethod::bucket}},
                                             {}};
  Section section(scene.at("search"), "a map {method: auto, blocks, binary or bucket}");
  if (section.is_map()) section.optional("method", input.search, methods);
}

void read_contact(Section& scene, Input& input) {
  read_search(scene, input);
  EnforcementReader enforcement(scene, input);
  contact::Passes passes = contact::Passes::automatic;
  if (scene.has("contact"))
    for (const Key& key : items(scene.at("contact"), "a list of {between: all} or {between: [a, b]}")) {
      Section entry(key, "a map {between: all} or {between: [a, b]}");
      if (!entry.is_map()) continue;
      const ContactEntry contact = read_entry(entry, passes);
      passes = contact.passes;
      if (!contact.mortar) enforcement.read_entry(key, entry);
      judge_passes(entry, contact, input);
      judge_method(key, contact, input);
      judge_untied(key, entry, contact, input);
      const contact::FrictionLaw& friction = contact.friction;
      if (friction.kinetic < friction.fixed && friction.decay == 0)
        warn(entry.at("friction"), "kinetic has no effect without decay: the coefficient remains the static one",
             input);
      input.contact.push_back(contact);
    }
  enforcement.judge();
}

}  // namespace brunt::scene
