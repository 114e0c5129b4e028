// SPDX-License-Identifier: Apache-2.0
// The rows of an interface of either kind: facets on facets, or nodes of sharp edges on facets.
#pragma once
#include "implicit/mortar/mortar.hpp"

namespace brunt::implicit {

/// Rows at the positions x, from the pairs of the last search.
void find_rows_at(Interface& face, std::span<const Vec3> x);

/// The same with derivatives; tractions, fixed, transposed: of contact::mortar_rows_and_slopes.
void find_slopes_at(Interface& face, std::span<const Vec3> x, std::span<const Vec3> tractions,
                    std::span<const Vec3> fixed = {}, std::span<const Vec3> transposed = {});

}  // namespace brunt::implicit
