// SPDX-License-Identifier: Apache-2.0
// Values over time given by points.
#pragma once
#include <array>
#include <vector>

namespace brunt::model {

/// Piecewise linear in time, constant outside its points; empty: 1.
using Curve = std::vector<std::array<double, 2>>;

/// Linear between the points, constant beyond the first and the last; 1 for an empty curve.
double value_at(const Curve& curve, double time);

/// Slope of value_at just after a time.
double slope_after(const Curve& curve, double time);

/// Integral of value_at from one time to a later one, exact but for rounding.
double integral(const Curve& curve, double from, double to);

}  // namespace brunt::model
