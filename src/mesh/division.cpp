// SPDX-License-Identifier: Apache-2.0
// Ends of elements along a line. A size that is linear along it gives elements in geometric progression.
#include "mesh/division.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/error.hpp"

namespace brunt::mesh {
namespace {

/// A part of the line in which the size goes linearly from one value to another.
struct Interval {
  double low, high, first, last;
  int cells = 1;

  /// The integral of 1 / size: what the number of elements is rounded from.
  [[nodiscard]] double wanted() const {
    const double length = high - low, growth = std::log(last / first);
    return std::abs(growth) < 1e-9 ? length / first : length * growth / (last - first);
  }
  [[nodiscard]] double at(int i) const {
    const double growth = std::log(last / first), length = high - low;
    if (std::abs(growth) < 1e-9) return low + length * i / cells;
    return low + length * std::expm1(growth * i / cells) / std::expm1(growth);
  }
};

std::vector<Interval> intervals(const std::vector<SizeAt>& sizes, double low, double high) {
  std::vector<Interval> found;
  if (low < sizes.front().place) found.push_back({low, sizes.front().place, sizes.front().size, sizes.front().size});
  for (std::size_t i = 1; i < sizes.size(); ++i)
    found.push_back({sizes[i - 1].place, sizes[i].place, sizes[i - 1].size, sizes[i].size});
  if (sizes.back().place < high) found.push_back({sizes.back().place, high, sizes.back().size, sizes.back().size});
  for (Interval& one : found)
    one.cells = static_cast<int>(std::clamp(std::round(one.wanted()), 1.0, 1.0 * most_by_sizes));
  return found;
}

}  // namespace

Division by_sizes(const std::vector<SizeAt>& sizes, double low, double high) {
  Division division;
  division.sizes = sizes;
  double cells = 0;
  for (const Interval& one : intervals(sizes, low, high)) cells += one.cells;
  if (cells >= most_by_sizes)
    throw InputError({fmt::format("out of range: the sizes require {:.3g} elements or more; expected at most {}", cells,
                                  most_by_sizes)});
  division.cells = static_cast<int>(cells);
  return division;
}

std::vector<double> places(const Division& division, double low, double high) {
  std::vector<double> ends;
  ends.reserve(static_cast<std::size_t>(division.cells) + 1);
  if (!division.sizes.empty()) {
    for (const Interval& one : intervals(division.sizes, low, high))
      for (int i = 0; i < one.cells; ++i) ends.push_back(one.at(i));
    ends.push_back(high);
    return ends;
  }
  const double size = high - low;
  const double growth = division.cells > 1 ? std::log(division.bias) * division.cells / (division.cells - 1) : 0;
  for (int i = 0; i <= division.cells; ++i)
    ends.push_back(growth == 0 || i == division.cells
                       ? low + size * i / division.cells
                       : low + size * std::expm1(growth * i / division.cells) / std::expm1(growth));
  return ends;
}

int cells_below(const Division& division, double low, double place) {
  int cells = 0;
  for (const Interval& one : intervals(division.sizes, low, division.sizes.back().place))
    if (one.high <= place) cells += one.cells;
  return cells;
}

}  // namespace brunt::mesh
