// SPDX-License-Identifier: Apache-2.0
// Nanoseconds of one core for an element-step of the one-point hexahedron, whole and in parts, beside a stripped
// prototype kernel in the same loop. Usage: bench_element [edge elements ...], default 30 100 (27,000 and 10^6).
#include <fmt/core.h>

#include <chrono>
#include <cstdlib>
#include <functional>
#include <vector>

#include "bench/prototype_hex8.hpp"
#include "comm/session.hpp"
#include "element/hex8.hpp"
#include "force/block_loop.hpp"
#include "material/elastic.hpp"
#include "material/j2.hpp"
#include "mesh/primitives.hpp"
#include "support/simulation.hpp"
#include "time/motion.hpp"

using namespace brunt;
using element::Hex8;
using element::HourglassKind;
using material::ElasticResponse;
using J2Response = material::J2Response<false, false>;

namespace {

/// Best of several repeats, in seconds, of `work` done `count` times.
double seconds(int count, const std::function<void()>& work) {
  using Clock = std::chrono::steady_clock;
  double best = 1e300;
  for (int repeat = 0; repeat < 7; ++repeat) {
    const Clock::time_point start = Clock::now();
    for (int i = 0; i < count; ++i) work();
    best = std::min(best, std::chrono::duration<double>(Clock::now() - start).count() / count);
  }
  return best;
}

/// Gathers and scatters, computes next to nothing.
struct NoKernel {
  static constexpr int nodes = 8, history_size = 1;
  ElasticResponse law;
  void operator()(const element::BatchMotion<8>& in, const Pack* /*committed*/, Pack* /*trial*/,
                  element::BatchForce<8>& out) const {
    for (int i = 0; i < 3; ++i)
      for (int c = 0; c < 8; ++c) out.f[i][c] = 1e-30 * (in.x[i][c] + in.v[i][c]);
    out.rate = out.volume = broadcast(1.0);
  }
};

class Bench {
 public:
  explicit Bench(int edge)
      : run_(mesh::box("block", {1, 1, 1}, {edge, edge, edge}),
             "materials: {m: {model: elastic, density: 8000, young: 2.0e11, poisson: 0.3}}\n"
             "parts: {block: {material: m}}\n"
             "initial: [{part: block, rotation: {axis: [1, 2, 3], rate: 100}}]\n"),
        elements_(static_cast<double>(run_.model.blocks[0].count)),
        count_(std::max(1, static_cast<int>(2e6 / elements_))) {
    run_.step();
    run_.step();
  }

  /// The loop over all batches with this kernel, its history started from zero stress.
  template <class Kernel>
  double kernel(const Kernel& kernel) {
    const model::ElementBlock& block = run_.model.blocks[0];
    AlignedVector<double>& history = run_.state.history[0];
    history.assign(static_cast<std::size_t>(block.batches() * Kernel::history_size * pack_width), 0.0);
    const double mass = 8000 / elements_;
    for (LocalIndex batch = 0; batch < block.batches(); ++batch)
      for (int lane = 0; lane < pack_width; ++lane)
        history[static_cast<std::size_t>(batch * Kernel::history_size * pack_width + lane)] = mass;
    force::ElementReport report;
    const force::Motion motion{run_.state.nodes, run_.state.dt};
    const force::BlockPass pass{run_.model, motion, run_.state.history, run_.state.history, run_.scratch, report};
    return per_element([&] { force::run_block(kernel, block, 0, pass); });
  }
  double zero_forces() {
    return per_element([&] { std::fill(run_.scratch.force.begin(), run_.scratch.force.end(), Quad{}); });
  }
  double nodes() {
    return per_element([&] { time::predict(run_.model, run_.state, run_.scratch, 1e-12, 1e-12); });
  }
  double ledger() {
    return per_element([&] { (void)run_.ledger(); });
  }

 private:
  double per_element(const std::function<void()>& work) {
    work();
    return 1e9 * seconds(count_, work) / elements_;
  }

  test::Simulation run_;
  double elements_;
  int count_;
};

/// The kernel alone on one batch that stays in cache.
template <class Kernel>
double kernel_alone(const Kernel& kernel) {
  element::BatchMotion<8> in;
  in.dt = 1e-8;
  for (int c = 0; c < 8; ++c) {
    const double corner[3] = {c % 4 == 1 || c % 4 == 2 ? 1.0 : 0.0, c % 4 > 1 ? 1.0 : 0.0, c > 3 ? 1.0 : 0.0};
    for (int i = 0; i < 3; ++i) {
      in.x[i][c] = in.X[i][c] = broadcast(corner[i]);
      in.v[i][c] = broadcast(corner[(i + 1) % 3] - 0.5);
    }
  }
  std::vector<Pack> history(Kernel::history_size, Pack{});
  history[0] = broadcast(8000.0);
  element::BatchForce<8> out;
  const auto work = [&] {
    kernel(in, history.data(), history.data(), out);
    asm volatile("" : : "r"(&out), "r"(&in) : "memory");
  };
  return 1e9 * seconds(100000, work) / pack_width;
}

const ElasticResponse elastic({8000, 2e11, 0.3});
const J2Response plastic({8000, 2e11, 0.3, 4e8, 1e9, {}, 0});
constexpr element::BulkViscosity viscosity;

template <HourglassKind kind, class Response>
Hex8<Response, kind> hex8(const Response& response) {
  return {response, {kind, 0.05}, viscosity};
}

void print(const char* name, double nanoseconds) {
  fmt::print("  {:<46}{:8.2f}\n", name, nanoseconds);
}

void alone() {
  fmt::print("one batch in cache, kernel alone [ns an element-step]\n");
  const double ours = kernel_alone(hex8<HourglassKind::stiffness>(elastic));
  const double prototype = kernel_alone(bench::PrototypeHex8<ElasticResponse>{elastic});
  print("elastic, stiffness hourglass", ours);
  print("elastic, viscous hourglass", kernel_alone(hex8<HourglassKind::viscous>(elastic)));
  print("elastic, no hourglass", kernel_alone(hex8<HourglassKind::none>(elastic)));
  print("J2, stiffness hourglass", kernel_alone(hex8<HourglassKind::stiffness>(plastic)));
  print("prototype, elastic", prototype);
  print("prototype, J2", kernel_alone(bench::PrototypeHex8<J2Response>{plastic}));
  print("ratio to the prototype, elastic", ours / prototype);
}

void whole(int edge) {
  Bench bench(edge);
  fmt::print("{} elements [ns an element-step]\n", edge * edge * edge);
  const double nodes = bench.nodes(), zero = bench.zero_forces();
  print("node update", nodes);
  print("zeroing of forces", zero);
  print("ledger (when asked for)", bench.ledger());
  print("gather and scatter only", bench.kernel(NoKernel{elastic}));
  const double ours = bench.kernel(hex8<HourglassKind::stiffness>(elastic));
  const double ours_j2 = bench.kernel(hex8<HourglassKind::stiffness>(plastic));
  const double prototype = bench.kernel(bench::PrototypeHex8<ElasticResponse>{elastic});
  const double prototype_j2 = bench.kernel(bench::PrototypeHex8<J2Response>{plastic});
  print("elements: elastic, stiffness hourglass", ours);
  print("elements: elastic, viscous hourglass", bench.kernel(hex8<HourglassKind::viscous>(elastic)));
  print("elements: elastic, no hourglass", bench.kernel(hex8<HourglassKind::none>(elastic)));
  print("elements: J2, stiffness hourglass", ours_j2);
  print("elements: prototype, elastic", prototype);
  print("elements: prototype, J2", prototype_j2);
  const double rest = nodes + zero;
  print("whole step: elastic", ours + rest);
  print("whole step: J2", ours_j2 + rest);
  print("ratio of whole steps to the prototype, elastic", (ours + rest) / (prototype + rest));
  print("ratio of whole steps to the prototype, J2", (ours_j2 + rest) / (prototype_j2 + rest));
}

}  // namespace

int main(int argc, char** argv) {
  const comm::Session session(argc, argv);
  std::vector<int> edges;
  for (int i = 1; i < argc; ++i) edges.push_back(std::atoi(argv[i]));
  if (edges.empty()) edges = {30, 100};
  alone();
  for (const int edge : edges) whole(edge);
}
