// SPDX-License-Identifier: Apache-2.0
// Operations of a linear solver over rows: an impulse as one number along the normal if no row is tied (a third of the
// work), or as a vector, with or without friction.
#pragma once
#include <algorithm>
#include <cmath>
#include <span>
#include <vector>

#include "contact/enforcement/system.hpp"

namespace brunt::contact {

/// Rows with compression along their normals only: an impulse is one number.
struct Normal {
  static constexpr bool rubs = false;
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
  static constexpr bool rubs = false;
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

/// Where some have friction; see chosen_rows.hpp.
struct Rubbing : Whole {
  static constexpr bool rubs = true;
  static bool slides(const RowLaw& law, const Vec3& asked) {
    if (law.across != Across::rubs) return false;
    const double push = along(law, asked);
    return (asked - push * law.normal).norm() > friction_limit(law, std::max(push, 0.0));
  }
  static Slide slide_of(const RowLaw& law, const Vec3& push, const Vec3& missing) {
    const Vec3 across = push - along(law, push) * law.normal;
    const double limit = across.norm();
    if (!(limit > 0)) return {};
    const Vec3 direction = across / limit;
    return {direction, std::max(0.0, direction.dot(missing)) / limit};
  }
  static Vec3 turning(const RowLaw& law, const Slide& slide, const Vec3& amount) {
    if (slide.direction.isZero(0)) return Vec3::Zero();
    return amount - along(law, amount) * law.normal - slide.direction.dot(amount) * slide.direction;
  }
};

}  // namespace brunt::contact
