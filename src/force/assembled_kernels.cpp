// SPDX-License-Identifier: Apache-2.0
// Forces of linear elements: a reduced kernel, since a bound of the step needs tens of products with the whole mesh.
#include "block_loop.hpp"
#include "core/cells.hpp"
#include "element/hex8.hpp"
#include "element/tet4.hpp"
#include "force/assembled.hpp"

namespace brunt::force {
namespace {

/// s = lambda tr(L) 1 + 2 mu sym(L), row major.
BRUNT_INLINE void linear_stress(const Pack (&L)[9], Pack lambda, Pack mu, Pack (&s)[9]) {
  const Pack pressure = lambda * (L[0] + L[4] + L[8]);
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) s[3 * i + j] = mu * (L[3 * i + j] + L[3 * j + i]);
  for (int i = 0; i < 3; ++i) s[4 * i] += pressure;
}

/// One point with springs on the hourglass modes: see element/hex8.hpp.
struct LinearHex {
  static constexpr int nodes = 8;

  BRUNT_INLINE void operator()(const element::BatchMotion<8>& in, const Pack* linear, Pack (&f)[3][8]) const {
    using element::hex_modes;
    Pack x[hex_modes][3], v[hex_modes][3], g[6][3], L[9], s[9], Q[4][3];
    element::vector_modes(in.x, x);
    element::vector_modes(in.v, v);
    const Pack over_volume = 1.0 / element::gradient_modes(x, g);
    element::mean_gradient(v, g, over_volume, L);
    linear_stress(L, linear[at_lambda], linear[at_mu], s);
    for (int a = 0; a < 4; ++a) {
      const auto& h = x[3 + a];
      for (int i = 0; i < 3; ++i)
        Q[a][i] = linear[at_spring] * (v[3 + a][i] - (L[3 * i] * h[0] + L[3 * i + 1] * h[1] + L[3 * i + 2] * h[2]));
    }
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j) {
        Pack sum = Q[0][i] * x[3][j];
        for (int a = 1; a < 4; ++a) sum += Q[a][i] * x[3 + a][j];
        s[3 * i + j] -= over_volume * sum;
      }
    for (int i = 0; i < 3; ++i) {
      Pack force[hex_modes];
      for (int m = 0; m < 6; ++m) force[m] = -(s[3 * i] * g[m][0] + s[3 * i + 1] * g[m][1] + s[3 * i + 2] * g[m][2]);
      force[6] = broadcast(0.0);
      for (int a = 0; a < 4; ++a) force[3 + a] -= Q[a][i];
      element::from_modes(force, f[i]);
    }
  }
};

struct LinearTet {
  static constexpr int nodes = 4;

  BRUNT_INLINE void operator()(const element::BatchMotion<4>& in, const Pack* linear, Pack (&f)[3][4]) const {
    Pack x[3][3], v[3][3], B[3][3], L[9], s[9];
    element::tet4_detail::edges(in.x, x);
    element::tet4_detail::edges(in.v, v);
    const Pack volume = element::tet4_detail::gradients(x, B);
    element::tet4_detail::gradient(v, B, volume, L);
    linear_stress(L, linear[at_lambda], linear[at_mu], s);
    for (int i = 0; i < 3; ++i) {
      for (int k = 0; k < 3; ++k) f[i][k + 1] = -(s[3 * i] * B[k][0] + s[3 * i + 1] * B[k][1] + s[3 * i + 2] * B[k][2]);
      f[i][0] = -(f[i][1] + f[i][2] + f[i][3]);
    }
  }
};

/// Shells are replaced by springs from each corner to the ground, of the largest frequency of the free element: a bound
/// for any motion of its corners, rotations included.
template <int corners>
struct LinearShell {
  static constexpr int nodes = corners;

  BRUNT_INLINE void operator()(const element::BatchMotion<corners>& in, const Pack* linear,
                               Pack (&f)[3][corners]) const {
    for (int i = 0; i < 3; ++i)
      for (int c = 0; c < corners; ++c) f[i][c] = -linear[at_spring] * in.v[i][c];
  }
};

template <class Kernel>
void run_linear(const model::ElementBlock& block, const Pack* linear, std::span<const std::uint8_t> of_block,
                const LinearMotion& moved) {
  constexpr int nodes = Kernel::nodes;
  element::BatchMotion<nodes> motion;
  Pack f[3][nodes];
  Quad* slots = reinterpret_cast<Quad*>(moved.slots.data());
  for (LocalIndex batch = 0; batch < block.batches(); ++batch) {
    const LocalIndex* node = block.node.data() + static_cast<std::ptrdiff_t>(batch) * nodes * pack_width;
    const std::uint8_t living = living_lanes(of_block, batch);
    if (living == 0) {
      for (const model::BorderCorner& corner : block.border.row(batch)) slots[corner.slot] = Quad{};
      continue;
    }
    gather_motion<nodes>(node, moved.nodes.data(), motion);
    Kernel{}(motion, linear + std::ptrdiff_t{batch} * linear_entries, f);
    const int lanes = std::min(pack_width, block.count - batch * pack_width);
    scatter_forces<nodes>(node, lanes, living, f, block.border.row(batch), moved.force.data(), slots);
  }
}

}  // namespace

void linear_forces(const model::Model& model, const LinearElements& linear, const LinearMotion& motion) {
  std::fill(motion.force.begin(), motion.force.end(), Quad{});
  for (std::size_t b = 0; b < model.blocks.size(); ++b) {
    const model::ElementBlock& block = model.blocks[b];
    if (block.count == 0 || material::is_rigid(block.law)) continue;
    const auto* entries = reinterpret_cast<const Pack*>(linear[b].data());
    const std::span<const std::uint8_t> living = lanes_of(motion.living, static_cast<LocalIndex>(b));
    switch (block.shape) {
      case cells::Shape::hex8:
        run_linear<LinearHex>(block, entries, living, motion);
        break;
      case cells::Shape::tet4:
        run_linear<LinearTet>(block, entries, living, motion);
        break;
      case cells::Shape::quad4:
        run_linear<LinearShell<4>>(block, entries, living, motion);
        break;
      case cells::Shape::tri3:
        run_linear<LinearShell<3>>(block, entries, living, motion);
        break;
    }
  }
}

}  // namespace brunt::force
