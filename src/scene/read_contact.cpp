// SPDX-License-Identifier: Apache-2.0
// Contact between parts.
#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "brunt/scene/sections.hpp"

namespace brunt::scene {
namespace {

using Overlap = contact::OverlapRule;
using Slave = ContactEntry::Slave;

/// Two parts, or one twice: contact with itself.
bool read_pair(const Key& key, std::array<std::string, 2>& pair, std::string_view accepted) {
  const std::vector<Key> names = items(key, accepted, 2);
  return names.size() == 2 && read(names[0], pair[0], Named::part) && read(names[1], pair[1], Named::part);
}

void read_between(Section& entry, ContactEntry& contact) {
  constexpr std::string_view accepted = "all, or two parts [a, b]";
  const Key key = entry.at("between");
  const bool word = key.tree == nullptr || key.tree->kind != Tree::Kind::list;
  if (word) {
    static const Choices<bool> choices{{{"all", true}}, {}};
    bool all = true;
    if (key.tree == nullptr || key.tree->kind != Tree::Kind::value) {
      wrong(key, accepted);
    } else {
      read(key, all, choices);
    }
    return;
  }
  std::array<std::string, 2> pair;
  if (read_pair(key, pair, accepted)) contact.between = {pair[0], pair[1]};
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
                 fmt::format("'{}' needs a pair of parts, between: [a, b]; accepted with 'all': auto", key.tree->text));
  std::vector<std::string> words{"auto", "first", "second"};
  words.insert(words.end(), parts.begin(), parts.end());
  const std::size_t chosen = read_choice(key, words, {});
  if (chosen == words.size() || chosen == 0) return;
  contact.slave = chosen % 2 == 1 ? Slave::first : Slave::second;
}

/// When lists are rebuilt changes no result: a check of that, not a choice of method.
void read_rebuild(const Key& key, ContactEntry& contact) {
  if (key.tree->kind == Tree::Kind::value && key.tree->text == "auto") return;
  if (key.tree->kind == Tree::Kind::value && key.tree->text == "random") {
    contact.rebuild.when = contact::Rebuild::When::random;
    return;
  }
  contact.rebuild.when = contact::Rebuild::When::every;
  read(key, contact.rebuild.steps, Count{1});
}

/// How rows are enforced, and the figures of that method.
void read_enforcement(Section& entry, contact::EnforcementSettings& enforcement) {
  using contact::Method;
  static const Choices<Method> methods{{contact::method_names.begin(), contact::method_names.end()}, {}};
  entry.optional("method", enforcement.method, methods);
  entry.optional("tolerance", enforcement.tolerance, Range{0, 1, false, false, "a number > 0 and < 1"});
  entry.optional("max_iterations", enforcement.max_iterations, Count{1});
  entry.optional("softness", enforcement.softness, Range{0, 1, true, true, "a number from 0 to 1"});
  entry.optional("partition", enforcement.partition, Range{0, 1, false, true, "a number > 0 and <= 1"});
  entry.optional("stiffness", enforcement.stiffness, Range{0, 2, false, true, "a number > 0 and <= 2"});
  entry.optional("damping", enforcement.damping, Range{0, 1, true, true, "a number from 0 to 1"});
}

/// Words of the vocabulary of which this version has one meaning only.
void read_settled(Section& entry) {
  if (entry.has("thickness") && entry.at("thickness").tree->text != "auto") {
    later(entry.at("thickness"), "thickness in contact", "auto");
  }
}

void warn(const Key& key, std::string_view what, Input& input) {
  input.warnings.push_back(fmt::format("{}: {}", place_of(key), what));
}

/// Settings that would do nothing, or not what they seem to.
void judge_enforcement(const Key& whole, Section& entry, const ContactEntry& contact, Input& input) {
  using contact::Method;
  const Method method = contact.enforcement.method;
  const bool penalty = method == Method::penalty || method == Method::gap_penalty;
  const auto unused = [&](const char* name, bool used, const char* methods) {
    if (entry.has(name) && !used) warn(entry.at(name), fmt::format("does nothing but with method {}", methods), input);
  };
  unused("stiffness", penalty, "gap_penalty or penalty");
  unused("damping", method == Method::penalty, "penalty");
  unused("partition", method == Method::kinematic, "kinematic");
  unused("softness", method == Method::rate || method == Method::row_sum, "rate or row_sum");
  const bool two = contact.passes == contact::Passes::two || contact.passes == contact::Passes::averaged;
  if (two && contact.slave != Slave::automatic && entry.has("slave"))
    warn(entry.at("slave"), "does nothing in two passes", input);
  if (two && contact.friction.lag > 0)
    fault(
        entry.has("passes") ? entry.at("passes") : entry.at("friction"),
        "friction with a lag is for one pass (in two, rows come and go, and their lag with them); accepted: auto, one");
  if (contact.tied && entry.has("passes") && two)
    warn(entry.at("passes"), "does nothing where parts are tied: ties have one pass", input);
  if (method == Method::printed)
    warn(whole, "method printed over-corrects: it rebounds and may not converge; for comparisons", input);
  const bool ties = contact.tied || std::ranges::any_of(input.contact, &ContactEntry::tied);
  if (ties && method != Method::rate && method != Method::row_sum)
    fault(whole, "tied parts are held by the rate constraint; accepted: method rate or row_sum");
  if (method != Method::reference) return;
  const bool rubs = contact.friction.any() ||
                    std::ranges::any_of(input.contact, [](const ContactEntry& e) { return e.friction.any(); }) ||
                    std::ranges::any_of(input.rigid_walls, [](const RigidWall& wall) { return wall.friction.any(); });
  if (rubs) fault(whole, "method reference is for scenes without friction; accepted: friction 0, on rigid walls too");
}

void judge_tied(Section& entry, const ContactEntry& contact) {
  const Key key = entry.at("tied");
  const bool all = entry.has("between") && entry.at("between").tree->kind == Tree::Kind::value;
  if (all) fault(key, "'all' cannot be tied; accepted: true where between: [a, b]");
  if (!contact.between.empty() && contact.between[0] == contact.between[1])
    fault(key, "a part cannot be tied to itself; accepted: true where between: [a, b]");
  if (contact.friction.any()) fault(key, "tied parts do not slide; accepted: true without friction");
}

/// A later entry that names two tied parts unties them: what is meant is to be said.
void judge_untied(const Key& whole, Section& entry, const ContactEntry& contact, Input& input) {
  if (contact.tied || contact.between.empty() || entry.has("tied")) return;
  const std::set<std::string> pair(contact.between.begin(), contact.between.end());
  const auto names_it = [&](const ContactEntry& earlier) {
    return pair == std::set<std::string>(earlier.between.begin(), earlier.between.end());
  };
  const auto last = std::ranges::find_if(input.contact.rbegin(), input.contact.rend(), names_it);
  if (last == input.contact.rend() || !last->tied) return;
  warn(whole,
       fmt::format("unties {} and {}, which contact.{} ties; with tied: false it does so without this warning",
                   contact.between[0], contact.between[1], input.contact.rend() - last - 1),
       input);
}

ContactEntry read_entry(Section& entry, const ContactEntry& before) {
  static const Choices<Overlap> overlaps{
      {{"error", Overlap::error}, {"warn", Overlap::warn}, {"move", Overlap::move}, {"offset", Overlap::offset}}, {}};
  using contact::Criterion;
  static const Choices<Criterion> competing{{{"auto", Criterion::automatic},
                                             {"nearest", Criterion::nearest},
                                             {"strength", Criterion::strength},
                                             {"velocity", Criterion::velocity}},
                                            {}};
  using contact::Passes;
  static const Choices<Passes> passes{
      {{"auto", Passes::automatic}, {"one", Passes::one}, {"two", Passes::two}, {"averaged", Passes::averaged}}, {}};
  ContactEntry contact;
  contact.enforcement = before.enforcement;
  contact.passes = before.passes;
  read_between(entry, contact);
  if (entry.has("exclude")) read_exclude(entry.at("exclude"), contact);
  read_friction(entry, contact.friction);
  if (entry.has("slave")) read_slave(entry.at("slave"), contact);
  entry.optional("passes", contact.passes, passes);
  entry.optional("self", contact.self);
  entry.optional("competing", contact.competing, competing);
  read_enforcement(entry, contact.enforcement);
  if (entry.has("rebuild")) read_rebuild(entry.at("rebuild"), contact);
  if (entry.optional("tied", contact.tied) && contact.tied) {
    judge_tied(entry, contact);
    contact.initial_overlap = Overlap::offset;  // ties hold nodes where they are
  }
  entry.optional("initial_overlap", contact.initial_overlap, overlaps);
  read_settled(entry);
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
          fmt::format("{} is more than static {}; accepted: at most as much", friction.kinetic, friction.fixed));
}

void read_contact(Section& scene, Input& input) {
  if (!scene.has("contact")) return;
  for (const Key& key : items(scene.at("contact"), "a list of {between: all} or {between: [a, b]}")) {
    Section entry(key, "a map {between: all} or {between: [a, b]}");
    if (!entry.is_map()) continue;
    const ContactEntry contact = read_entry(entry, input.contact.empty() ? ContactEntry{} : input.contact.back());
    judge_enforcement(key, entry, contact, input);
    judge_untied(key, entry, contact, input);
    const contact::FrictionLaw& friction = contact.friction;
    if (friction.kinetic < friction.fixed && friction.decay == 0)
      warn(entry.at("friction"), "without decay the coefficient stays the static one, kinetic does nothing", input);
    input.contact.push_back(contact);
  }
}

}  // namespace brunt::scene
