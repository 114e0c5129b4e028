// SPDX-License-Identifier: Apache-2.0
#include "read_enforcement.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <tuple>

#include "core/excerpt.hpp"
#include "scene/read/sections.hpp"

namespace brunt::scene {
namespace {

using contact::Criterion;
using contact::EnforcementSettings;
using contact::Impact;
using contact::Method;
using contact::Rebuild;

constexpr Range to_two{0, 2, false, true, "a number > 0 and <= 2"};
const Choices<Rebuild::When>& rebuild_words() {
  static const Choices<Rebuild::When> words{
      {{"auto", Rebuild::When::motion_used_up}, {"random", Rebuild::When::random}}, {}};
  return words;
}

const Choices<Impact>& impact_words() {
  static const Choices<Impact> words{{{"plastic", Impact::plastic}, {"elastic", Impact::elastic}}, {}};
  return words;
}

/// One softness for all constraints.
void read_softness(const Key& key, EnforcementSettings& settings) {
  if (read(key, settings.softness, share)) settings.softness_of_bodies = settings.softness;
}

/// The time of rebuilding lists changes no result: this key serves tests.
void read_rebuild(const Key& key, Rebuild& rebuild) {
  if (is_word_of(rebuild_words(), key)) {
    rebuild = {};
    read(key, rebuild.when, rebuild_words());
    return;
  }
  static const Range steps{1, 1e9, true, true, "auto, random or an integer from 1 to 1000000000"};
  double number = 1;
  if (!read(key, number, steps)) return;
  if (std::trunc(number) != number)
    fault(key, fmt::format("invalid value '{}'; expected {}", excerpt(key.tree->text), steps.words));
  rebuild = {Rebuild::When::every, static_cast<int>(number)};
}

std::vector<Row<EnforcementSettings>> rows_of_settings() {
  using Settings = EnforcementSettings;
  return {
      {"method", value(&Settings::method, methods()), "-", "The rate constraint; all others are for comparison."},
      {"tolerance", value(&Settings::tolerance, below_one), "-",
       "Residual of the iteration, divided by the largest violation of the constraints by the predicted velocities."},
      {"max_iterations", value(&Settings::max_iterations, Count{1}), "-",
       "A step that ends here above the tolerance is counted and reported."},
      {"softness", special(phrase(0.0, share), read_softness), "-",
       "Compliance softness dt^2/m of the constraints of two passes and between rigid bodies, there with the mass of "
       "the heaviest of a chain ([measurements](../../cases/README.md#softness-of-contact)).",
       fmt::format("{}; rigid bodies {}", Settings{}.softness, Settings{}.softness_of_bodies)},
      {"impact", value(&Settings::impact, impact_words()), "-",
       "`plastic`: contact takes the energy of the half elements that meet. `elastic`: it returns this energy as they "
       "separate, unless adjacent elements have flowed ([impact](../contact/enforcement/IMPACT.md))."},
      {"partition", value(&Settings::partition, courant), "-",
       "Of `kinematic`: share of the gap that one correction closes."},
      {"stiffness", value(&Settings::stiffness, to_two), "-",
       "Of `gap_penalty` and `penalty`: spring stiffness in units of mass/dt^2. The stable step is multiplied by "
       "sqrt(1 - stiffness/4)."},
      {"damping", value(&Settings::damping, share), "-",
       "Of `penalty`: share of the closing rate that a step removes."},
  };
}

std::vector<Row<Enforcement>> rows_of_enforcement() {
  static const Choices<Criterion> competing{{{"auto", Criterion::automatic},
                                             {"nearest", Criterion::nearest},
                                             {"strength", Criterion::strength},
                                             {"velocity", Criterion::velocity}},
                                            {}};
  std::vector<Row<Enforcement>> rows = within(&Enforcement::settings, rows_of_settings());
  rows.push_back({"competing", value(&Enforcement::competing, competing), "-",
                  "Choice among the faces that a node can meet at a convex edge."});
  rows.push_back(
      {"rebuild",
       special<Enforcement>(phrase(Rebuild{}.when, rebuild_words()) + " or integer >= 1",
                            [](const Key& key, Enforcement& enforcement) { read_rebuild(key, enforcement.rebuild); }),
       "-", "When candidate lists are rebuilt; no result depends on it.", shown(Rebuild{}.when, rebuild_words())});
  return rows;
}

/// The values of all keys.
auto values_of(const Enforcement& enforcement) {
  const EnforcementSettings& settings = enforcement.settings;
  return std::tuple(settings.method, settings.tolerance, settings.max_iterations, settings.softness, settings.impact,
                    settings.partition, settings.stiffness, settings.damping, enforcement.competing,
                    enforcement.rebuild);
}

constexpr std::string_view printed_overcorrects =
    "overcorrects the velocities: bodies rebound and the iteration may not converge; use it for comparisons only";

/// Warns of keys of the section, or of an entry, without effect.
void warn_of_unused(const Key& map, Method method) {
  const bool penalty = method == Method::penalty || method == Method::gap_penalty;
  const auto unused = [&](const char* name, bool used, const char* used_by) {
    if (has(map, name) && !used) warn(at(map, name), fmt::format("no effect except with method {}", used_by));
  };
  unused("stiffness", penalty, "gap_penalty or penalty");
  unused("damping", method == Method::penalty, "penalty");
  unused("partition", method == Method::kinematic, "kinematic");
  unused("softness", method == Method::rate || method == Method::row_sum, "rate or row_sum");
}

bool averages(const Input& input) {
  return std::ranges::any_of(input.contact,
                             [](const ContactEntry& entry) { return entry.passes == contact::Passes::averaged; });
}

/// Where a key of the section or of an entry is given last.
std::optional<Key> last_given(const Key& scene, const char* name) {
  std::optional<Key> last;
  if (const Key section = at(scene, "enforcement"); has(section, name)) last = at(section, name);
  if (!has(scene, "contact")) return last;
  for (const Key& entry : items(at(scene, "contact"), ""))
    if (has(entry, name)) last = at(entry, name);
  return last;
}

/// Softness has no effect on the mean of two passes.
void warn_of_softness(const Key& scene, const Input& input) {
  if (!averages(input) || !(input.enforcement.settings.softness > 0)) return;
  if (const std::optional<Key> last = last_given(scene, "softness"))
    warn(*last, "no effect where a contact has passes: averaged");
}

/// Energy is returned within one system of all rows that holds their rates exactly.
void judge_impact(const Key& scene, const Input& input) {
  const EnforcementSettings& settings = input.enforcement.settings;
  if (settings.impact != Impact::elastic) return;
  const std::optional<Key> last = last_given(scene, "impact");
  if (!last) return;
  if (settings.method != Method::rate && settings.method != Method::row_sum)
    fault(*last,
          fmt::format("invalid impact elastic with method {}; expected method rate or row_sum, or impact plastic",
                      contact::name_of(settings.method)));
  else if (averages(input))
    fault(*last,
          "invalid impact elastic with passes averaged; expected passes auto, one, two or mortar, or impact plastic");
}

}  // namespace

const Table<Enforcement> enforcement_keys{
    "enforcement",
    "a map {method: rate, tolerance: 1.0e-3, ...}",
    enforcement_rows(),
};

const Choices<Method>& methods() {
  static const Choices<Method> all{{contact::method_names.begin(), contact::method_names.end()}, {}};
  return all;
}

const std::vector<Row<Enforcement>>& enforcement_rows() {
  static const std::vector<Row<Enforcement>> rows = rows_of_enforcement();
  return rows;
}

void judge_enforcement_of_entry(const Key& entry, const Enforcement& given, const Input& input) {
  const Key section = at(scene_of(entry), "enforcement");
  for (const Row<Enforcement>& row : enforcement_rows()) {
    const std::string& key = row.said.key;
    if (!has(entry, key) || !has(section, key)) continue;
    Enforcement changed = input.enforcement;
    row.value.read(at(entry, key), changed);
    if (values_of(changed) != values_of(input.enforcement))
      fault(at(entry, key),
            fmt::format(
                "invalid value {}: enforcement.{} is {}; expected the same value in both places, or one of the keys",
                excerpt(at(entry, key).tree->text), key, excerpt(at(section, key).tree->text)));
  }
  warn_of_unused(entry, given.settings.method);
  if (given.settings.method == Method::printed && !has(section, "method"))
    warn(entry, fmt::format("method printed {}", printed_overcorrects));
}

void judge_enforcement(const Key& scene, const Input& input) {
  warn_of_softness(scene, input);
  judge_impact(scene, input);
  const Key section = at(scene, "enforcement");
  if (!is_map(section)) return;
  if (input.contact.empty() && input.rigid_walls.empty()) warn(section, "no effect without contact or rigid_walls");
  const Method method = input.enforcement.settings.method;
  warn_of_unused(section, method);
  if (!has(section, "method")) return;
  if (method == Method::printed) warn(at(section, "method"), fmt::format("printed {}", printed_overcorrects));
  const bool rubs = std::ranges::any_of(input.rigid_walls, [](const RigidWall& wall) { return wall.friction.any(); });
  if (method == Method::reference && input.contact.empty() && rubs)
    fault(at(section, "method"), "invalid method: reference has no friction; expected friction: 0 on rigid walls");
}

}  // namespace brunt::scene
