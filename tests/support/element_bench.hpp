// SPDX-License-Identifier: Apache-2.0
// One element outside of any mesh: moved as a test likes, its forces and stiffness looked at.
#pragma once
#include <vector>

#include "element/batch.hpp"
#include "support/eigenvalues.hpp"
#include "support/material_point.hpp"

namespace brunt::test {

template <int nodes>
using Corners = Eigen::Matrix<double, 3, nodes>;
template <int nodes>
using Stiffness = Eigen::Matrix<double, 3 * nodes, 3 * nodes>;

[[nodiscard]] Corners<8> unit_cube();
/// A cube with its corners moved by at most `size` along each axis.
[[nodiscard]] Corners<8> distorted_cube(std::mt19937& engine, double size);

template <class Kernel>
struct ElementBench {
  static constexpr int nodes = Kernel::nodes;
  using Positions = Corners<nodes>;

  struct Answer {
    Positions force;  ///< minus the internal force
    double rate, volume;
  };

  ElementBench(const Kernel& kernel_, const Positions& X_, double mass)
      : kernel(kernel_), X(X_), history(Kernel::history_size, Pack{}) {
    history[Kernel::Memory::at_mass] = broadcast(mass);
  }

  /// Moves the corners to x over dt with the velocity (x - before) / dt.
  Answer move(const Positions& before, const Positions& x, double dt = 1) {
    element::BatchMotion<nodes> motion;
    motion.dt = dt;
    for (int i = 0; i < 3; ++i)
      for (int c = 0; c < nodes; ++c) {
        motion.x[i][c] = broadcast(x(i, c));
        motion.v[i][c] = broadcast((x(i, c) - before(i, c)) / dt);
        motion.X[i][c] = broadcast(X(i, c));
      }
    element::BatchForce<nodes> out;
    kernel(motion, history.data(), history.data(), out);
    Answer answer{{}, out.rate[0], out.volume[0]};
    for (int i = 0; i < 3; ++i)
      for (int c = 0; c < nodes; ++c) answer.force(i, c) = out.f[i][c][0];
    return answer;
  }

  /// -d force / d x at the state reached, by central differences; leaves the state as it is.
  Stiffness<nodes> stiffness(const Positions& x, double step = 1e-6) const {
    Stiffness<nodes> K;
    for (int c = 0; c < 3 * nodes; ++c) {
      Positions shift = Positions::Zero();
      shift.data()[c] = step;
      ElementBench plus = *this, minus = *this;
      const Positions difference = minus.move(x, x - shift).force - plus.move(x, x + shift).force;
      K.col(c) = Eigen::Map<const Eigen::Matrix<double, 3 * nodes, 1>>(difference.data()) / (2 * step);
    }
    return K;
  }

  Matrix stress(int point = 0) const { return symmetric_matrix(&history[Kernel::Memory::at_stress + 6 * point]); }
  void set_stress(const Matrix& s, int point = 0) {
    Pack packs[6];
    set_symmetric(s, packs);
    for (int c = 0; c < 6; ++c) history[static_cast<std::size_t>(Kernel::Memory::at_stress + 6 * point + c)] = packs[c];
  }

  Kernel kernel;
  Positions X;
  std::vector<Pack> history;
};

}  // namespace brunt::test
