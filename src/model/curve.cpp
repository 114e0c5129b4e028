// SPDX-License-Identifier: Apache-2.0
#include "model/curve.hpp"

#include <algorithm>

namespace brunt::model {

double value_at(const Curve& curve, double time) {
  if (curve.empty()) return 1.0;
  if (time <= curve.front()[0]) return curve.front()[1];
  if (time >= curve.back()[0]) return curve.back()[1];
  const auto after = std::upper_bound(curve.begin(), curve.end(), time,
                                      [](double t, const std::array<double, 2>& point) { return t < point[0]; });
  const std::array<double, 2>&a = *(after - 1), &b = *after;
  return a[1] + (b[1] - a[1]) * ((time - a[0]) / (b[0] - a[0]));
}

double slope_after(const Curve& curve, double time) {
  if (curve.empty() || time < curve.front()[0] || time >= curve.back()[0]) return 0;
  const auto after = std::upper_bound(curve.begin(), curve.end(), time,
                                      [](double t, const std::array<double, 2>& point) { return t < point[0]; });
  const std::array<double, 2>&a = *(after - 1), &b = *after;
  return (b[1] - a[1]) / (b[0] - a[0]);
}

double integral(const Curve& curve, double from, double to) {
  // trapezoidal rule between the ends and the points of the curve between them
  double sum = 0, left = from, at_left = value_at(curve, from);
  const auto add_until = [&](double right) {
    const double at_right = value_at(curve, right);
    sum += 0.5 * (right - left) * (at_left + at_right);
    left = right;
    at_left = at_right;
  };
  for (const auto& [time, value] : curve)
    if (time > from && time < to) add_until(time);
  add_until(to);
  return sum;
}

}  // namespace brunt::model
