// SPDX-License-Identifier: Apache-2.0
// The active rows of conjugate residuals, and their linearisation. Rows that stick, are tied or have no friction are
// active as a whole. For a sliding row with friction at the limit L along t, the derivative of the sweep's fixed point
//   p = admitted(p + missing / H)
// is used (as in semismooth Newton methods: Alart and Curnier, Comput. Methods Appl. Mech. Eng. 92, 1991):
// - along the normal, its impulse includes its friction, normal + mu t; only the normal rate is required;
// - across both, friction rotates with the slip s: a spring with the compliance s / L;
// - along t, no rate is required.
// G W G^T of sliding rows is therefore not symmetric. Methods of smallest residual converge nevertheless if few rows
// slide or friction is moderate (conjugate residuals with one previous direction are Orthomin(1): Eisenstat, Elman,
// Schultz, SIAM J. Numer. Anal. 20, 1983).
#pragma once
#include <algorithm>
#include <cmath>
#include <span>
#include <vector>

#include "contact/enforcement/system.hpp"

namespace brunt::contact {

/// Rows with compression along their normals only: an impulse is one number, a third of the work of a vector.
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

/// Where some have friction; see above.
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

enum class Part : char { none, whole, sliding };

/// a and b: impulses, or what is asked for, of row q.
template <class Kind>
class ChosenRows {
 public:
  using Amount = typename Kind::Amount;
  ChosenRows(const RowMatrix& rows, EnforcementScratch& scratch) : rows_(rows), scratch_(scratch) {
    scratch.chosen.assign(rows.size(), static_cast<char>(Part::none));
    if constexpr (Kind::rubs) scratch.slide.resize(rows.size());
  }

  [[nodiscard]] bool has(std::size_t q) const { return part(q) != Part::none; }
  [[nodiscard]] bool slides(std::size_t q) const { return Kind::rubs && part(q) == Part::sliding; }
  void leave(std::size_t q) { take(q, Part::none); }
  /// Of a row that the law's `admitted` brought from `asked` to `push`, with this left to be asked for.
  void choose(std::size_t q, const Amount& asked, const Amount& push, const Amount& missing) {
    take(q, Part::whole);
    if constexpr (Kind::rubs) {
      if (!Kind::slides(law(q), asked)) return;
      take(q, Part::sliding);
      scratch_.slide[q] = Kind::slide_of(law(q), push, missing);
    }
  }

  /// With the friction that an impulse along the normal brings.
  [[nodiscard]] Amount with_friction(std::size_t q, const Amount& a) const {
    if constexpr (Kind::rubs)
      if (slides(q)) return a + law(q).friction * Kind::along(law(q), a) * scratch_.slide[q].direction;
    return a;
  }
  /// Its part across the normal and friction, and what springs there take of what is asked for.
  [[nodiscard]] Amount turning(std::size_t q, const Amount& a) const {
    if constexpr (Kind::rubs)
      if (slides(q)) return Kind::turning(law(q), scratch_.slide[q], a);
    return Kind::zero();
  }
  [[nodiscard]] Amount given(std::size_t q, const Amount& a) const {
    if constexpr (Kind::rubs)
      if (slides(q)) return scratch_.slide[q].give * turning(q, a);
    return Kind::zero();
  }
  /// The step of length 1, H^-1 a.
  [[nodiscard]] Amount scaled(std::size_t q, const Amount& a) const {
    if constexpr (Kind::rubs)
      if (slides(q))
        return scratch_.inverse[q] * Kind::along(law(q), a) * law(q).normal +
               1 / (scratch_.diagonal[q] + scratch_.slide[q].give) * turning(q, a);
    return scratch_.inverse[q] * a;
  }
  /// a.H^-1 b
  [[nodiscard]] double product(std::size_t q, const Amount& a, const Amount& b) const {
    if constexpr (Kind::rubs)
      if (slides(q)) return Kind::product(scaled(q, a), b);
    return scratch_.inverse[q] * Kind::product(a, b);
  }
  /// a.Ha
  [[nodiscard]] double energy(std::size_t q, const Amount& a) const {
    const double plain = scratch_.diagonal[q] * Kind::product(a, a);
    if constexpr (Kind::rubs)
      if (slides(q)) return plain + Kind::product(given(q, a), a);
    return plain;
  }

 private:
  [[nodiscard]] const RowLaw& law(std::size_t q) const { return rows_.laws[q]; }
  void take(std::size_t q, Part part) { scratch_.chosen[q] = static_cast<char>(part); }
  [[nodiscard]] Part part(std::size_t q) const { return static_cast<Part>(scratch_.chosen[q]); }

  const RowMatrix& rows_;
  EnforcementScratch& scratch_;
};

}  // namespace brunt::contact
