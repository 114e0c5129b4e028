// SPDX-License-Identifier: Apache-2.0
// Scales of comparison (see the header).
#include "natural_scales.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <span>
#include <string_view>

#include "comm/rendezvous.hpp"

namespace brunt::io {
namespace {

// Terms of the balance of energy; each is as accurate as the largest of them.
constexpr std::array<std::string_view, 12> energies{"kinetic",  "internal", "hourglass", "bulk",   "damping", "contact",
                                                    "friction", "walls",    "external",  "driven", "eroded",  "total"};

/// Largest finite magnitude of a column in either history; 0 where neither has it.
double largest(const History& a, const History& b, std::string_view name) {
  double found = 0;
  for (const History* history : {&a, &b}) {
    const auto column = static_cast<std::size_t>(std::ranges::find(history->names, name) - history->names.begin());
    if (column == history->names.size()) continue;
    for (const std::vector<double>& row : history->rows)
      if (std::isfinite(row[column])) found = std::max(found, std::abs(row[column]));
  }
  return found;
}

}  // namespace

double size_of_mesh(const Hdf5File& file) {
  const std::string table = "/mesh/coordinates";
  const Hdf5File::Extent extent = file.extent(table);
  const comm::BlockLayout layout{extent.rows, file.ranks().size()};
  const Rank rank = file.ranks().rank();
  const auto width = static_cast<std::size_t>(extent.width);
  std::vector<double> places(static_cast<std::size_t>(layout.count(rank)) * width);
  file.read(table, layout.first(rank), std::span<double>(places));
  double square = 0;
  for (std::size_t c = 0; c < width; ++c) {
    double least = std::numeric_limits<double>::infinity(), most = -least;
    for (std::size_t i = c; i < places.size(); i += width) {
      least = std::min(least, places[i]);
      most = std::max(most, places[i]);
    }
    const double side = file.ranks().max(most) + file.ranks().max(-least);
    if (std::isfinite(side)) square += side * side;
  }
  return std::sqrt(square);
}

double natural_scale(const std::string& field, double size) {
  return field == "gap" ? size : 0;
}

std::vector<double> natural_scales(const History& a, const History& b, double size) {
  double energy = 0;
  for (const std::string_view name : energies) energy = std::max(energy, largest(a, b, name));
  // |sum m v| <= sqrt(2 sum m * sum m v^2 / 2), Cauchy and Schwarz
  const double momentum = std::sqrt(2 * largest(a, b, "mass") * largest(a, b, "kinetic"));
  std::vector<double> scales;
  for (const std::string& name : a.names) {
    const bool is_energy = std::ranges::find(energies, std::string_view(name)) != energies.end();
    const bool is_momentum = name == "momentum_x" || name == "momentum_y" || name == "momentum_z";
    scales.push_back(is_energy ? energy : is_momentum ? momentum : name == "max_penetration" ? size : 0.0);
  }
  return scales;
}

}  // namespace brunt::io
