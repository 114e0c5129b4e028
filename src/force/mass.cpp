// SPDX-License-Identifier: Apache-2.0
#include "force/mass.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "core/cells.hpp"
#include "core/error.hpp"
#include "element/hex8_modes.hpp"
#include "element/rotary_inertia.hpp"
#include "element/shell_batch.hpp"

namespace brunt::force {
namespace {

double tetrahedron_volume(const Quad& a, const Quad& b, const Quad& c, const Quad& d) {
  const Quad p = b - a, q = c - a, r = d - a;
  return (p[0] * (q[1] * r[2] - q[2] * r[1]) + p[1] * (q[2] * r[0] - q[0] * r[2]) +
          p[2] * (q[0] * r[1] - q[1] * r[0])) /
         6.0;
}

/// Of a quadrilateral: the length of its area vector, half the cross product of its diagonals.
double shell_area(const model::ElementBlock& block, const Quad* reference, LocalIndex element) {
  const auto corner = [&](int c) -> const Quad& { return reference[block.corner_node(element, c)]; };
  const bool triangle = block.corners() == 3;
  const Quad a = triangle ? corner(1) - corner(0) : corner(2) - corner(0);
  const Quad b = triangle ? corner(2) - corner(0) : corner(3) - corner(1);
  return 0.5 * std::hypot(a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]);
}

template <int nodes>
Pack batch_inertia(const model::ElementBlock& block, const Quad* reference, LocalIndex batch, Pack mass) {
  Pack x[3][nodes];
  const LocalIndex* node = block.node.data() + std::ptrdiff_t{batch} * nodes * pack_width;
  for (int c = 0; c < nodes; ++c)
    components_of([&](int lane) { return reference[node[c * pack_width + lane]]; }, x[0][c], x[1][c], x[2][c]);
  const material::ElasticModuli moduli = material::initial_moduli(block.law);
  return element::rotary_inertia_of(x, mass, block.section, moduli.lambda, moduli.mu);
}

}  // namespace

double element_volume(const model::ElementBlock& block, const Quad* reference, LocalIndex element) {
  const auto corner = [&](int c) -> const Quad& { return reference[block.corner_node(element, c)]; };
  if (cells::is_surface(block.shape)) return block.section.thickness * shell_area(block, reference, element);
  if (block.shape == cells::Shape::tet4) return tetrahedron_volume(corner(0), corner(1), corner(2), corner(3));
  Pack mode[element::hex_modes][3], g[6][3];
  for (int i = 0; i < 3; ++i) {
    Pack X[8], of_component[element::hex_modes];
    for (int c = 0; c < 8; ++c) X[c] = broadcast(corner(c)[i]);
    element::to_modes(X, of_component);
    for (int m = 0; m < element::hex_modes; ++m) mode[m][i] = of_component[m];
  }
  return element::gradient_modes(mode, g)[0];
}

void lump_mass(const model::Model& model, model::State& state, model::Scratch& scratch, Lumped elements) {
  std::fill(scratch.force.begin(), scratch.force.end(), Quad{});
  Quad* slots = reinterpret_cast<Quad*>(scratch.slots.data());
  for (std::size_t b = 0; b < model.blocks.size(); ++b) {
    const model::ElementBlock& block = model.blocks[b];
    const bool at_nodes = elements == Lumped::all || !material::is_rigid(block.law);
    const double density = material::initial_moduli(block.law).density;
    double* history = state.history[b].data();
    for (LocalIndex batch = 0; batch < block.batches(); ++batch) {
      double corner_mass[pack_width];
      for (int lane = 0; lane < pack_width; ++lane) {
        const LocalIndex element = std::min(batch * pack_width + lane, block.count - 1);
        const double volume = element_volume(block, model.reference.data(), element);
        if (!(volume > 0))
          throw GuardError(
              fmt::format("part {}: an element has volume {:g} in the reference configuration", block.part, volume));
        const double mass = density * volume;
        history[static_cast<std::ptrdiff_t>(batch) * block.history_size * pack_width + lane] = mass;
        corner_mass[lane] = at_nodes ? mass / block.corners() : 0;
      }
      const int lanes = std::min(pack_width, block.count - batch * pack_width);
      for (int lane = 0; lane < lanes; ++lane)
        for (int c = 0; c < block.corners(); ++c)
          nth(scratch.force, block.corner_node(batch * pack_width + lane, c)) += Quad{corner_mass[lane]};
      for (const model::BorderCorner& kept : block.border.row(batch)) slots[kept.slot] = Quad{corner_mass[kept.lane]};
    }
  }
}

void lump_rotary_inertia(const model::Model& model, model::State& state, model::Scratch& scratch) {
  std::fill(scratch.moment.begin(), scratch.moment.end(), Quad{});
  Quad* slots = reinterpret_cast<Quad*>(scratch.moment_slots.data());
  for (std::size_t b = 0; b < model.blocks.size(); ++b) {
    const model::ElementBlock& block = model.blocks[b];
    if (!block.turns()) continue;
    auto* history = reinterpret_cast<Pack*>(state.history[b].data());
    for (LocalIndex batch = 0; batch < block.batches(); ++batch) {
      Pack* memory = history + std::ptrdiff_t{batch} * block.history_size;
      const Pack mass = memory[element::at_shell_mass];
      const Pack inertia = block.corners() == 3 ? batch_inertia<3>(block, model.reference.data(), batch, mass)
                                                : batch_inertia<4>(block, model.reference.data(), batch, mass);
      memory[element::at_rotary_inertia] = inertia;
      const Pack share = inertia * (1.0 / block.corners());
      const int lanes = std::min(pack_width, block.count - batch * pack_width);
      for (int lane = 0; lane < lanes; ++lane)
        for (int c = 0; c < block.corners(); ++c)
          nth(scratch.moment, block.corner_node(batch * pack_width + lane, c)) += Quad{share[lane]};
      for (const model::BorderCorner& kept : block.border.row(batch)) slots[kept.slot] = Quad{share[kept.lane]};
    }
  }
}

}  // namespace brunt::force
