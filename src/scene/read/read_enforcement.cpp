// SPDX-License-Identifier: Apache-2.0
#include "read_enforcement.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "core/excerpt.hpp"

namespace brunt::scene {
namespace {

using contact::Criterion;
using contact::Method;
using contact::Rebuild;

/// The keys, and whether two settings agree.
struct Figure {
  const char* name;
  bool (*same)(const Enforcement&, const Enforcement&);
};
constexpr std::array figures{
    Figure{"method", [](const Enforcement& a, const Enforcement& b) { return a.settings.method == b.settings.method; }},
    Figure{"tolerance",
           [](const Enforcement& a, const Enforcement& b) { return a.settings.tolerance == b.settings.tolerance; }},
    Figure{"max_iterations",
           [](const Enforcement& a, const Enforcement& b) {
             return a.settings.max_iterations == b.settings.max_iterations;
           }},
    Figure{"softness",
           [](const Enforcement& a, const Enforcement& b) { return a.settings.softness == b.settings.softness; }},
    Figure{"partition",
           [](const Enforcement& a, const Enforcement& b) { return a.settings.partition == b.settings.partition; }},
    Figure{"stiffness",
           [](const Enforcement& a, const Enforcement& b) { return a.settings.stiffness == b.settings.stiffness; }},
    Figure{"damping",
           [](const Enforcement& a, const Enforcement& b) { return a.settings.damping == b.settings.damping; }},
    Figure{"competing", [](const Enforcement& a, const Enforcement& b) { return a.competing == b.competing; }},
    Figure{"rebuild", [](const Enforcement& a, const Enforcement& b) { return a.rebuild == b.rebuild; }}};

/// The time of rebuilding lists changes no result: this key serves tests.
void read_rebuild(const Key& key, Rebuild& rebuild) {
  const bool word = key.tree->kind == Tree::Kind::value;
  if (word && (key.tree->text == "auto" || key.tree->text == "random")) {
    rebuild = {key.tree->text == "auto" ? Rebuild::When::motion_used_up : Rebuild::When::random};
    return;
  }
  static const Range steps{1, 1e9, true, true, "auto, random or an integer from 1 to 1000000000"};
  double number = 1;
  if (!read(key, number, steps)) return;
  if (std::trunc(number) != number)
    fault(key, fmt::format("invalid value '{}'; expected {}", excerpt(key.tree->text), steps.words));
  rebuild = {Rebuild::When::every, static_cast<int>(number)};
}

void read_figures(Section& from, Enforcement& enforcement) {
  static const Choices<Method> methods{{contact::method_names.begin(), contact::method_names.end()}, {}};
  static const Choices<Criterion> competing{{{"auto", Criterion::automatic},
                                             {"nearest", Criterion::nearest},
                                             {"strength", Criterion::strength},
                                             {"velocity", Criterion::velocity}},
                                            {}};
  contact::EnforcementSettings& settings = enforcement.settings;
  from.optional("method", settings.method, methods);
  from.optional("tolerance", settings.tolerance, below_one);
  from.optional("max_iterations", settings.max_iterations, Count{1});
  if (from.has("softness")) {
    from.optional("softness", settings.softness, share);
    settings.softness_of_bodies = settings.softness;
  }
  from.optional("partition", settings.partition, Range{0, 1, false, true, "a number > 0 and <= 1"});
  from.optional("stiffness", settings.stiffness, Range{0, 2, false, true, "a number > 0 and <= 2"});
  from.optional("damping", settings.damping, share);
  from.optional("competing", enforcement.competing, competing);
  if (from.has("rebuild")) read_rebuild(from.at("rebuild"), enforcement.rebuild);
}

}  // namespace

void warn(const Key& key, std::string_view what, Input& input) {
  input.warnings.push_back(fmt::format("{}: {}", place_of(key), what));
}

EnforcementReader::EnforcementReader(Section& scene, Input& input) : input_(input) {
  if (!scene.has("enforcement")) return;
  section_.emplace(scene.at("enforcement"), "a map {method: rate, tolerance: 1.0e-3, ...}");
  read_figures(*section_, input.enforcement);
  if (section_->has("softness")) softness_ = section_->at("softness");
}

void EnforcementReader::read_entry(const Key& whole, Section& entry) {
  const Enforcement before = input_.enforcement;
  read_figures(entry, input_.enforcement);
  for (const Figure& figure : figures)
    if (entry.has(figure.name) && section_has(figure.name) && !figure.same(before, input_.enforcement))
      fault(entry.at(figure.name),
            fmt::format(
                "invalid value {}: enforcement.{} is {}; expected the same value in both places, or one of the keys",
                excerpt(entry.at(figure.name).tree->text), figure.name, excerpt(section_->at(figure.name).tree->text)));
  if (entry.has("softness")) softness_ = entry.at("softness");
  judge_figures(entry);
  if (input_.enforcement.settings.method == Method::printed && !section_has("method"))
    warn(whole,
         "method printed overcorrects the velocities: bodies rebound and the iteration may not converge; use it for "
         "comparisons only",
         input_);
}

void EnforcementReader::judge() {
  if (softness_ && input_.enforcement.settings.softness > 0 &&
      std::ranges::any_of(input_.contact,
                          [](const ContactEntry& entry) { return entry.passes == contact::Passes::averaged; }))
    warn(*softness_, "no effect where a contact has passes: averaged", input_);
  if (!section_) return;
  if (input_.contact.empty() && input_.rigid_walls.empty())
    warn(section_->key(), "no effect without contact or rigid_walls", input_);
  judge_figures(*section_);
  if (!section_->has("method")) return;
  const Method method = input_.enforcement.settings.method;
  if (method == Method::printed)
    warn(section_->at("method"),
         "printed overcorrects the velocities: bodies rebound and the iteration may not converge; use it for "
         "comparisons only",
         input_);
  const bool rubs = std::ranges::any_of(input_.rigid_walls, [](const RigidWall& wall) { return wall.friction.any(); });
  if (method == Method::reference && input_.contact.empty() && rubs)
    fault(section_->at("method"), "invalid method: reference has no friction; expected friction: 0 on rigid walls");
}

void EnforcementReader::judge_figures(Section& given) {
  const Method method = input_.enforcement.settings.method;
  const bool penalty = method == Method::penalty || method == Method::gap_penalty;
  const auto unused = [&](const char* name, bool used, const char* methods) {
    if (given.has(name) && !used) warn(given.at(name), fmt::format("no effect except with method {}", methods), input_);
  };
  unused("stiffness", penalty, "gap_penalty or penalty");
  unused("damping", method == Method::penalty, "penalty");
  unused("partition", method == Method::kinematic, "kinematic");
  unused("softness", method == Method::rate || method == Method::row_sum, "rate or row_sum");
}

}  // namespace brunt::scene
