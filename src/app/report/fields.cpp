// SPDX-License-Identifier: Apache-2.0
#include "fields.hpp"

#include <algorithm>
#include <cmath>

#include "implicit/solver.hpp"
#include "model/alive.hpp"
#include "shell_stress.hpp"

namespace brunt::app {
namespace {

io::StateField nodal(const Prepared& run, const std::string& name, int components, auto&& value_of) {
  io::StateField field{name, io::Place::node, components, {}};
  field.values.reserve(run.model.owned.size() * static_cast<std::size_t>(components));
  for (const LocalIndex node : run.model.owned)
    for (int c = 0; c < components; ++c) field.values.push_back(value_of(static_cast<std::size_t>(node), c));
  return field;
}

/// A history range as an element field; where an element has several points, their mean. Zero for blocks without it.
io::StateField elemental(const Prepared& run, const std::string& name, int components) {
  io::StateField field{name, io::Place::element, components, {}};
  for (std::size_t b = 0; b < run.model.blocks.size(); ++b) {
    const model::ElementBlock& block = run.model.blocks[b];
    const model::HistoryRange* range = block.find(name);
    const int points = range ? std::max(1, range->components / components) : 0;
    for (LocalIndex e = 0; e < block.count; ++e)
      for (int c = 0; c < components; ++c) {
        double sum = 0;
        for (int p = 0; p < points; ++p) {
          const auto position =
              static_cast<std::size_t>(e / pack_width) * static_cast<std::size_t>(block.history_size) +
              static_cast<std::size_t>(range->first + p * components + c);
          sum += run.state.history[b][position * pack_width + static_cast<std::size_t>(e % pack_width)];
        }
        field.values.push_back(points > 0 ? sum / points : 0.0);
      }
  }
  return field;
}

/// Of solid elements the mean over their points, at any height.
io::StateField stresses(const Prepared& run, const std::string& name, ShellHeight height) {
  io::StateField field = elemental(run, "stress", 6);
  field.name = name;
  std::size_t at = 0;
  for (std::size_t b = 0; b < run.model.blocks.size(); ++b) {
    const model::ElementBlock& block = run.model.blocks[b];
    for (LocalIndex e = 0; e < block.count; ++e, at += 6)
      if (element::is_shell(block.kind)) std::ranges::copy(shell_stress(run, block, b, e, height), &field.values[at]);
  }
  return field;
}

io::StateField mises(const Prepared& run) {
  const io::StateField stress = stresses(run, "stress", ShellHeight::middle);
  io::StateField field{"mises", io::Place::element, 1, {}};
  for (std::size_t k = 0; k + 5 < stress.values.size(); k += 6) {
    const double* s = &stress.values[k];
    const double a = s[0] - s[1], b = s[1] - s[2], c = s[2] - s[0];
    field.values.push_back(std::sqrt(0.5 * (a * a + b * b + c * c) + 3 * (s[3] * s[3] + s[4] * s[4] + s[5] * s[5])));
  }
  return field;
}

/// 1, or 0 for removed elements, which pictures omit.
io::StateField alive(const Prepared& run) {
  io::StateField field{"alive", io::Place::element, 1, {}};
  for (std::size_t b = 0; b < run.model.blocks.size(); ++b)
    for (LocalIndex e = 0; e < run.model.blocks[b].count; ++e)
      field.values.push_back(model::lives(run.state, b, e) ? 1.0 : 0.0);
  return field;
}

bool is_contact_field(const std::string& name) {
  return name == "contact_pressure" || name == "gap";
}

}  // namespace

std::vector<io::StateField> state_fields(const Prepared& run) {
  std::vector<io::StateField> fields;
  for (const std::string& name : run.input.output.fields) {
    if (is_contact_field(name)) continue;
    if (name == "displacement")
      fields.push_back(nodal(run, name, 3, [&](std::size_t i, int c) { return run.state.displacement[i][c]; }));
    else if (name == "velocity")
      fields.push_back(nodal(run, name, 3, [&](std::size_t i, int c) { return run.state.nodes[i].v[c]; }));
    else if (name == "mass")
      fields.push_back(nodal(run, name, 1, [&](std::size_t i, int) { return run.state.nodes[i].mass; }));
    else if (name == "mises")
      fields.push_back(mises(run));
    else if (name == "stress")
      fields.push_back(stresses(run, name, ShellHeight::middle));
    else if (name == "stress_bottom")
      fields.push_back(stresses(run, name, ShellHeight::bottom));
    else if (name == "stress_top")
      fields.push_back(stresses(run, name, ShellHeight::top));
    else
      fields.push_back(elemental(run, name, 1));
  }
  if (run.model.loses_elements()) fields.push_back(alive(run));
  return fields;
}

std::vector<io::StateField> contact_fields(const Prepared& run, double dt_mean) {
  std::vector<io::StateField> fields;
  for (const std::string& name : run.input.output.fields)
    if (is_contact_field(name)) {
      std::vector<double> values;  // empty without contact: zero everywhere
      if (run.implicit)
        values = name == "gap" ? implicit::contact_gaps(run.implicit->contact, run.model.nodes())
                               : implicit::contact_pressures(run.implicit->contact, run.model.nodes());
      else if (run.contact)
        values = name == "gap" ? contact::gaps(*run.contact) : contact::pressures(*run.contact, dt_mean);
      fields.push_back(nodal(run, name, 1, [&](std::size_t i, int) { return i < values.size() ? values[i] : 0.0; }));
    }
  return fields;
}

}  // namespace brunt::app
