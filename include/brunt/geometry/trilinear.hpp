// SPDX-License-Identifier: Apache-2.0
// First zero of a vector that is linear in each of two places and the time. Between two moving things of which each is
// linear along its coordinate (node and bilinear face, edge and edge, segment and face) the distance vector is such a
// function, so one solver finds all their meetings.
#pragma once
#include <limits>
#include <optional>

#include "brunt/core/types.hpp"

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

/// Where zeros are looked for, borders included: a box, cut off by u + v <= sum_high (for triangles).
struct TrilinearDomain {
  TrilinearPlace low, high{1, 1, 1};
  double sum_high = std::numeric_limits<double>::infinity();
};

/// Which zeros count, by the sign of (D_u x D_v) . D_tau there.
enum class Crossing { positive, either };

/// A zero counts as a crossing where the sine-like ratio |(D_u x D_v) . D_tau| / (|D_u| |D_v| |D_tau|) is above this:
/// what slides along or only touches does not cross.
constexpr double transversal = 1e-12;

/// The zero of least tau in the domain, exact to rounding (about 1e-16 |D| / (|D_tau| ratio) in tau); nothing if there
/// is none. Boxes of (u, v, tau) are cut in halves, earliest first. A box is dropped where the bounds of the polynomial
/// exclude a zero, and finished by Newton's method where the function, preconditioned by its derivative in the middle,
/// is proven to have at most one (R. Krawczyk, Computing 4 (1969) 187; for a trilinear function the bounds are sums of
/// absolute values of its coefficients). The work is bounded; no allocation; not-finite input gives nothing.
std::optional<TrilinearPlace> first_zero(const Trilinear& distance, const TrilinearDomain& domain, Crossing crossing);

}  // namespace brunt::geometry
