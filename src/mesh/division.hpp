// SPDX-License-Identifier: Apache-2.0
// Division of a direction of a generated body into elements: uniform, graded, or by sizes at given places.
#pragma once
#include <fmt/core.h>

#include <array>
#include <concepts>
#include <cstddef>
#include <string>
#include <vector>

namespace brunt::mesh {

/// Elements at `place` have this size; between places the size varies linearly, outside it is constant.
struct SizeAt {
  double place = 0, size = 0;  ///< [length]
  friend bool operator==(const SizeAt&, const SizeAt&) = default;
};

/// Converts to its number of elements.
struct Division {
  int cells = 1;
  double bias = 1;  ///< size of the last element divided by that of the first; sizes form a geometric progression
  std::vector<SizeAt> sizes;  ///< if not empty, these sizes determine the elements, and `cells` is their number

  Division() = default;
  Division(int count) : cells(count) {}   // NOLINT: a number of even elements
  operator int() const { return cells; }  // NOLINT
  [[nodiscard]] bool is_even() const { return bias == 1 && sizes.empty(); }
  friend bool operator==(const Division&, const Division&) = default;
};

/// One division for each direction of a body.
template <std::size_t N>
struct Divisions : std::array<Division, N> {
  Divisions() = default;
  Divisions(const std::array<int, N>& counts) {  // NOLINT: numbers of even elements
    for (std::size_t i = 0; i < N; ++i) (*this)[i] = Division(counts[i]);
  }
  template <std::convertible_to<int>... Counts>
  requires(sizeof...(Counts) == N && N > 1) Divisions(Counts... counts)
      : std::array<Division, N>{Division(static_cast<int>(counts))...} {}  // NOLINT
  friend bool operator==(const Divisions& a, const std::array<int, N>& counts) { return a == Divisions(counts); }
  friend bool operator==(const Divisions&, const Divisions&) = default;
};

/// The division from `low` to `high` by sizes: increasing places within this range, positive sizes. Each interval
/// between places has an integer number of elements, so that nodes lie at each place. Throws InputError above `most`
/// elements.
Division by_sizes(const std::vector<SizeAt>& sizes, double low, double high);
constexpr int most_by_sizes = 10'000'000;

/// Ends of the elements, from `low` to `high`; for uniform elements low + (high - low) i / cells.
std::vector<double> places(const Division& division, double low, double high);

/// Number of elements from `low` to `place`, which is one of the places of `sizes`.
int cells_below(const Division& division, double low, double place);

}  // namespace brunt::mesh

template <>
struct fmt::formatter<brunt::mesh::Division> {
  constexpr auto parse(fmt::format_parse_context& context) { return context.begin(); }
  template <class Context>
  auto format(const brunt::mesh::Division& division, Context& context) const {
    return fmt::format_to(context.out(), "{}", division.cells);
  }
};
