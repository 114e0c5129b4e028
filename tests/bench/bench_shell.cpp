// SPDX-License-Identifier: Apache-2.0
// Nanoseconds of one core for an element-step of the shells beside the one-point hexahedron: the kernels alone, on one
// batch that stays in cache.
#include <fmt/core.h>

#include <algorithm>
#include <chrono>
#include <vector>

#include "element/hex8.hpp"
#include "element/shell3.hpp"
#include "element/shell4.hpp"
#include "element/shell4_full.hpp"
#include "material/elastic.hpp"
#include "material/j2.hpp"
#include "material/metal.hpp"

using namespace brunt;
using element::HourglassKind;

namespace {

/// Best of many short repeats, which finds a moment without other load.
template <class Work>
double nanoseconds(const Work& work) {
  using Clock = std::chrono::steady_clock;
  constexpr int count = 300;
  double best = 1e300;
  for (int repeat = 0; repeat < 3000; ++repeat) {
    const Clock::time_point start = Clock::now();
    for (int i = 0; i < count; ++i) work();
    best = std::min(best, std::chrono::duration<double>(Clock::now() - start).count());
  }
  return 1e9 * best / (count * pack_width);
}

template <class Kernel>
double shell(const Kernel& kernel, double velocity) {
  constexpr double corner[4][3] = {{0, 0, 0}, {1, 0, 0.01}, {1.1, 1, 0}, {0, 1, 0.01}};
  element::ShellMotion<Kernel::nodes> in;
  in.dt = 1e-8;
  for (int c = 0; c < Kernel::nodes; ++c)
    for (int i = 0; i < 3; ++i) {
      in.x[i][c] = broadcast(corner[c][i]);
      in.v[i][c] = broadcast(velocity * ((c * 7 + i * 3) % 5 - 2));
      in.r[i][c] = broadcast(velocity * ((c * 5 + i * 2) % 7 - 3));
    }
  std::vector<Pack> history;
  for (const auto& field : kernel.history())
    history.insert(history.end(), std::size_t(field.components), broadcast(field.start));
  history[element::at_shell_mass] = broadcast(800.0);
  history[element::at_rotary_inertia] = broadcast(60.0);
  element::ShellForce<Kernel::nodes> out;
  return nanoseconds([&] {
    kernel(in, history.data(), history.data(), out);
    asm volatile("" : : "r"(&out), "r"(&in) : "memory");
  });
}

double hexahedron() {
  const material::ElasticResponse law({8000, 2e11, 0.3});
  const element::Hex8<material::ElasticResponse, HourglassKind::stiffness> kernel{
      law, {HourglassKind::stiffness, 0.05}, {}};
  element::BatchMotion<8> in;
  in.dt = 1e-8;
  for (int c = 0; c < 8; ++c) {
    const double corner[3] = {c % 4 == 1 || c % 4 == 2 ? 1.0 : 0.0, c % 4 > 1 ? 1.0 : 0.0, c > 3 ? 1.0 : 0.0};
    for (int i = 0; i < 3; ++i) {
      in.x[i][c] = in.X[i][c] = broadcast(corner[i]);
      in.v[i][c] = broadcast(corner[(i + 1) % 3] - 0.5);
    }
  }
  std::vector<Pack> history(std::size_t(kernel.history_size), Pack{});
  history[0] = broadcast(8000.0);
  element::BatchForce<8> out;
  return nanoseconds([&] {
    kernel(in, history.data(), history.data(), out);
    asm volatile("" : : "r"(&out), "r"(&in) : "memory");
  });
}

material::J2 steel() {
  material::J2 law;
  law.density = 8000;
  law.young = 2e11;
  law.poisson = 0.3;
  law.yield = 2e8;
  law.hardening = 1e9;
  return law;
}

template <class Response>
void row(const char* name, const Response& law, int points, double velocity) {
  element::ShellSection section;
  section.thickness = 0.1;
  section.points = points;
  const element::Hourglass control{HourglassKind::stiffness, 0.05};
  fmt::print("  {:<34}{:>3}{:9.1f}{:9.1f}{:9.1f}\n", name, points,
             shell(element::Shell4<Response>{law, section, control}, velocity),
             shell(element::Shell4Full<Response>{law, section}, velocity),
             shell(element::Shell3<Response>{law, section}, velocity));
}

}  // namespace

int main() {
  fmt::print("one batch in cache, kernel alone [ns an element-step]\n  hex8, elastic {:29.1f}\n", hexahedron());
  fmt::print("  {:<34}{:>3}{:>9}{:>9}{:>9}\n", "law", "points", "shell4", "full", "shell3");
  const material::ElasticResponse elastic({8000, 2e11, 0.3});
  const material::J2Response<false, false> plastic(steel());
  for (const int points : {1, 3, 5}) row("elastic", elastic, points, 1);
  row("J2, elastic steps", plastic, 3, 0);
  row("J2, flow at all points", plastic, 3, 1e5);
  material::Metal metal;
  metal.density = 8000;
  metal.bulk = 1.67e11;
  metal.shear = 7.7e10;
  metal.strength = material::JohnsonCook{2e8, 4e8, 0.3, 1, 293, 1793};
  metal.rate = {material::RateFactor::Form::logarithm, 0.02, 1};
  metal.heat = {450, 0.9, 293};
  row("Johnson-Cook, flow at all points", material::MetalResponse<false>(metal), 3, 1e5);
}
