// SPDX-License-Identifier: Apache-2.0
// Plane stress for laws of solids: the strain normal to the plane at which the normal stress vanishes.
//
// A rate law gives the stress of the end of a step for any strain increment. The normal stress is an increasing
// function of the normal strain, with a slope between the bulk modulus (flow) and lambda + 2 mu (elastic), so its zero
// is found by a safeguarded secant iteration of the law itself: exact for every law, without a second form of it.
// Elastic steps need one evaluation. Each lane ends by itself, so its result does not depend on the others.
#pragma once
#include <algorithm>
#include <limits>

#include "core/simd.hpp"
#include "element/memory.hpp"

namespace brunt::element {

namespace plane_stress_detail {

constexpr int most_evaluations = 40;  ///< bisection included; the secant iteration needs 3 to 7
constexpr double near = 1e-12;        ///< normal stress left, over the stresses and elastic increments of the step

/// One evaluation of a law, from the state of the start of the step.
template <class Response>
struct Trial {
  Pack stress[6], tensors[std::max(6 * Response::tensors, 1)], scalars[std::max(Response::scalars, 1)];
  Pack left;
};

template <class Response>
BRUNT_INLINE void evaluate(const Response& law, const Pack (&de)[6], double dt, const Trial<Response>& start,
                           Trial<Response>& end) {
  end = start;
  if constexpr (Thermodynamic<Response>)
    end.left = law.update(de, {dt, broadcast(1.0), broadcast(0.0)}, end.stress, end.scalars);
  else
    end.left = law.update(de, end.stress, end.tensors, end.scalars);
}

/// Slope of the normal stress over the normal strain in radial return without hardening: K + 4/3 mu b - 2 mu b n^2, b
/// the share of the trial deviator that is left and n the normal entry of the unit deviator.
BRUNT_INLINE Pack flow_slope(double lambda, double mu, const Pack (&s)[6], Pack left) {
  const Pack mean = (s[0] + s[1] + s[2]) * (1.0 / 3.0);
  const Pack x = s[0] - mean, y = s[1] - mean, z = s[2] - mean;
  const Pack norm2 = x * x + y * y + z * z + 2.0 * (s[3] * s[3] + s[4] * s[4] + s[5] * s[5]);
  const Pack share = z * z / pack_max(norm2, broadcast(std::numeric_limits<double>::min()));
  return (lambda + 2.0 / 3.0 * mu) + (2.0 * mu) * left * (2.0 / 3.0 - share);
}

}  // namespace plane_stress_detail

/// Stress (zz stays zero), tensors and scalars from the start of the step, turned to its end, to its end. Of the strain
/// increment `de` the entry zz is the result. Returns the share of the trial deviator that plastic flow leaves. The
/// relative volume that some laws read is 1: a failed point of a shell carries nothing.
template <class Response>
BRUNT_INLINE Pack update_plane_stress(const Response& law, double dt, Pack (&de)[6], Pack (&stress)[6],
                                      [[maybe_unused]] Pack* tensors, [[maybe_unused]] Pack* scalars) {
  using namespace plane_stress_detail;
  const double wave = law.lambda + 2 * law.mu;
  de[2] = (-law.lambda / wave) * (de[0] + de[1]);
  if constexpr (Response::scalars == 0 && Response::tensors == 0 && !Thermodynamic<Response>) {
    const Pack left = law.update(de, stress, tensors, scalars);
    stress[2] = broadcast(0.0);
    return left;
  } else {
    Trial<Response> start, end;
    for (int c = 0; c < 6; ++c) start.stress[c] = stress[c];
    for (int c = 0; c < 6 * Response::tensors; ++c) start.tensors[c] = tensors[c];
    for (int c = 0; c < Response::scalars; ++c) start.scalars[c] = scalars[c];
    evaluate(law, de, dt, start, end);
    const Pack scale = pack_abs(stress[0]) + pack_abs(stress[1]) + pack_abs(stress[3]) +
                       wave * (pack_abs(de[0]) + pack_abs(de[1]) + pack_abs(de[2]));
    PackMask open = (end.left != 1.0) & (pack_abs(end.stress[2]) > near * scale);
    Pack low = broadcast(-std::numeric_limits<double>::infinity()), high = -low, before{}, stress_before{};
    for (int n = 1; n < most_evaluations && any(open); ++n) {
      const Pack normal = end.stress[2];
      low = select(normal < 0.0, de[2], low);
      high = select(normal > 0.0, de[2], high);
      Pack slope = flow_slope(law.lambda, law.mu, end.stress, end.left);
      if (n > 1) {
        const Pack secant = (normal - stress_before) / (de[2] - before);
        slope = select((secant > 0.0) & (secant < 2.0 * wave), secant, slope);
      }
      Pack next = de[2] - normal / slope;
      const Pack middle = 0.5 * (low + high);
      next = select((next > low) & (next < high), next, select((low < high) & (high - low < 1e300), middle, next));
      before = de[2];
      stress_before = normal;
      de[2] = select(open, next, de[2]);
      evaluate(law, de, dt, start, end);
      open &= (pack_abs(end.stress[2]) > near * scale) & (de[2] != before);
    }
    for (int c = 0; c < 6; ++c) stress[c] = end.stress[c];
    for (int c = 0; c < 6 * Response::tensors; ++c) tensors[c] = end.tensors[c];
    for (int c = 0; c < Response::scalars; ++c) scalars[c] = end.scalars[c];
    stress[2] = broadcast(0.0);
    return end.left;
  }
}

}  // namespace brunt::element
