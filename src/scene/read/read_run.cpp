// SPDX-License-Identifier: Apache-2.0
// Duration of the run, and its output.
#include <fmt/format.h>

#include <algorithm>

#include "scene/keys/table.hpp"
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

void judge_run(const Key& map, Run&) {
  if (!has(map, "end") && !has(map, "steps"))
    lacking(map, {"end", "steps"}, "missing end; expected end: time, or steps: count");
}

void read_fields(const Key& key, Output& output) {
  static const std::vector<std::string> fields{
      "displacement", "velocity",      "stress",    "plastic_strain", "contact_pressure", "gap",
      "mass",         "temperature",   "damage",    "strain_rate",    "relative_volume",  "energy",
      "thickness",    "stress_bottom", "stress_top"};
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

}  // namespace

const Table<Run> run_keys{
    "run",
    "a map {end: time} or {steps: count}",
    {
        {"end", value(&Run::end, positive), "time", "The run ends with the first step at or after this time.",
         "required, or `steps`"},
        {"steps", value(&Run::steps, Count{1, 1'000'000'000'000}), "-",
         "Number of steps; with both, the first that is reached ends the run.", "required, or `end`"},
        {"cfl", value(&Run::cfl, courant), "-", "Share of the stable step that is used."},
        {"step_bound", value(&Run::step_bound, step_bounds), "-",
         "Stable step of the fastest free element, or of the [assembled "
         "mesh](../time/README.md#the-step-of-the-assembled-mesh), up to 1.4 times as long."},
        {"step", value(&Run::step, positive), "time", "Largest step; required if all parts are rigid."},
        {"min_step_ratio", value(&Run::min_step_ratio, below_one), "-",
         "The run stops (exit code 3) when the stable step falls below this share of the first one."},
        {"wall_limit", special("duration", read_wall_limit), "-",
         "Wall-clock time after which the run writes a checkpoint and stops: `3h55m`, `90s`, or seconds."},
    },
    judge_run,
};

const Table<Output> output_keys{
    "output",
    "a map {every: time, fields: [...]}",
    {
        {"every", value(&Output::every, positive), "time", "Interval of the records in state.h5.",
         "first and last state"},
        {"fields", special("list of fields", read_fields), "-", "Names of the next table.",
         fmt::format("`[{}]`", fmt::join(Output{}.fields, ", "))},
    },
};

const Table<Input> history_keys{
    "history",
    "a map {every: time}",
    {
        {"every", value(&Input::history_every, positive), "time",
         "Interval of the rows; without `history` some 200 rows are written, at least five steps apart.", required},
    },
};

const Table<Input> checkpoint_keys{
    "checkpoint",
    "a map {every: time}",
    {
        {"every", value(&Input::checkpoint_every, positive), "time",
         "Interval of the checkpoints; without `checkpoint` one is written at the end.", required},
    },
};

}  // namespace brunt::scene
