// SPDX-License-Identifier: Apache-2.0
#include "shell_stress.hpp"

#include <cmath>

#include "element/shell_frame.hpp"

namespace brunt::app {
namespace {

/// The axes of one point in the plane of an element, as rows.
using Axes = Mat3;

Axes axes_of(const Vec3& a, const Vec3& b) {
  Pack first[3], second[3];
  for (int i = 0; i < 3; ++i) {
    first[i] = broadcast(a[i]);
    second[i] = broadcast(b[i]);
  }
  const element::ShellTangents tangents(first, second);
  Axes axes;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) axes(i, j) = tangents.axes.e[i][j][0];
  return axes;
}

/// Tangents as the kernels of the elements have them: of the square [-1, 1]^2 at a point (shell4: its centre;
/// shell4_full: counter-clockwise from (-, -)), and of the equilateral triangle of edge 1.
Axes axes_of_point(const std::array<Vec3, 4>& x, element::ElementKind kind, int point) {
  if (kind == element::ElementKind::shell3) return axes_of(x[1] - x[0], (2 * x[2] - x[0] - x[1]) / std::sqrt(3.0));
  const double at = kind == element::ElementKind::shell4_full ? 1 / std::sqrt(3.0) : 0.0;
  const double xi = point == 1 || point == 2 ? at : -at, eta = point > 1 ? at : -at;
  const Vec3 a = 0.25 * (x[1] + x[2] - x[0] - x[3]), b = 0.25 * (x[2] + x[3] - x[0] - x[1]);
  const Vec3 both = 0.25 * (x[0] + x[2] - x[1] - x[3]);
  return axes_of(a + eta * both, b + xi * both);
}

}  // namespace

std::array<double, 6> shell_stress(const Prepared& run, const model::ElementBlock& block, std::size_t b, LocalIndex e,
                                   ShellHeight height) {
  std::array<double, 6> result{};
  const model::HistoryRange* range = block.find("local_stress");
  if (range == nullptr) return result;
  constexpr int components = 5;  // xx, yy, xy, yz, zx
  const int layers = block.section.points, fibres = range->components / (components * layers);
  const auto stored = [&](int position) {
    const auto row = static_cast<std::size_t>(e / pack_width) * static_cast<std::size_t>(block.history_size) +
                     static_cast<std::size_t>(range->first + position);
    return run.state.history[b][row * pack_width + static_cast<std::size_t>(e % pack_width)];
  };
  std::array<Vec3, 4> x;
  for (int c = 0; c < block.corners(); ++c) {
    const auto node = static_cast<std::size_t>(block.corner_node(e, c));
    for (int i = 0; i < 3; ++i) nth(x, c)[i] = run.model.reference[node][i] + run.state.displacement[node][i];
  }
  const int low = height == ShellHeight::bottom ? 0 : height == ShellHeight::top ? layers - 1 : (layers - 1) / 2;
  const int high = height == ShellHeight::middle ? layers / 2 : low;
  Mat3 sum = Mat3::Zero();
  for (int fibre = 0; fibre < fibres; ++fibre) {
    std::array<double, components> s{};
    for (int k = 0; k < components; ++k)
      nth(s, k) =
          0.5 * (stored(components * (fibre * layers + low) + k) + stored(components * (fibre * layers + high) + k));
    Mat3 local;
    local << s[0], s[2], s[4],  //
        s[2], s[1], s[3],       //
        s[4], s[3], 0;
    const Axes axes = axes_of_point(x, block.kind, fibre);
    sum += axes.transpose() * local * axes;
  }
  sum /= fibres;
  return {sum(0, 0), sum(1, 1), sum(2, 2), sum(0, 1), sum(1, 2), sum(2, 0)};
}

}  // namespace brunt::app
