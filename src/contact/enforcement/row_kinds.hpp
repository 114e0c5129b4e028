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
  static double taken(const Row& row, const Vec3& impulse) { return row.normal.dot(impulse); }
  static Vec3 given(const Row& row, double impulse) { return impulse * row.normal; }
  static double zero() { return 0; }
  static double size(double impulse) { return std::abs(impulse); }
  static double product(double a, double b) { return a * b; }
  static double held(const Row& row, const Vec3& relative) { return row.normal.dot(relative); }
  static double missing(const Row& row, const Vec3& relative) { return row.required - row.normal.dot(relative); }
  static bool pushes(const Row& /*row*/, double impulse) { return impulse > 0; }
  static double along(const Row& /*row*/, double impulse) { return impulse; }
  static double admitted(const Row& row, double impulse) {
    return row.cone == Cone::compression && impulse < 0 ? 0.0 : impulse;
  }
};

/// Where some are tied.
struct Whole {
  using Amount = Vec3;
  static std::span<Vec3> view(std::vector<Vec3>& of_rows) { return of_rows; }
  static const Vec3& taken(const Row& /*row*/, const Vec3& impulse) { return impulse; }
  static const Vec3& given(const Row& /*row*/, const Vec3& impulse) { return impulse; }
  static Vec3 zero() { return Vec3::Zero(); }
  static double size(const Vec3& impulse) { return impulse.norm(); }
  static double product(const Vec3& a, const Vec3& b) { return a.dot(b); }
  static Vec3 held(const Row& row, const Vec3& relative) {
    return row.friction > 0 ? relative : Vec3(row.normal.dot(relative) * row.normal);
  }
  static Vec3 missing(const Row& row, const Vec3& relative) { return missing_rate(row, relative); }
  static bool pushes(const Row& row, const Vec3& impulse) { return along(row, impulse) > 0; }
  static double along(const Row& row, const Vec3& impulse) { return row.normal.dot(impulse); }
  static Vec3 admitted(const Row& row, const Vec3& impulse) { return contact::admitted(row, impulse); }
};

}  // namespace brunt::contact
