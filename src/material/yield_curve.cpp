// SPDX-License-Identifier: Apache-2.0
// Yield stress over equivalent plastic strain, piecewise linear.
#include "material/yield_curve.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "core/error.hpp"

namespace brunt::material {
namespace {

void check(const std::vector<std::array<double, 2>>& table, double shear_modulus) {
  std::vector<std::string> faults;
  const auto fault = [&](std::size_t row, const std::string& what) {
    faults.push_back(fmt::format("hardening_table.{}: {}", row, what));
  };
  if (table.empty()) fault(0, "is missing; give at least one pair (plastic strain, yield stress)");
  for (std::size_t i = 0; i < table.size(); ++i) {
    const auto [strain, yield] = table[i];
    if (!(yield > 0) || !std::isfinite(yield)) fault(i, fmt::format("yield stress {} must be positive", yield));
    if (i == 0) {
      if (strain != 0) fault(i, fmt::format("plastic strain {} must be 0 in the first row", strain));
      continue;
    }
    const auto [before, yield_before] = table[i - 1];
    if (!(strain > before) || !std::isfinite(strain))
      fault(i, fmt::format("plastic strain {} must be greater than {} in the row before", strain, before));
    else if (yield_before - yield >= 3 * shear_modulus * (strain - before))
      fault(i, fmt::format("yield stress falls from {} to {}, faster than 3 G = {} times the plastic strain",
                           yield_before, yield, 3 * shear_modulus));
  }
  if (!faults.empty()) throw InputError(std::move(faults));
}

}  // namespace

YieldCurve::YieldCurve(const std::vector<std::array<double, 2>>& table, double shear_modulus)
    : three_shear_(3 * shear_modulus) {
  check(table, shear_modulus);
  for (std::size_t i = 0; i < table.size(); ++i) {
    const auto [strain, yield] = table[i];
    const bool last = i + 1 == table.size();
    pieces_.push_back({strain, yield, last ? 0 : (table[i + 1][1] - yield) / (table[i + 1][0] - strain)});
  }
}

double YieldCurve::smallest() const {
  return std::min_element(pieces_.begin(), pieces_.end(), [](auto& a, auto& b) { return a.yield < b.yield; })->yield;
}

std::size_t YieldCurve::piece_of(double plastic_strain) const {
  const auto after = std::upper_bound(pieces_.begin() + 1, pieces_.end(), plastic_strain,
                                      [](double strain, const Piece& piece) { return strain < piece.strain; });
  return static_cast<std::size_t>(after - pieces_.begin()) - 1;
}

double YieldCurve::at(double plastic_strain) const {
  const Piece& piece = pieces_[piece_of(plastic_strain)];
  return piece.yield + piece.slope * (plastic_strain - piece.strain);
}

double YieldCurve::plastic_increment(double plastic_strain, double excess, double three_shear) const {
  std::size_t k = piece_of(plastic_strain);
  double increment = 0;
  for (; k + 1 < pieces_.size(); ++k) {
    // the part returned from here to the end of the piece; it increases along the curve since slope > -3 G
    const double stiffness = three_shear + pieces_[k].slope;
    const double room = pieces_[k + 1].strain - (plastic_strain + increment);
    if (stiffness * room >= excess) return increment + excess / stiffness;
    excess -= stiffness * room;
    increment = pieces_[k + 1].strain - plastic_strain;
  }
  return increment + excess / (three_shear + pieces_[k].slope);
}

}  // namespace brunt::material
