// SPDX-License-Identifier: Apache-2.0
// Overlap at the start of round surfaces, which facets represent by chords: press fits.
#pragma once
#include <span>
#include <vector>

#include "contact/mortar/interface.hpp"

namespace brunt::implicit {

/// Means over the area where round surfaces through the nodes of both sides lie in each other [length].
struct RoundSeat {
  double of_facets = 0;    ///< how deep the facets do
  double of_surfaces = 0;  ///< how deep these surfaces do
  double deepest = 0;      ///< how deep a node lies behind a facet at most: facets of thin rings meet only there
  bool conform = false;    ///< one is convex there, the other one concave: a shaft in its bore
};

/// 0 if nothing overlaps. reach: how deep facets of a pair may lie in each other.
RoundSeat round_seat(const contact::MortarSurfaces& surfaces, std::span<const Vec3> x, double reach);

}  // namespace brunt::implicit
