// SPDX-License-Identifier: Apache-2.0
// One shell element outside of any mesh: moved as a test likes, its forces, moments and stiffness looked at.
#pragma once
#include <random>
#include <vector>

#include "element/shell3.hpp"
#include "element/shell4_step.hpp"
#include "element/shell_batch.hpp"
#include "support/element_bench.hpp"

namespace brunt::test {

/// Corners and rates, forces and moments: one column a corner.
template <class Kernel>
struct ShellBench {
  using KernelType = Kernel;
  static constexpr int nodes = Kernel::nodes;
  using Field = Eigen::Matrix<double, 3, nodes>;
  using Matrix6 = Eigen::Matrix<double, 6 * nodes, 6 * nodes>;

  struct Answer {
    Field force, moment;  ///< minus the internal ones
    double rate, volume;
  };

  ShellBench(const Kernel& kernel_, const Field& X, double mass_) : kernel(kernel_), mass(mass_) {
    for (const auto& field : kernel.history())
      for (int c = 0; c < field.components; ++c) history.push_back(broadcast(field.start));
    Pack x[3][nodes];
    for (int i = 0; i < 3; ++i)
      for (int c = 0; c < nodes; ++c) x[i][c] = broadcast(X(i, c));
    history[element::at_shell_mass] = broadcast(mass);
    const element::ShellSection& section = kernel.section;
    history[element::at_rotary_inertia] = element::rotary_inertia(x, broadcast(mass), broadcast(section.thickness),
                                                                  section.offset, kernel.law.lambda, kernel.law.mu);
  }
  [[nodiscard]] double inertia() const { return history[element::at_rotary_inertia][0]; }

  /// Moves the corners to x over dt with the mean velocity v, and turns them at the rate r.
  Answer move(const Field& x, const Field& v, const Field& r, double dt = 1) {
    element::ShellMotion<nodes> motion;
    motion.dt = dt;
    for (int i = 0; i < 3; ++i)
      for (int c = 0; c < nodes; ++c) {
        motion.x[i][c] = broadcast(x(i, c));
        motion.v[i][c] = broadcast(v(i, c));
        motion.r[i][c] = broadcast(r(i, c));
      }
    element::ShellForce<nodes> out;
    kernel(motion, history.data(), history.data(), out);
    Answer answer{{}, {}, out.rate[0], out.volume[0]};
    for (int i = 0; i < 3; ++i)
      for (int c = 0; c < nodes; ++c) {
        answer.force(i, c) = out.f[i][c][0];
        answer.moment(i, c) = out.m[i][c][0];
      }
    return answer;
  }
  Answer rest(const Field& x) { return move(x, Field::Zero(), Field::Zero(), 0); }

  /// - d (force, moment) / d (displacement, rotation) at x by central differences; leaves the state as it is. Unknowns:
  /// displacements of the corners one after the other, then rotations.
  [[nodiscard]] Matrix6 stiffness(const Field& x, double step = 1e-6) const {
    Matrix6 K;
    for (int c = 0; c < 6 * nodes; ++c) {
      Field shift[2] = {Field::Zero(), Field::Zero()};
      shift[c / (3 * nodes)].data()[c % (3 * nodes)] = step;
      ShellBench plus = *this, minus = *this;
      const Answer a = minus.move(x - shift[0], -shift[0], -shift[1]), b = plus.move(x + shift[0], shift[0], shift[1]);
      for (int k = 0; k < 3 * nodes; ++k) {
        K(k, c) = (a.force.data()[k] - b.force.data()[k]) / (2 * step);
        K(3 * nodes + k, c) = (a.moment.data()[k] - b.moment.data()[k]) / (2 * step);
      }
    }
    return K;
  }

  /// M^-1/2 K M^-1/2 with the lumped mass.
  [[nodiscard]] Matrix6 reduced(const Matrix6& K) const {
    Eigen::Matrix<double, 6 * nodes, 1> scale;
    scale.template head<3 * nodes>().setConstant(1 / std::sqrt(mass / nodes));
    scale.template tail<3 * nodes>().setConstant(1 / std::sqrt(inertia() / nodes));
    return scale.asDiagonal() * K * scale.asDiagonal();
  }

  /// Of the flat element with these corners.
  [[nodiscard]] static double area(const Field& x) {
    const Eigen::Vector3d a = x.col(2) - x.col(0), b = x.col(nodes - 1) - x.col(1), c = x.col(1) - x.col(0);
    return 0.5 * (nodes == 4 ? a.cross(b) : c.cross(a)).norm();
  }

  Kernel kernel;
  double mass;
  std::vector<Pack> history;
};

}  // namespace brunt::test
