// SPDX-License-Identifier: Apache-2.0
// `solver`: implicit time integration. Read after `run`, whose end determines the default of the step.
#include <fmt/format.h>

#include <cmath>

#include "scene/keys/table.hpp"
#include "scene/read/sections.hpp"

namespace brunt::scene {
namespace {

using model::ImplicitSolver;
using model::LinearSolver;
using model::Scheme;

constexpr double default_steps = 100;    // of a run whose scene names no step
constexpr double default_halvings = 10;  // from `step` to `min_step`
constexpr Range to_a_third{0, 1.0 / 3.0, true, true, "a number from 0 to 1/3"};

const Choices<Scheme> schemes{{{"static", Scheme::statics},
                               {"contact_implicit", Scheme::contact_implicit},
                               {"hht", Scheme::hht},
                               {"newmark", Scheme::newmark}},
                              {}};
const Choices<LinearSolver> linears{{{"direct", LinearSolver::direct}, {"mumps", LinearSolver::mumps}}, {}};
const Choices<bool> stabilities{{{"warn", true}, {"ignore", false}}, {}};

/// The solver, beside the run on which its step depends.
struct GivenSolver {
  ImplicitSolver solver;
  Run run;
};

/// Fills in defaults. False without a step.
bool complete(const Run& run, ImplicitSolver& solver) {
  if (solver.step == 0 && run.end) solver.step = *run.end / default_steps;
  if (solver.min_step == 0) solver.min_step = solver.step * std::exp2(-default_halvings);
  if (solver.max_step == 0) solver.max_step = solver.step;
  return solver.step > 0;
}

/// The bounds of the step must enclose it.
void judge_bounds(const Key& map, const ImplicitSolver& solver) {
  constexpr double rounding = 1e-9;
  if (solver.min_step > (1 + rounding) * solver.step)
    fault(at(map, "min_step"), "out of range: larger than step; expected a number > 0, at most step");
  if (solver.max_step < (1 - rounding) * solver.step)
    fault(at(map, "max_step"), "out of range: smaller than step; expected a number, at least step");
}

void judge_solver(const Key& map, GivenSolver& given) {
  ImplicitSolver& solver = given.solver;
  if (has(map, "alpha") && solver.scheme != Scheme::hht)
    fault(at(map, "alpha"), "invalid without scheme: hht; expected no alpha, or scheme: hht");
  if (has(map, "stability") && solver.scheme != Scheme::statics)
    fault(at(map, "stability"), "invalid without scheme: static; expected no stability, or scheme: static");
  if (complete(given.run, solver))
    judge_bounds(map, solver);
  else if (given.run.steps)  // without it the missing end of the run has been reported
    lacking(map, {"step"}, "missing step; expected step: time");
}

const std::vector<Row<ImplicitSolver>> solver_rows{
    {"scheme", value(&ImplicitSolver::scheme, schemes), "-",
     "Statics; trapezoidal rule with plastic impacts; the method of Hilber, Hughes and Taylor; trapezoidal rule."},
    {"step", value(&ImplicitSolver::step, positive), "time", "First step; all steps are this times a power of two.",
     fmt::format("`run.end` / {}", default_steps)},
    {"min_step", value(&ImplicitSolver::min_step, positive), "time",
     "At most `step`. The run stops (exit code 3) where a shorter step would be needed.",
     fmt::format("`step` / {}", std::exp2(default_halvings))},
    {"max_step", value(&ImplicitSolver::max_step, positive), "time", "At least `step`.", "`step`"},
    {"tolerance", value(&ImplicitSolver::tolerance, below_one), "-",
     "Norm of the residual forces over the norm of the acting forces."},
    {"linear", value(&ImplicitSolver::linear, linears), "-",
     "Factorisation on one rank, with the same bits on any number of ranks, or on all ranks."},
    {"alpha", value(&ImplicitSolver::alpha, to_a_third), "-",
     "Of `hht`: numerical damping of motions that the step does not resolve."},
    {"stability", value(&ImplicitSolver::stability, stabilities), "-",
     "Of `static`: whether to [warn](../implicit/README.md#stability) where equilibrium becomes unstable (buckling, "
     "snapping), and where it is stable again."},
};

const Table<GivenSolver> solver_keys{
    "solver",
    "implicit, explicit, or a map {scheme, step, min_step, max_step, tolerance, linear, alpha, stability}",
    within(&GivenSolver::solver, solver_rows),
    judge_solver,
};

/// `implicit` or `explicit`.
void read_word(const Key& key, Input& input) {
  static const Choices<bool> words{{{"implicit", true}, {"explicit", false}}, {}};
  const std::string& word = key.tree->text;
  if (is_word_of(schemes, key))
    return fault(
        key,
        fmt::format("invalid value '{0}', which is a scheme; expected {{scheme: {0}}}, implicit or explicit", word));
  bool implicit = false;
  if (!read(key, implicit, words) || !implicit) return;
  ImplicitSolver solver;
  if (complete(input.run, solver))
    input.implicit = solver;
  else if (input.run.steps)  // without it the missing end of the run has been reported
    fault(key, "missing step; expected a map with step: time, or run.end, a hundredth of which is the step");
}

void read_either(const Key& key, Input& input) {
  if (is_value(key)) return read_word(key, input);
  GivenSolver given{{}, input.run};
  if (solver_keys.read(key, given)) input.implicit = given.solver;
}

}  // namespace

Value<Input> solver_value() {
  return special("`explicit`, `implicit` or map", read_either, {&solver_keys});
}

}  // namespace brunt::scene
