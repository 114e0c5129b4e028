// SPDX-License-Identifier: Apache-2.0
#include "force/mass.hpp"

#include <fmt/core.h>

#include <algorithm>

#include "core/cells.hpp"
#include "core/error.hpp"
#include "element/hex8_modes.hpp"

namespace brunt::force {
namespace {

double tetrahedron_volume(const Quad& a, const Quad& b, const Quad& c, const Quad& d) {
  const Quad p = b - a, q = c - a, r = d - a;
  return (p[0] * (q[1] * r[2] - q[2] * r[1]) + p[1] * (q[2] * r[0] - q[0] * r[2]) +
          p[2] * (q[0] * r[1] - q[1] * r[0])) /
         6.0;
}

}  // namespace

double element_volume(const model::ElementBlock& block, const Quad* reference, LocalIndex element) {
  const auto corner = [&](int c) -> const Quad& { return reference[block.corner_node(element, c)]; };
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

}  // namespace brunt::force
