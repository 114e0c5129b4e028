// SPDX-License-Identifier: Apache-2.0
#include "acceleration.hpp"

#include <Eigen/Dense>
#include <algorithm>

#include "comm/exact_sum.hpp"
#include "core/types.hpp"

namespace brunt::implicit {

void Acceleration::improve(const comm::Communicator& ranks, std::size_t measured, std::span<double> correction) {
  if (!last_.empty()) {
    std::rotate(change_.begin(), change_.end() - 1, change_.end());
    known_ = std::min(known_ + 1, depth);
    Change& newest = change_.front();
    newest.correction.resize(correction.size());
    newest.place.resize(correction.size());
    for (std::size_t i = 0; i < correction.size(); ++i) {
      newest.correction[i] = correction[i] - last_[i];
      newest.place[i] = -share_ * applied_[i];
    }
  }
  last_.assign(correction.begin(), correction.end());
  share_ = 1;
  std::array<comm::ExactAccumulator, depth*(depth + 1)> sums;
  for (std::size_t a = 0; a < known_; ++a)
    for (std::size_t i = 0; i < measured; ++i) {
      sums[depth * depth + a].add(change_[a].correction[i] * correction[i]);
      for (std::size_t b = 0; b <= a; ++b) sums[depth * a + b].add(change_[a].correction[i] * change_[b].correction[i]);
    }
  std::array<double, depth*(depth + 1)> value{};
  comm::exact_sum(ranks, sums, value);
  // Differences that nearly depend on newer ones are left out: their squares leave less than rounding^(1/2) of a pivot.
  constexpr double dependent = 1e-7;
  Eigen::Matrix<double, depth, depth> products = Eigen::Matrix<double, depth, depth>::Identity();
  Eigen::Matrix<double, depth, 1> right = Eigen::Matrix<double, depth, 1>::Zero();
  std::size_t used = 0;
  for (; used < known_; ++used) {
    const auto a = static_cast<Eigen::Index>(used);
    for (std::size_t b = 0; b <= used; ++b)
      products(a, static_cast<Eigen::Index>(b)) = products(static_cast<Eigen::Index>(b), a) = value[depth * used + b];
    const auto block = products.topLeftCorner(a + 1, a + 1);
    const double pivot = block.determinant() / (a > 0 ? products.topLeftCorner(a, a).determinant() : 1.0);
    if (!(pivot > dependent * products(a, a))) break;
    right[a] = value[depth * depth + used];
  }
  if (used > 0) {
    const auto size = static_cast<Eigen::Index>(used);
    const Eigen::VectorXd shares = products.topLeftCorner(size, size).ldlt().solve(right.head(size));
    for (std::size_t a = 0; a < used; ++a)
      for (std::size_t i = 0; i < correction.size(); ++i)
        correction[i] -= shares[static_cast<Eigen::Index>(a)] * (change_[a].correction[i] - change_[a].place[i]);
  }
  applied_.assign(correction.begin(), correction.end());
}

}  // namespace brunt::implicit
