// SPDX-License-Identifier: Apache-2.0
// Points through the thickness of a shell: places and weights of the rules of Gauss and of Lobatto.
#pragma once
#include "element/options.hpp"

namespace brunt::element {

/// A rule on the thickness: places over the middle and weights, in thicknesses; the weights sum to one.
struct ThicknessPoints {
  int count = 0;
  double at[ShellSection::most_points]{};      ///< ascending, -1/2 to 1/2
  double weight[ShellSection::most_points]{};  ///< positive
  double second = 0;                           ///< sum of weight at^2: 1/12 where the rule is exact, 0 of one point
};

namespace thickness_detail {

/// Legendre's polynomial of degree n at x with its first and second derivatives, by its three-term recurrence.
struct Legendre {
  double value, slope, second;
};
constexpr Legendre legendre(int n, double x) {
  Legendre before{1, 0, 0}, now{x, 1, 0};
  if (n == 0) return before;
  for (int k = 2; k <= n; ++k) {
    const double a = (2.0 * k - 1) / k, b = (k - 1.0) / k;
    const Legendre next{a * x * now.value - b * before.value, a * (now.value + x * now.slope) - b * before.slope,
                        a * (2 * now.slope + x * now.second) - b * before.second};
    before = now;
    now = next;
  }
  return now;
}

/// Roots of P_n, or of its derivative: Newton's method from the right of the largest, the roots found divided out (H.
/// Maehly 1954), which converges from above; then without division, to rounding.
constexpr void roots(int n, bool of_slope, int count, double* root) {
  for (int k = 0; k < count; ++k) {
    double x = 1;
    for (int iteration = 0; iteration < 100; ++iteration) {
      const Legendre p = legendre(n, x);
      const double value = of_slope ? p.slope : p.value, slope = of_slope ? p.second : p.slope;
      double divided = slope;
      if (iteration < 90)
        for (int j = 0; j < k; ++j) divided -= value / (x - root[j]);
      x -= value / divided;
    }
    root[k] = x;
  }
}

constexpr ThicknessPoints rule(ThicknessRule kind, int count) {
  ThicknessPoints points;
  points.count = count;
  double root[ShellSection::most_points]{};
  const bool lobatto = kind == ThicknessRule::lobatto && count > 1;
  const int inner = lobatto ? count - 2 : count, degree = lobatto ? count - 1 : count;
  roots(degree, lobatto, inner, root);
  for (int k = 0; k < count; ++k) {
    double x = 0;
    if (!lobatto)
      x = root[count - 1 - k];
    else
      x = k == 0 ? -1 : k == count - 1 ? 1 : root[inner - k];
    if (2 * k + 1 == count) x = 0;  // the middle one, exactly
    const Legendre p = legendre(degree, x);
    points.at[k] = x / 2;
    points.weight[k] =
        lobatto ? 1 / (count * (count - 1.0) * p.value * p.value) : 1 / ((1 - x * x) * p.slope * p.slope);
    points.second += points.weight[k] * points.at[k] * points.at[k];
  }
  return points;
}

struct Table {
  ThicknessPoints rules[2][ShellSection::most_points + 1];
};
constexpr Table all_rules() {
  Table table;
  for (int n = 1; n <= ShellSection::most_points; ++n) {
    table.rules[0][n] = rule(ThicknessRule::gauss, n);
    table.rules[1][n] = rule(ThicknessRule::lobatto, n);
  }
  return table;
}
inline constexpr Table table = all_rules();

}  // namespace thickness_detail

/// One point is the middle, of either rule.
constexpr const ThicknessPoints& thickness_points(const ShellSection& section) {
  return thickness_detail::table.rules[section.rule == ThicknessRule::lobatto ? 1 : 0][section.points];
}

}  // namespace brunt::element
