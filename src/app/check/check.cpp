// SPDX-License-Identifier: Apache-2.0
// `brunt check`: the initial state of a run, without running it.
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <variant>

#include "app/program/commands.hpp"
#include "app/start/prepare.hpp"
#include "app/state/contact_setup.hpp"
#include "app/state/removal.hpp"
#include "app/whole/bodies.hpp"
#include "check_implicit.hpp"
#include "comm/exact_sum.hpp"
#include "core/error.hpp"
#include "part_extents.hpp"
#include "scene/text/units.hpp"
#include "scene_listing.hpp"
#include "smallest_motions.hpp"
#include "time/step.hpp"

namespace brunt::app {
namespace {

struct PartFigures {
  GlobalIndex elements = 0;
  double mass = 0;
};

/// Elements and mass of each block over all ranks.
std::vector<PartFigures> part_figures(const Prepared& run) {
  const std::size_t n = run.model.blocks.size();
  std::vector<comm::ExactAccumulator> sums(n);
  for (std::size_t b = 0; b < n; ++b) {
    const model::ElementBlock& block = run.model.blocks[b];
    const auto stride = static_cast<std::size_t>(block.history_size) * pack_width;
    for (LocalIndex e = 0; e < block.count; ++e)  // the mass is the first entry of an element's history
      sums[b].add(run.state.history[b][static_cast<std::size_t>(e / pack_width) * stride +
                                       static_cast<std::size_t>(e % pack_width)]);
  }
  std::vector<double> mass(n);
  comm::exact_sum(run.links.ranks, sums, mass);
  std::vector<PartFigures> figures(n);
  for (std::size_t b = 0; b < n; ++b) figures[b] = {run.model.block_size[b], mass[b]};
  for (const model::RigidBody& body : run.model.bodies) {  // a given mass is all parts' in proportion
    double elements = 0;
    for (const std::int32_t b : body.blocks) elements += nth(mass, b);
    for (const std::int32_t b : body.blocks) nth(figures, b).mass = nth(mass, b) / elements * body.own.mass;
  }
  return figures;
}

/// The cost of a step on this machine, including contact.
struct StepCost {
  double seconds = 0;
  int steps = 0;  ///< measured
};

/// Performs some steps without output; the first one (it searches and fills caches) is not timed. Collective.
StepCost measure_steps(Prepared& run, const time::StepReport& first) {
  using Clock = std::chrono::steady_clock;
  constexpr double patience = 0.5;  // s
  constexpr int most_steps = 50;
  time::advance(run.model, run.state, run.scratch, run.links, run.contact.get(), first);
  StepCost cost;
  double spent = 0;
  const Clock::time_point start = Clock::now();
  while (cost.steps < most_steps && spent < patience) {
    const time::StepReport step = time::evaluate(run.model, run.state, run.scratch, run.links, step_control(run));
    if (run.links.ranks.any(step.stop)) break;
    time::advance(run.model, run.state, run.scratch, run.links, run.contact.get(), step);
    spent = run.links.ranks.max(std::chrono::duration<double>(Clock::now() - start).count());
    ++cost.steps;
  }
  if (cost.steps > 0) cost.seconds = spent / cost.steps;
  return cost;
}

void print_parts(const Prepared& run, const std::vector<PartFigures>& figures, const scene::UnitSystem& units) {
  fmt::print("{:<16} {:<10} {:<14} {:>10} {:>14}\n", "part", "element", "material", "elements",
             "mass [" + units.mass + "]");
  for (std::size_t b = 0; b < figures.size(); ++b) {
    const model::ElementBlock& block = run.model.blocks[b];
    fmt::print("{:<16} {:<10} {:<14} {:>10} {:>14.6g}\n", block.part, element::name_of(block.kind), block.material,
               figures[b].elements, figures[b].mass);
  }
  fmt::print("nodes            {}\n", run.model.mesh.global_nodes);
}

/// "tool", or "tool with jaw, screw".
std::string parts_of(const Prepared& run, const model::RigidBody& body) {
  std::string text = body.part;
  for (std::size_t k = 1; k < body.blocks.size(); ++k)
    text += (k == 1 ? " with " : ", ") + nth(run.model.blocks, body.blocks[k]).part;
  return text;
}

/// The effective inertia of a rigid part: with the masses of deformable elements on its nodes.
void print_bodies(const Prepared& run, const scene::UnitSystem& units) {
  for (const model::RigidBody& body : run.model.bodies) {
    const rigid::MassProperties& mass = body.body.mass;
    const Vec3 centre = mass.centre + run.model.mesh.origin;
    const Mat3& J = mass.inertia;
    fmt::print(
        "rigid body       {}: mass {:.6g} {}, centre ({:.6g}, {:.6g}, {:.6g}), inertia about it xx {:.6g}, yy {:.6g}, "
        "zz {:.6g}, xy {:.6g}, yz {:.6g}, zx {:.6g}\n",
        parts_of(run, body), mass.mass, units.mass, centre[0], centre[1], centre[2], J(0, 0), J(1, 1), J(2, 2), J(0, 1),
        J(1, 2), J(2, 0));
  }
}

/// Smallest and largest coordinate of each part, and of all parts if there are several [length].
void print_extents(const Prepared& run, const std::vector<Extent>& extents, const scene::UnitSystem& units) {
  const auto line = [&](const std::string& what, const Extent& extent) {
    std::string text;
    for (std::size_t c = 0; c < 3; ++c)
      text += fmt::format("{}{} {:.6g} .. {:.6g}", c > 0 ? ", " : "", "xyz"[c], extent.low[c], extent.high[c]);
    fmt::print("extent           {}: {}{}{}\n", what, text, units.metre > 0 ? " " : "",
               units.metre > 0 ? units.length : "");
  };
  for (std::size_t b = 0; b < extents.size(); ++b) line(run.model.blocks[b].part, extents[b]);
  if (extents.size() > 1) line("all", together(extents));
}

/// The one-point hexahedron evaluates its mean deformation gradient only. Compressed to about a third of its height it
/// folds instead of storing more energy: the hourglass stiffness is calibrated for bending (src/scene/README.md,
/// parts).
void print_advice(const Prepared& run) {
  const scene::Input& input = run.input;
  const bool pressed =
      !input.contact.empty() || !input.rigid_walls.empty() || !input.prescribed.empty() || !input.pressure.empty();
  if (!pressed) return;
  for (const model::ElementBlock& block : run.model.blocks)
    if (block.kind == element::ElementKind::hex8 && std::holds_alternative<material::NeoHookean>(block.law))
      fmt::print(
          "advice           part {}: use element hex8_full if it is compressed to less than half of its height; hex8 "
          "folds at about a third of the height and is too soft beyond that\n",
          block.part);
}

/// Overlapping bodies have no smallest gap; distances elsewhere between them are not meaningful.
void print_gaps(const Prepared& run) {
  const setup::InitialGaps& gaps = run.overlaps.gaps;
  if (!gaps.overlaps.empty())
    fmt::print("deepest overlap  {} of {} node{}, listed above\n",
               scene::with_length(gaps.overlaps.front().penetration, run.input.units, 6), gaps.overlaps.size(),
               gaps.overlaps.size() == 1 ? "" : "s");
  else if (std::ranges::any_of(gaps.piercings,
                               [](const setup::Piercing& p) { return p.rule == setup::OverlapRule::warn; }))
    fmt::print("smallest gap     none: parts intersect each other, listed above\n");
  else if (!gaps.shared.empty())
    fmt::print("smallest gap     none: parts coincide, listed above\n");
  else if (gaps.smallest >= 0)
    fmt::print("smallest gap     {} between {} and {}\n", scene::with_length(gaps.smallest, run.input.units, 6),
               run.model.blocks[gaps.block].part, run.model.blocks[gaps.other_block].part);
  else if (!run.input.contact.empty())
    fmt::print("smallest gap     no two parts are closer than the edge of an element\n");
}

void print_overlaps(const scene::Input& input, const OverlapReport& report, bool all) {
  for (const std::string& line : all ? report.list : report.deepest) fmt::print("overlap          {}\n", line);
  if (report.list.empty()) return;
  for (const std::string& line : smallest_motions(input)) fmt::print("smallest motion  {}\n", line);
}

std::string friction_text(const contact::FrictionLaw& law) {
  if (!law.any()) return "no friction";
  std::string text = fmt::format("friction {:g}", law.fixed);
  if (law.kinetic != law.fixed) text += fmt::format(" to {:g}", law.kinetic);
  return law.lag == 0 ? text : text + fmt::format(", lag {:g}", law.lag);
}

/// The contact pairs and their enforcement.
void print_contact(const Prepared& run) {
  for (const scene::ContactEntry& entry : run.input.contact) {
    const std::string parts = entry.between.empty() ? "all" : entry.between[0] + " and " + entry.between[1];
    fmt::print("contact          {}: {}\n", parts, entry.tied ? "tied" : friction_text(entry.friction));
  }
  for (const scene::RigidWall& wall : run.input.rigid_walls)
    fmt::print("rigid wall       {}: {}{}{}\n", wall.name, friction_text(wall.friction),
               wall.bilateral ? ", acts in both directions" : "",
               wall.parts.empty() ? "" : fmt::format(", acts on {}", fmt::join(wall.parts, ", ")));
  for (const scene::Joint& joint : run.input.joints)
    fmt::print("joint            {}: {}, {} and {}\n", joint.name,
               joint.kind == rigid::JointKind::ball ? "ball" : "revolute", joint.between[0], joint.between[1]);
  if (!run.input.contact.empty() && !run.implicit) {
    const contact::EnforcementSettings& settings = run.input.enforcement.settings;
    fmt::print("enforcement      {}, tolerance {:g}{}\n", name_of(settings.method), settings.tolerance,
               settings.impact == contact::Impact::elastic ? ", elastic impacts" : "");
  }
}

void print_cost(const Prepared& run, const time::StepReport& step, const StepCost& cost,
                const scene::UnitSystem& units) {
  const scene::Run& limits = run.input.run;
  fmt::print("first step       {:.6g} {} (cfl {:g})\n", step.dt, units.time, limits.cfl);
  double steps = std::numeric_limits<double>::infinity();
  if (limits.end) steps = std::ceil(*limits.end / step.dt);
  if (limits.steps) steps = std::min(steps, static_cast<double>(*limits.steps));
  const std::string count = steps < 1e15 ? fmt::format("{:.0f}", steps) : fmt::format("{:.3g}", steps);
  fmt::print("steps            about {} of that size\n", count);
  if (cost.steps == 0) return;
  const int ranks = run.links.ranks.size();
  const auto elements = static_cast<double>(run.model.mesh.global_elements);
  fmt::print(
      "estimated cost   {} on {} rank{} without output ({:.0f} ns per element, step and rank, measured in {} steps)\n",
      duration_text(steps * cost.seconds), ranks, ranks == 1 ? "" : "s", cost.seconds * 1e9 * ranks / elements,
      cost.steps);
}

}  // namespace

int check(const comm::Communicator& ranks, const CheckOptions& options) {
  const std::unique_ptr<Prepared> run = prepare(ranks, options.scene, options.overrides);
  const OverlapReport& report = run->overlaps.report;  // on the root
  if (ranks.is_root() && !report.faults.empty()) print_overlaps(run->input, report, options.all);
  refuse_overlaps(*run);
  demand_first_step(*run);
  const std::vector<PartFigures> figures = part_figures(*run);
  const std::vector<std::string> listing = list_scene(*run);
  const std::vector<Extent> extents = part_extents(*run);
  const time::StepReport step = time::evaluate(run->model, run->state, run->scratch, run->links, step_control(*run));
  if (ranks.any(step.stop))
    throw InputError(options.scene +
                     ": invalid mesh: an element has no volume in its initial position; expected positive volumes");
  const scene::UnitSystem& units = *scene::find_unit_system(run->input.units);
  const std::vector<std::string> implicit =
      run->implicit ? implicit_check(*run, units.time) : std::vector<std::string>{};
  const StepCost cost = run->implicit ? StepCost{} : measure_steps(*run, step);
  if (!ranks.is_root()) return 0;

  fmt::print("{} ({} units)\n", run->input.title.empty() ? options.scene : run->input.title, run->input.units);
  const RoundBodies round = round_bodies(run->input);
  for (const std::string& warning : run->warnings) fmt::print("warning: {}\n", warning);
  for (const std::string& warning : round.warnings) fmt::print("warning: {}\n", warning);
  for (const std::string& line : run->left_out) fmt::print("{}\n", line);
  for (const std::string& note : report.notes) fmt::print("{}\n", note);
  print_overlaps(run->input, report, options.all);
  print_parts(*run, figures, units);
  print_bodies(*run, units);
  print_extents(*run, extents, units);
  print_advice(*run);
  for (const std::string& line : round.lines) fmt::print("{:<16} {}\n", "round body", line);
  for (const std::string& line : listing) fmt::print("{}\n", line);
  print_contact(*run);
  print_gaps(*run);
  for (const std::string& line : implicit) fmt::print("{}\n", line);
  if (!run->implicit) print_cost(*run, step, cost, units);
  return 0;
}

}  // namespace brunt::app
