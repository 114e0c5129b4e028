// SPDX-License-Identifier: Apache-2.0
// What a linear solver over rows is made of: an impulse as one number along the normal, where no row is tied (a third
// of the work), or as a vector.
#pragma once
#include <cmath>
#include <span>
#include <vector>

#include "brunt/contact/enforcement/system.hpp"

namespace brunt::contact {

/// Rows that push along their normals alone: an impulse is one number.
struct Normal {
  using Amount = double;
  static std::span<double> view(std::vector<Vec3>& of_rows) {
    return of_rows.empty() ? std::span<double>{} : std::span<double>(of_rows.front().data(), of_rows.size());
  }
  static double taken(const RowLaw& law, const Vec3& impulse) { return law.normal.dot(impulse); }
  static Vec3 given(const RowLaw& law, double impulse) { return impulse * law.normal; }
  static double zero() { return 0; }
  static double size(double impulse) { return std::abs(impulse); }
  static double product(double a, double b) { return a * b; }
  static double held(const RowLaw& law, const Vec3& relative) { return law.normal.dot(relative); }
  static double missing(const RowLaw& law, const Vec3& relative) { return law.required - law.normal.dot(relative); }
  static bool pushes(const RowLaw& /*law*/, double impulse) { return impulse > 0; }
  static double along(const RowLaw& /*law*/, double impulse) { return impulse; }
  static double admitted(const RowLaw& law, double impulse) {
    return law.cone == Cone::compression && impulse < 0 ? 0.0 : impulse;
  }
};

/// Where some are tied.
struct Whole {
  using Amount = Vec3;
  static std::span<Vec3> view(std::vector<Vec3>& of_rows) { return of_rows; }
  static const Vec3& taken(const RowLaw& /*law*/, const Vec3& impulse) { return impulse; }
  static const Vec3& given(const RowLaw& /*law*/, const Vec3& impulse) { return impulse; }
  static Vec3 zero() { return Vec3::Zero(); }
  static double size(const Vec3& impulse) { return impulse.norm(); }
  static double product(const Vec3& a, const Vec3& b) { return a.dot(b); }
  static Vec3 held(const RowLaw& law, const Vec3& relative) {
    return law.across != Across::slips ? relative : Vec3(law.normal.dot(relative) * law.normal);
  }
  static Vec3 missing(const RowLaw& law, const Vec3& relative) { return missing_rate(law, relative); }
  static bool pushes(const RowLaw& law, const Vec3& impulse) { return along(law, impulse) > 0; }
  static double along(const RowLaw& law, const Vec3& impulse) { return law.normal.dot(impulse); }
  static Vec3 admitted(const RowLaw& law, const Vec3& impulse) { return contact::admitted(law, impulse); }
};

}  // namespace brunt::contact
