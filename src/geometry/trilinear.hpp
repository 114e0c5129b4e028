// SPDX-License-Identifier: Apache-2.0
// First zero of a vector that is linear in each of two coordinates and time. The distance vector of two moving objects
// that are linear in their coordinates (node and bilinear face, edge and edge, segment and face) is such a function, so
// one solver finds all their intersections.
#pragma once
#include <limits>
#include <optional>

#include "core/types.hpp"

namespace brunt::geometry {

/// D(u, v, tau) = one + u D_u + v D_v + tau D_tau + u v D_uv + u tau D_ut + v tau D_vt + u v tau D_uvt  [length]
struct Trilinear {
  Vec3 one = Vec3::Zero(), u = Vec3::Zero(), v = Vec3::Zero(), tau = Vec3::Zero();
  Vec3 uv = Vec3::Zero(), u_tau = Vec3::Zero(), v_tau = Vec3::Zero(), uv_tau = Vec3::Zero();
};

struct TrilinearPlace {
  double u = 0, v = 0, tau = 0;
};

Vec3 value(const Trilinear& distance, const TrilinearPlace& at);
Vec3 derivative_u(const Trilinear& distance, const TrilinearPlace& at);
Vec3 derivative_v(const Trilinear& distance, const TrilinearPlace& at);
Vec3 derivative_tau(const Trilinear& distance, const TrilinearPlace& at);

/// Domain of the search, boundaries included: a box, restricted to u + v <= sum_high (for triangles).
struct TrilinearDomain {
  TrilinearPlace low, high{1, 1, 1};
  double sum_high = std::numeric_limits<double>::infinity();
};

/// The zeros that count, by the sign of (D_u x D_v) . D_tau there.
enum class Crossing { positive, either };

/// A zero counts as a crossing if the ratio |(D_u x D_v) . D_tau| / (|D_u| |D_v| |D_tau|), comparable to a sine, is
/// above this value: sliding and mere touching do not count.
constexpr double transversal = 1e-12;

/// The zero of smallest tau in the domain, exact to rounding (about 1e-16 |D| / (|D_tau| ratio) in tau); empty if there
/// is none. Boxes of (u, v, tau) are bisected, earliest first. A box is discarded if the bounds of the polynomial
/// exclude a zero. It is finished by Newton's method if the function, preconditioned by its derivative at the centre,
/// is proven to have at most one zero (R. Krawczyk, Computing 4 (1969) 187; for a trilinear function the bounds are
/// sums of absolute values of its coefficients). The work is bounded, nothing is allocated, and values that are not
/// finite give an empty result.
std::optional<TrilinearPlace> first_zero(const Trilinear& distance, const TrilinearDomain& domain, Crossing crossing);

}  // namespace brunt::geometry
