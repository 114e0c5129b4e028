// SPDX-License-Identifier: Apache-2.0
// `brunt check`: what a run would start from, without running it.
#include <fmt/format.h>

#include <array>
#include <cmath>

#include "brunt/comm/exact_sum.hpp"
#include "brunt/core/error.hpp"
#include "brunt/scene/units.hpp"
#include "brunt/time/step.hpp"
#include "commands.hpp"
#include "prepare.hpp"

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
  return figures;
}

}  // namespace

int check(const comm::Communicator& ranks, const CheckOptions& options) {
  const std::unique_ptr<Prepared> run = prepare(ranks, options.scene, options.overrides);
  const std::vector<PartFigures> figures = part_figures(*run);
  const time::StepReport step =
      time::evaluate(run->model, run->state, run->scratch, run->links, {run->input.run.cfl, 1.02});
  const GlobalIndex inverted = ranks.max(GlobalIndex{step.stop ? 1 : 0});
  if (inverted) throw InputError(options.scene + ": an element has no volume in its initial position");
  if (!ranks.is_root()) return 0;

  const scene::UnitSystem& units = *scene::find_unit_system(run->input.units);
  fmt::print("{} ({} units)\n", run->input.title.empty() ? options.scene : run->input.title, run->input.units);
  for (const std::string& warning : run->warnings) fmt::print("warning: {}\n", warning);
  fmt::print("{:<16} {:<10} {:<14} {:>10} {:>14}\n", "part", "element", "material", "elements",
             "mass [" + units.mass + "]");
  for (std::size_t b = 0; b < figures.size(); ++b) {
    const model::ElementBlock& block = run->model.blocks[b];
    fmt::print("{:<16} {:<10} {:<14} {:>10} {:>14.6g}\n", block.part, element::name_of(block.kind), block.material,
               figures[b].elements, figures[b].mass);
  }
  fmt::print("nodes            {}\n", run->model.mesh.global_nodes);
  if (const InitialGaps& gaps = run->gaps; gaps.smallest >= 0)
    fmt::print("smallest gap     {:.6g} {} between {} and {}\n", gaps.smallest, units.length,
               run->input.parts[gaps.part].name, run->input.parts[gaps.other].name);
  else if (!run->input.contact.empty())
    fmt::print("smallest gap     no two parts are nearer than an element's edge\n");
  fmt::print("first step       {:.6g} {} (cfl {:g})\n", step.dt, units.time, run->input.run.cfl);
  double steps = run->input.run.steps ? static_cast<double>(*run->input.run.steps) : 0;
  if (run->input.run.end) steps = std::ceil(*run->input.run.end / step.dt);
  constexpr double seconds_per_element_step = 1e-7;  // of one core, with the files; a guess before the run
  fmt::print("steps            about {:.0f}, {:.3g} s on one core\n", steps,
             steps * static_cast<double>(run->model.mesh.global_elements) * seconds_per_element_step);
  return 0;
}

}  // namespace brunt::app
