// SPDX-License-Identifier: Apache-2.0
// `solver`: implicit time integration. Read after `run`, whose end determines the default of the step.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "scene/read/sections.hpp"

namespace brunt::scene {
namespace {

using model::ImplicitSolver;
using model::LinearSolver;
using model::Scheme;

constexpr double default_steps = 100;    // of a run whose scene names no step
constexpr double default_halvings = 10;  // from `step` to `min_step`
constexpr Range to_a_third{0, 1.0 / 3.0, true, true, "a number from 0 to 1/3"};
constexpr std::string_view expected =
    "implicit, explicit, or a map {scheme, step, min_step, max_step, tolerance, linear, alpha, stability}";

/// The bounds of the step must enclose it.
void check_bounds(Section& section, const ImplicitSolver& solver) {
  constexpr double rounding = 1e-9;
  if (solver.min_step > (1 + rounding) * solver.step)
    fault(section.at("min_step"), "out of range: larger than step; expected a number > 0, at most step");
  if (solver.max_step < (1 - rounding) * solver.step)
    fault(section.at("max_step"), "out of range: smaller than step; expected a number, at least step");
}

const Choices<Scheme>& schemes() {
  static const Choices<Scheme> all{{{"static", Scheme::statics},
                                    {"contact_implicit", Scheme::contact_implicit},
                                    {"hht", Scheme::hht},
                                    {"newmark", Scheme::newmark}},
                                   {}};
  return all;
}

bool is_scheme(const std::string& word) {
  return std::ranges::find(schemes().now, word, &std::pair<std::string, Scheme>::first) != schemes().now.end();
}

void read_map(Section& section, ImplicitSolver& solver) {
  static const Choices<LinearSolver> linears{{{"direct", LinearSolver::direct}, {"mumps", LinearSolver::mumps}}, {}};
  section.optional("scheme", solver.scheme, schemes());
  section.optional("step", solver.step, positive);
  section.optional("tolerance", solver.tolerance, below_one);
  section.optional("linear", solver.linear, linears);
  if (section.optional("alpha", solver.alpha, to_a_third) && solver.scheme != Scheme::hht)
    fault(section.at("alpha"), "invalid without scheme: hht; expected no alpha, or scheme: hht");
  static const Choices<bool> watched{{{"warn", true}, {"ignore", false}}, {}};
  if (section.optional("stability", solver.stability, watched) && solver.scheme != Scheme::statics)
    fault(section.at("stability"), "invalid without scheme: static; expected no stability, or scheme: static");
  section.optional("min_step", solver.min_step, positive);
  section.optional("max_step", solver.max_step, positive);
}

/// Fills in defaults.
bool fill_defaults(const Input& input, ImplicitSolver& solver) {
  if (solver.step == 0 && input.run.end) solver.step = *input.run.end / default_steps;
  if (solver.min_step == 0) solver.min_step = solver.step * std::exp2(-default_halvings);
  if (solver.max_step == 0) solver.max_step = solver.step;
  return solver.step > 0;
}

}  // namespace

void read_solver(Section& scene, Input& input) {
  if (!scene.has("solver")) return;
  const Key key = scene.at("solver");
  ImplicitSolver solver;
  if (key.tree && key.tree->kind == Tree::Kind::value) {
    static const Choices<bool> words{{{"implicit", true}, {"explicit", false}}, {}};
    if (const std::string& word = key.tree->text; is_scheme(word))
      return fault(
          key,
          fmt::format("invalid value '{0}', which is a scheme; expected {{scheme: {0}}}, implicit or explicit", word));
    bool implicit = false;
    if (!read(key, implicit, words) || !implicit) return;
    if (!fill_defaults(input, solver)) {
      if (!input.run.steps) return;  // reported as a fault of `run`
      fault(key, "missing step; expected a map with step: time, or run.end, a hundredth of which is the step");
    }
    input.implicit = solver;
    return;
  }
  Section section(key, expected);
  read_map(section, solver);
  if (fill_defaults(input, solver))
    check_bounds(section, solver);
  else if (input.run.steps)
    lacking(section.key(), {"step"}, "missing step; expected step: time");
  input.implicit = solver;
}

}  // namespace brunt::scene
