// SPDX-License-Identifier: Apache-2.0
// Lanczos' iteration (C. Lanczos, J. Res. Natl. Bur. Stand. 45 (1950) 255) for inverse mass times stiffness, in the
// inner product of the masses, in which that is symmetric: with q . M q = 1 for the motions q_j,
//   w = M^-1 K q_j - beta_j-1 q_j-1,  alpha_j = q_j . M w,  beta_j q_j+1 = w - alpha_j q_j.
// Motions are not orthogonalised to all previous ones: this only produces copies of eigenvalues, none of them above the
// largest (B. N. Parlett, The Symmetric Eigenvalue Problem, 1980, section 13.6).
#include "time/lanczos.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>

#include "core/fixed_sum.hpp"

namespace brunt::time {
namespace {

/// A random whole number of 64 bits for each key (G. L. Steele, D. Lea, C. H. Flood, OOPSLA 2014: splitmix64).
std::uint64_t scrambled(std::uint64_t key) {
  key += 0x9e3779b97f4a7c15U;
  key = (key ^ (key >> 30)) * 0xbf58476d1ce4e5b9U;
  key = (key ^ (key >> 27)) * 0x94d049bb133111ebU;
  return key ^ (key >> 31);
}

/// Normally distributed, by the method of G. E. P. Box and M. E. Muller.
double normal_of(std::uint64_t key) {
  constexpr double unit = 0x1p-53;
  const double first = (static_cast<double>(scrambled(2 * key) >> 11) + 0.5) * unit;
  const double second = static_cast<double>(scrambled(2 * key + 1) >> 11) * unit;
  return std::sqrt(-2 * std::log(first)) * std::cos(2 * std::numbers::pi * second);
}

double square(const Quad& v) {
  return v[0] * v[0] + v[1] * v[1] + v[2] * v[2];
}

class Lanczos {
 public:
  Lanczos(const model::Model& model, const model::State& state, Links& links, const force::LinearElements& linear,
          double scale)
      : model_(model), state_(state), links_(links), linear_(linear), scale_(scale) {
    const std::size_t n = state.nodes.size();
    nodes_.assign(state.nodes.begin(), state.nodes.end());
    before_.assign(n, Quad{});
    answer_.assign(n, Quad{});
    std::size_t corners = 0;
    for (const model::ElementBlock& block : model.blocks) corners += block.border.values.size();
    slots_.assign(4 * corners, 0.0);
    if (!model.bodies.empty()) weigh();
  }

  double run(int products, double enough) {
    begin();
    std::vector<double> diagonal, beside;
    for (int k = 0; k < products; ++k) {
      multiply();
      diagonal.push_back(along());
      if (largest_of_tridiagonal(diagonal, beside) >= enough) return enough;
      const double beta = subtract(diagonal.back(), k > 0 ? beside.back() : 0.0);
      // small against the eigenvalues of order 1: the Krylov space of the start is exhausted
      constexpr double nothing = 1e-6;
      if (!(beta > nothing)) break;
      beside.push_back(beta);
      shift(beta);
    }
    beside.resize(diagonal.size() - 1);
    return largest_of_tridiagonal(diagonal, beside);
  }

 private:
  [[nodiscard]] double inverse_mass(std::size_t i) const { return nodes_[i].mass > 0 ? 1 / nodes_[i].mass : 0.0; }

  /// Masses of deformable elements only: a rigid body may be lighter than its visible elements, but has the masses of
  /// those that are joined to it.
  void weigh() {
    for (std::size_t b = 0; b < model_.blocks.size(); ++b) {
      const model::ElementBlock& block = model_.blocks[b];
      const double* mass = state_.history[b].data();  // the first entry of an element's history
      for (LocalIndex batch = 0; batch < block.batches() && !material::is_rigid(block.law); ++batch) {
        const auto share = [&](int lane) {
          return mass[static_cast<std::ptrdiff_t>(batch) * block.history_size * pack_width + lane] / block.corners();
        };
        for (int lane = 0; lane < std::min(pack_width, block.count - batch * pack_width); ++lane)
          for (int c = 0; c < block.corners(); ++c)
            nth(answer_, block.corner_node(batch * pack_width + lane, c))[0] += share(lane);
        for (const model::BorderCorner& corner : block.border.row(batch))
          slots_[4 * static_cast<std::size_t>(corner.slot)] = share(corner.lane);
      }
    }
    sum_over_ranks();
    for (std::size_t i = 0; i < nodes_.size(); ++i) nodes_[i].mass = answer_[i][0];
  }

  /// Of corners at the border between ranks.
  void sum_over_ranks() {
    links_.corner_forces.begin(slots_, 4);
    links_.corner_forces.end(slots_, 4, {reinterpret_cast<double*>(answer_.data()), 4 * answer_.size()}, 4);
  }

  /// Each direction of each node has the same mean energy.
  void begin() {
    const std::uint64_t draw = scrambled(static_cast<std::uint64_t>(state_.step));
    for (std::size_t i = 0; i < nodes_.size(); ++i) {
      const auto gid = static_cast<std::uint64_t>(model_.mesh.node_gid[i]);
      const double size = std::sqrt(inverse_mass(i));
      for (std::uint64_t c = 0; c < 3; ++c) answer_[i][static_cast<int>(c)] = size * normal_of(draw + 3 * gid + c);
    }
    constexpr double largest_term = 256;  // three normal numbers of 53 bits have no larger sum of squares
    shift(std::sqrt(mass_norm(FixedUnit(largest_term))));
    before_.assign(before_.size(), Quad{});
  }

  /// answer = M^-1 K q / scale on every copy of a node.
  void multiply() {
    force::linear_forces(model_, linear_,
                         {.nodes = nodes_, .living = state_.living.lanes, .force = answer_, .slots = slots_});
    sum_over_ranks();
    for (std::size_t i = 0; i < nodes_.size(); ++i) answer_[i] *= -inverse_mass(i) / scale_;
  }

  [[nodiscard]] double along() const {
    const FixedUnit unit(1.0, fine);
    GlobalIndex sum = 0;
    for (const LocalIndex node : model_.owned) {
      const auto i = static_cast<std::size_t>(node);
      const model::NodeLine& line = nodes_[i];
      const Quad& a = answer_[i];
      sum += unit.of(line.mass * (line.v[0] * a[0] + line.v[1] * a[1] + line.v[2] * a[2]));
    }
    return unit.value(links_.ranks.sum(sum));
  }

  /// Norm of the remainder of the answer.
  double subtract(double alpha, double beta) {
    for (std::size_t i = 0; i < nodes_.size(); ++i) {
      answer_[i] -= beta * before_[i];
      answer_[i] -= alpha * nodes_[i].v_late();
    }
    return std::sqrt(mass_norm(FixedUnit(1.0, fine)));
  }

  [[nodiscard]] double mass_norm(const FixedUnit& unit) const {
    GlobalIndex sum = 0;
    for (const LocalIndex node : model_.owned) {
      const auto i = static_cast<std::size_t>(node);
      sum += unit.of(nodes_[i].mass * square(answer_[i]));
    }
    return unit.value(links_.ranks.sum(sum));
  }

  /// The normalised answer becomes the next motion.
  void shift(double length) {
    for (std::size_t i = 0; i < nodes_.size(); ++i) {
      before_[i] = nodes_[i].v_late();
      nodes_[i].v_late() = (1 / length) * answer_[i];
    }
  }

  static constexpr int fine = 56;  ///< digits of sums that are 1 at most

  const model::Model& model_;
  const model::State& state_;
  Links& links_;
  const force::LinearElements& linear_;
  double scale_;
  AlignedVector<model::NodeLine> nodes_;  ///< v: q_j
  AlignedVector<Quad> before_, answer_;   ///< q_j-1; w
  AlignedVector<double> slots_;
};

/// Whether all eigenvalues are below x: no pivot of the matrix minus x is positive (Sylvester).
bool all_below(double x, const std::vector<double>& diagonal, const std::vector<double>& beside) {
  double pivot = diagonal[0] - x;
  for (std::size_t k = 1; k < diagonal.size() && pivot < 0; ++k)
    pivot = diagonal[k] - x - beside[k - 1] * beside[k - 1] / pivot;
  return pivot < 0;
}

}  // namespace

double largest_of_tridiagonal(const std::vector<double>& diagonal, const std::vector<double>& beside) {
  double low = 0, high = 2;
  while (high - low > 1e-12) {
    const double middle = 0.5 * (low + high);
    (all_below(middle, diagonal, beside) ? high : low) = middle;
  }
  return high;
}

double largest_eigenvalue(const model::Model& model, const model::State& state, Links& links,
                          const force::LinearElements& linear, double scale, int products, double enough) {
  return Lanczos(model, state, links, linear, scale).run(products, enough);
}

}  // namespace brunt::time
