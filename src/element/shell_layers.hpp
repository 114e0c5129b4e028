// SPDX-License-Identifier: Apache-2.0
// Stresses through the thickness of a shell at one point of its surface, and their resultants.
//
// Strains are linear over the thickness, e(z) = membrane + z curvature, the transverse shears constant. All components
// are those in the axes of the element (or of the point), which turn in their own plane; stresses are turned by the
// spin of the material less that of the axes.
#pragma once
#include <algorithm>
#include <string>
#include <vector>

#include "element/batch.hpp"
#include "element/memory.hpp"
#include "element/options.hpp"
#include "element/plane_stress.hpp"
#include "element/shell_batch.hpp"
#include "element/shell_section.hpp"

namespace brunt::element {

/// Shear correction: a constant transverse shear has 6/5 of the energy of the parabola of the same resultant
/// (E. Reissner, J. Appl. Mech. 12 (1945) A69).
constexpr double shear_correction = 5.0 / 6.0;

/// Rotation in the plane of a shell, and the double of its angle, which tensors turn by.
struct PlaneTurn {
  Pack c, s, c2, s2;
};

/// From the spin of the material in the step about the normal (Cayley's vector in the midpoint configuration), less the
/// turn of a vector that has the length `length` along the first axis in the midpoint configuration and changes by
/// (dx, dy) in the step. Both are exact for rigid rotation of any size, so that nothing is left there.
BRUNT_INLINE PlaneTurn plane_turn(Pack spin, Pack length, Pack dx, Pack dy) {
  const Pack dot = length * length - 0.25 * (dx * dx + dy * dy), cross = length * dy;
  const Pack material = 1.0 - 0.25 * spin * spin;  // with spin: (1 + i spin/2)^2
  const Pack x = material * dot + spin * cross, y = spin * dot - material * cross;
  const Pack over = 1.0 / pack_sqrt(x * x + y * y);
  PlaneTurn turn;
  turn.c = over * x;
  turn.s = over * y;
  turn.c2 = turn.c * turn.c - turn.s * turn.s;
  turn.s2 = 2.0 * turn.c * turn.s;
  return turn;
}

BRUNT_INLINE void turn_vector(const PlaneTurn& turn, Pack& x, Pack& y) {
  const Pack a = turn.c * x - turn.s * y;
  y = turn.s * x + turn.c * y;
  x = a;
}
BRUNT_INLINE void turn_tensor(const PlaneTurn& turn, Pack& xx, Pack& yy, Pack& xy) {
  const Pack mean = 0.5 * (xx + yy), half = 0.5 * (xx - yy);
  const Pack turned = turn.c2 * half - turn.s2 * xy;
  xy = turn.s2 * half + turn.c2 * xy;
  xx = mean + turned;
  yy = mean - turned;
}

/// Increments of a step, tensor components xx, yy, xy and zx, yz.
struct ShellStrain {
  Pack membrane[3], curvature[3], shear[2];

  /// From the midpoint to the end of the step, whose axes the material leads by the angle of `turn`: the term of second
  /// order of `seen_from_end` (objective.hpp).
  BRUNT_INLINE void see_from_end(const PlaneTurn& turn) {
    const Pack w = turn.s;
    for (Pack* e : {membrane, curvature}) {
      const Pack xx = e[0], yy = e[1], xy = e[2];
      e[0] = xx - w * xy;
      e[1] = yy + w * xy;
      e[2] = xy + 0.5 * w * (xx - yy);
    }
    const Pack x = shear[0], y = shear[1];
    shear[0] = x - 0.5 * w * y;
    shear[1] = y + 0.5 * w * x;
  }
};

/// Integrals over the thickness of the stress at the end of the step, and what else the points give.
struct ShellResultants {
  Pack force[3]{}, moment[3]{}, shear[2]{};  ///< xx, yy, xy [stress length], [stress length^2]; zx, yz [stress length]
  Pack normal_strain{};                      ///< mean of the increment zz
  Pack lost{}, lost_in_bending{};            ///< shares of the trial deviator that flow takes; means by weight, inertia
  Pack stress2{};                            ///< largest sum of squares of a stress
};

/// Beginning of the history of the points of a fibre, and the distance of a law's scalars of one point.
template <class Number>
struct FibreMemory {
  Number *stress, *tensors, *scalars;
  int stride;
};

/// Numbers of one element with `in_plane` points, in this order: mass, rotary inertia, thickness; local stresses (xx,
/// yy, xy, yz, zx for each point); tensors of the law; its scalars (one name after the other, its points together).
/// Points: from the bottom to the top of one fibre, then the next fibre.
template <class Response, int in_plane>
struct ShellMemory {
  static constexpr int at_thickness = 2, at_stress = 3;
  static constexpr int most =
      at_stress + (5 + 6 * Response::tensors + Response::scalars) * in_plane * ShellSection::most_points;

  int layers;
  explicit constexpr ShellMemory(const ShellSection& section) : layers(section.points) {}
  [[nodiscard]] constexpr int points() const { return in_plane * layers; }
  [[nodiscard]] constexpr int at_tensors() const { return at_stress + 5 * points(); }
  [[nodiscard]] constexpr int at_scalars() const { return at_tensors() + 6 * Response::tensors * points(); }
  [[nodiscard]] constexpr int size() const { return at_scalars() + Response::scalars * points(); }

  template <class Number>
  [[nodiscard]] FibreMemory<Number> fibre(Number* history, int p = 0) const {
    return {history + at_stress + 5 * layers * p, history + at_tensors() + 6 * Response::tensors * layers * p,
            history + at_scalars() + layers * p, points()};
  }

  [[nodiscard]] std::vector<HistoryField> fields([[maybe_unused]] const Response& law, double thickness) const {
    std::vector<HistoryField> all{
        {"mass", 1}, {"rotary_inertia", 1}, {"thickness", 1, thickness}, {"local_stress", 5 * points()}};
    if (Response::tensors > 0) all.push_back({"back_stress", 6 * Response::tensors * points()});
    if constexpr (Thermodynamic<Response>) {
      for (const auto& scalar : law.fields()) all.push_back({scalar.name, points(), scalar.start});
    } else if (Response::scalars > 0)
      all.push_back({"plastic_strain", Response::scalars * points()});
    return all;
  }
};

/// Stress, tensors and scalars of one point from the start of the step to its end; `s`: xx, yy, xy, yz, zx. Returns the
/// share of the trial deviator left; de[2] becomes the increment zz.
template <class Response>
BRUNT_INLINE Pack follow_point(const Response& law, const PlaneTurn& turn, double dt, Pack (&de)[6],
                               const FibreMemory<const Pack>& committed, const FibreMemory<Pack>& trial, int k,
                               Pack (&s)[6]) {
  const Pack* before = committed.stress + 5 * k;
  s[0] = before[0];
  s[1] = before[1];
  s[2] = broadcast(0.0);
  s[3] = before[2];
  s[4] = before[3];
  s[5] = before[4];
  turn_tensor(turn, s[0], s[1], s[3]);
  turn_vector(turn, s[5], s[4]);
  Pack tensors[std::max(6 * Response::tensors, 1)], scalars[std::max(Response::scalars, 1)];
  for (int t = 0; t < Response::tensors; ++t) {
    Pack* tensor = tensors + 6 * t;
    for (int c = 0; c < 6; ++c) tensor[c] = committed.tensors[6 * (Response::tensors * k + t) + c];
    turn_tensor(turn, tensor[0], tensor[1], tensor[3]);
    turn_vector(turn, tensor[5], tensor[4]);
  }
  for (int i = 0; i < Response::scalars; ++i) scalars[i] = committed.scalars[i * committed.stride + k];
  const Pack left = update_plane_stress(law, dt, de, s, tensors, scalars);
  for (int c = 0; c < 6 * Response::tensors; ++c) trial.tensors[6 * Response::tensors * k + c] = tensors[c];
  for (int i = 0; i < Response::scalars; ++i) trial.scalars[i * trial.stride + k] = scalars[i];
  Pack* after = trial.stress + 5 * k;
  after[0] = s[0];
  after[1] = s[1];
  after[2] = s[3];
  after[3] = s[4];
  after[4] = s[5];
  return left;
}

/// All points of a fibre. `strain` is seen from the end of the step; heights follow the thickness of its start, the
/// resultants are for a thickness of one: ShellResultants::scale multiplies them by that of the end.
template <class Response>
BRUNT_INLINE void follow_fibre(const Response& law, const ShellSection& section, Pack thickness,
                               const ShellStrain& strain, const PlaneTurn& turn, double dt,
                               const FibreMemory<const Pack>& committed, const FibreMemory<Pack>& trial,
                               ShellResultants& sum) {
  const ThicknessPoints& rule = thickness_points(section);
  const double over_second = rule.second > 0 ? 1 / rule.second : 0;
  for (int k = 0; k < rule.count; ++k) {
    const double height = rule.at[k] + section.offset, weight = rule.weight[k];
    const Pack z = height * thickness;
    Pack de[6], s[6];
    de[0] = strain.membrane[0] + z * strain.curvature[0];
    de[1] = strain.membrane[1] + z * strain.curvature[1];
    de[3] = strain.membrane[2] + z * strain.curvature[2];
    de[4] = strain.shear[1];
    de[5] = strain.shear[0];
    const Pack left = follow_point(law, turn, dt, de, committed, trial, k, s);
    const Pack in_plane[3] = {s[0], s[1], s[3]};
    for (int c = 0; c < 3; ++c) {
      sum.force[c] += weight * in_plane[c];
      sum.moment[c] += (weight * height) * in_plane[c];
    }
    sum.shear[0] += (weight * shear_correction) * s[5];
    sum.shear[1] += (weight * shear_correction) * s[4];
    sum.normal_strain += weight * de[2];
    sum.lost += weight * (1.0 - left);
    sum.lost_in_bending += over_second * (weight * rule.at[k] * rule.at[k]) * (1.0 - left);
    sum.stress2 = pack_max(sum.stress2, s[0] * s[0] + s[1] * s[1] + 2.0 * (s[3] * s[3] + s[4] * s[4] + s[5] * s[5]));
  }
}

/// Multiplies the resultants by the thickness (its square for moments).
BRUNT_INLINE void scale(ShellResultants& sum, Pack thickness) {
  const Pack square = thickness * thickness;
  for (int c = 0; c < 3; ++c) {
    sum.force[c] *= thickness;
    sum.moment[c] *= square;
  }
  for (Pack& q : sum.shear) q *= thickness;
}

/// The thickness at the end of a step with the increment e of the strain normal to the shell.
BRUNT_INLINE Pack thinned(Pack thickness, Pack e) {
  return thickness * ((1.0 + 0.5 * e) / (1.0 - 0.5 * e));
}

}  // namespace brunt::element
