// SPDX-License-Identifier: Apache-2.0
// Branch and bound over (u, v, tau), earliest boxes first, with an interval Newton step in each box.
#include "geometry/trilinear.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>

namespace brunt::geometry {
namespace {

/// Half widths below this are not divided further, and no search tests more boxes than `most_boxes`.
constexpr double smallest_box = 1e-9;
constexpr int most_boxes = 4096;

struct Cell {
  Vec3 middle, half;
};

/// The function over a cell, in coordinates s in [-1, 1]^3: d0 + d_i s_i + d_ij s_i s_j + d_123 s_1 s_2 s_3.
struct Local {
  Vec3 d0, d1, d2, d3, d12, d13, d23, d123;
};

TrilinearPlace place_of(const Vec3& x) {
  return {x[0], x[1], x[2]};
}

Local expand(const Trilinear& f, const Cell& cell) {
  const TrilinearPlace m = place_of(cell.middle);
  const double a = cell.half[0], b = cell.half[1], c = cell.half[2];
  return {value(f, m),
          a * derivative_u(f, m),
          b * derivative_v(f, m),
          c * derivative_tau(f, m),
          a * b * (f.uv + m.tau * f.uv_tau),
          a * c * (f.u_tau + m.v * f.uv_tau),
          b * c * (f.v_tau + m.u * f.uv_tau),
          a * b * c * f.uv_tau};
}

/// The derivative at a position: data for its inverse (rows of the adjugate), and for the distinction of crossing and
/// touching.
struct Jacobian {
  Vec3 v_tau, tau_u, u_v;
  double determinant, scale;
};

Jacobian jacobian(const Vec3& u, const Vec3& v, const Vec3& tau) {
  const Vec3 u_v = u.cross(v);
  return {v.cross(tau), tau.cross(u), u_v, u_v.dot(tau),
          std::sqrt(u.squaredNorm() * v.squaredNorm() * tau.squaredNorm())};
}

/// J^-1 y by Cramer's rule.
Vec3 solve(const Jacobian& j, const Vec3& y) {
  return Vec3(y.dot(j.v_tau), y.dot(j.tau_u), y.dot(j.u_v)) / j.determinant;
}

bool crosses(const Jacobian& j, Crossing crossing) {
  const double signed_size = crossing == Crossing::positive ? j.determinant : std::abs(j.determinant);
  return signed_size > transversal * j.scale;
}

Jacobian jacobian_at(const Trilinear& f, const Vec3& x) {
  const TrilinearPlace at = place_of(x);
  return jacobian(derivative_u(f, at), derivative_v(f, at), derivative_tau(f, at));
}

/// Zero near x by Newton's method; none if it does not converge.
std::optional<Vec3> newton(const Trilinear& f, Vec3 x) {
  constexpr int max_steps = 12;
  constexpr double settled = 1e-15, stagnant = 1e-9;
  double last = std::numeric_limits<double>::infinity();
  for (int step = 0; step < max_steps; ++step) {
    const Jacobian j = jacobian_at(f, x);
    if (!(std::abs(j.determinant) > transversal * j.scale)) return std::nullopt;
    const Vec3 change = solve(j, value(f, place_of(x)));
    const double size = change.cwiseAbs().maxCoeff();
    if (!(size < 1e3)) return std::nullopt;
    x -= change;
    if (size <= settled || (size < stagnant && size >= last)) return x;  // rounding error reached
    last = size;
  }
  return last < stagnant ? std::optional(x) : std::nullopt;
}

enum class Verdict { empty, at_most_one, unknown };

struct Study {
  Verdict verdict = Verdict::unknown;
  Vec3 low = Vec3::Constant(-1), high = Vec3::Constant(1);  ///< in s: bounds of zeros
  Vec3 start = Vec3::Zero();                                ///< in s: Newton's first guess
};

/// The widest axis along which the function is nonlinear.
int bending_axis(const Local& d, const Vec3& half) {
  const double uv = d.d12.norm(), ut = d.d13.norm(), vt = d.d23.norm();
  const Vec3 bend(uv + ut, uv + vt, ut + vt);
  int widest = 2;
  double width = 0;
  for (int axis = 0; axis < 3; ++axis) {
    if (bend[axis] < 0.5 * bend.maxCoeff() || half[axis] <= width) continue;
    width = half[axis];
    widest = axis;
  }
  return widest;
}

/// Whether no zero in the cell can be a crossing: the upper bound of the determinant by the bounds of its three
/// columns.
bool never_crosses(const Local& d, const Jacobian& j, Crossing crossing) {
  const double a = d.d1.norm(), b = d.d2.norm(), c = d.d3.norm(), all = d.d123.norm();
  const double uv = d.d12.norm() + all, ut = d.d13.norm() + all, vt = d.d23.norm() + all;
  const double change = (a + uv + ut) * (b + uv + vt) * (c + ut + vt) - j.scale;
  const double middle = crossing == Crossing::positive ? j.determinant : std::abs(j.determinant);
  return middle + change <= transversal * j.scale;
}

Study study(const Local& d, Crossing crossing) {
  Study result;
  const Vec3 bend = d.d12.cwiseAbs() + d.d13.cwiseAbs() + d.d23.cwiseAbs() + d.d123.cwiseAbs();
  const Vec3 reach = d.d1.cwiseAbs() + d.d2.cwiseAbs() + d.d3.cwiseAbs() + bend;
  constexpr double rounding = 1e-15;
  const Vec3 margin = rounding * (d.d0.cwiseAbs() + reach);
  if (!(d.d0.cwiseAbs().array() <= (reach + margin).array()).all()) return {.verdict = Verdict::empty};

  const Jacobian j = jacobian(d.d1, d.d2, d.d3);
  if (never_crosses(d, j, crossing)) return {.verdict = Verdict::empty};
  if (!(std::abs(j.determinant) > transversal * j.scale)) return result;

  // preconditioned: s + p0 + p_ij s_i s_j + p_123 s_1 s_2 s_3 = 0
  const Vec3 uv = solve(j, d.d12).cwiseAbs(), ut = solve(j, d.d13).cwiseAbs(), vt = solve(j, d.d23).cwiseAbs();
  const Vec3 all = solve(j, d.d123).cwiseAbs();
  result.start = -solve(j, d.d0);
  const double doubt = 1e-9 + 64 * rounding * j.scale / std::abs(j.determinant);
  const Vec3 spread = (uv + ut + vt + all).array() * (1 + 1e-9) + doubt;
  result.low = (result.start - spread).cwiseMax(-1.0);
  result.high = (result.start + spread).cwiseMin(1.0);
  const double steepest = (2 * (uv + ut + vt) + 3 * all).maxCoeff();
  if (!(result.low.array() <= result.high.array()).all()) {
    result.verdict = Verdict::empty;
  } else if (steepest < 0.25) {
    const bool wrong_way = crossing == Crossing::positive && j.determinant < 0;  // and so in the whole cell
    result.verdict = wrong_way ? Verdict::empty : Verdict::at_most_one;
  }
  return result;
}

bool inside(const TrilinearDomain& domain, const Vec3& x) {
  return x[0] >= domain.low.u && x[0] <= domain.high.u && x[1] >= domain.low.v && x[1] <= domain.high.v &&
         x[2] >= domain.low.tau && x[2] <= domain.high.tau && x[0] + x[1] <= domain.sum_high;
}

class Search {
 public:
  Search(const Trilinear& f, const TrilinearDomain& domain, Crossing crossing)
      : f_(f), domain_(domain), crossing_(crossing) {
    const Vec3 low(domain.low.u, domain.low.v, domain.low.tau), high(domain.high.u, domain.high.v, domain.high.tau);
    push({0.5 * (low + high), 0.5 * (high - low)});
  }

  std::optional<TrilinearPlace> run() {
    for (int boxes = 0; count_ > 0; ++boxes) visit(stack_[--count_], boxes < most_boxes);
    return found_ ? std::optional(place_of(best_)) : std::nullopt;
  }

 private:
  void push(const Cell& cell) { stack_[count_++] = cell; }

  [[nodiscard]] bool worth_a_look(const Cell& cell) const {
    if (found_ && cell.middle[2] - cell.half[2] > best_[2]) return false;
    return cell.middle[0] - cell.half[0] + cell.middle[1] - cell.half[1] <= domain_.sum_high;
  }

  /// True if Newton's method ended at a zero; the zero is kept if it counts and is the earliest.
  bool settle(const Vec3& start) {
    const std::optional<Vec3> x = newton(f_, start);
    if (!x) return false;
    if (!inside(domain_, *x) || (found_ && (*x)[2] >= best_[2])) return true;
    if (crosses(jacobian_at(f_, *x), crossing_)) {
      best_ = *x;
      found_ = true;
    }
    return true;
  }

  void visit(const Cell& cell, bool divide) {
    if (!worth_a_look(cell)) return;
    const Local local = expand(f_, cell);
    const Study seen = study(local, crossing_);
    if (seen.verdict == Verdict::empty) return;
    const Vec3 start = cell.middle + cell.half.cwiseProduct(seen.start.cwiseMax(-1.0).cwiseMin(1.0));
    if (seen.verdict == Verdict::at_most_one && settle(start)) return;
    if (!divide || cell.half.maxCoeff() < smallest_box || count_ + 2 > stack_.size()) {
      settle(start);
      return;
    }
    const Cell rest{cell.middle + 0.5 * cell.half.cwiseProduct(seen.low + seen.high),
                    0.5 * cell.half.cwiseProduct(seen.high - seen.low)};
    if ((seen.high - seen.low).prod() < 2.0) {  // less than a quarter is left: repeat before dividing
      push(rest);
    } else {
      halve(rest, bending_axis(local, rest.half));
    }
  }

  /// The second half is pushed first, so that the earlier one is processed first.
  void halve(const Cell& cell, int axis) {
    Cell first = cell, second = cell;
    first.half[axis] = second.half[axis] = 0.5 * cell.half[axis];
    first.middle[axis] -= first.half[axis];
    second.middle[axis] += second.half[axis];
    push(second);
    push(first);
  }

  const Trilinear& f_;
  const TrilinearDomain& domain_;
  Crossing crossing_;
  std::array<Cell, 160> stack_;
  std::size_t count_ = 0;
  Vec3 best_ = Vec3::Zero();
  bool found_ = false;
};

/// Whether all points lie in one plane up to rounding: bodies sliding along each other have curves of common points.
bool slides(const Trilinear& f, const TrilinearDomain& domain) {
  const Cell whole{0.5 * Vec3(domain.low.u + domain.high.u, domain.low.v + domain.high.v, 1), Vec3::Constant(0.5)};
  const Local d = expand(f, whole);
  const Vec3 normal = d.d1.cross(d.d2);
  const double width = std::min(d.d1.norm(), d.d2.norm());
  if (!(normal.norm() > 1e-6 * width * width)) return false;  // no plane in the middle
  double change = 0;
  for (const Vec3* term : {&d.d3, &d.d12, &d.d13, &d.d23, &d.d123}) change += std::abs(term->dot(normal));
  return !(change > transversal * normal.norm() * width);
}

}  // namespace

Vec3 value(const Trilinear& f, const TrilinearPlace& x) {
  const Vec3 start = f.one + x.u * f.u + x.v * (f.v + x.u * f.uv);
  return start + x.tau * (f.tau + x.u * f.u_tau + x.v * (f.v_tau + x.u * f.uv_tau));
}

Vec3 derivative_u(const Trilinear& f, const TrilinearPlace& x) {
  return f.u + x.v * f.uv + x.tau * (f.u_tau + x.v * f.uv_tau);
}

Vec3 derivative_v(const Trilinear& f, const TrilinearPlace& x) {
  return f.v + x.u * f.uv + x.tau * (f.v_tau + x.u * f.uv_tau);
}

Vec3 derivative_tau(const Trilinear& f, const TrilinearPlace& x) {
  return f.tau + x.u * f.u_tau + x.v * (f.v_tau + x.u * f.uv_tau);
}

std::optional<TrilinearPlace> first_zero(const Trilinear& f, const TrilinearDomain& domain, Crossing crossing) {
  if (slides(f, domain)) return std::nullopt;
  return Search(f, domain, crossing).run();
}

}  // namespace brunt::geometry
