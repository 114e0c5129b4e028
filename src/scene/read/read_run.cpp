// SPDX-License-Identifier: Apache-2.0
// Duration of the run, and its output.
#include <fmt/format.h>

#include <algorithm>

#include "scene/read/sections.hpp"
#include "scene/text/commas.hpp"
#include "scene/text/duration.hpp"

namespace brunt::scene {
namespace {

const Choices<StepBound> step_bounds{{{"element", StepBound::element}, {"assembled", StepBound::assembled}}, {}};

void read_wall_limit(const Key& key, Run& run) {
  constexpr std::string_view expected = "a duration > 0 such as 3h55m, 90s, 2h, or a number of seconds";
  std::string text;
  if (!read(key, text, expected)) return;
  run.wall_limit = parse_duration(text);
  const IsValue is_duration = [](std::string_view some) { return parse_duration(some).has_value(); };
  if (!run.wall_limit && !comma_in_value(key, expected, is_duration)) wrong(key, expected);
}

void read_fields(const Key& key, Output& output) {
  static const std::vector<std::string> fields{
      "displacement", "velocity",    "stress", "plastic_strain", "contact_pressure", "gap",
      "mass",         "temperature", "damage", "strain_rate",    "relative_volume",  "energy"};
  output.fields.clear();
  for (const Key& entry : items(key, "a list of fields, such as [displacement, velocity, stress]")) {
    const std::size_t chosen = read_choice(entry, fields, {});
    if (chosen == fields.size()) continue;
    if (std::find(output.fields.begin(), output.fields.end(), fields[chosen]) != output.fields.end()) {
      fault(entry, fmt::format("invalid field '{}': listed twice; expected each field once", fields[chosen]));
    }
    output.fields.push_back(fields[chosen]);
  }
}

void read_every(Section& scene, std::string_view name, std::optional<double>& every) {
  if (!scene.has(name)) return;
  Section section(scene.at(name), "a map {every: time}");
  section.required("every", every, positive);
}

}  // namespace

void read_run(Section& scene, Input& input) {
  Section run(scene.at("run"), "a map {end: time} or {steps: count}");
  run.optional("end", input.run.end, positive);
  if (run.has("steps")) {
    GlobalIndex steps = 0;
    if (run.required("steps", steps, Count{1, 1'000'000'000'000})) input.run.steps = steps;
  }
  if (run.is_map() && !run.has("end") && !run.has("steps")) {
    lacking(run.key(), {"end", "steps"}, "missing end; expected end: time, or steps: count");
  }
  run.optional("cfl", input.run.cfl, courant);
  run.optional("step_bound", input.run.step_bound, step_bounds);
  run.optional("step", input.run.step, positive);
  run.optional("min_step_ratio", input.run.min_step_ratio, below_one);
  if (run.has("wall_limit")) read_wall_limit(run.at("wall_limit"), input.run);
  if (scene.has("output")) {
    Section output(scene.at("output"), "a map {every: time, fields: [...]}");
    output.optional("every", input.output.every, positive);
    if (output.has("fields")) read_fields(output.at("fields"), input.output);
  }
  read_every(scene, "history", input.history_every);
  read_every(scene, "checkpoint", input.checkpoint_every);
}

}  // namespace brunt::scene
