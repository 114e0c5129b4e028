// SPDX-License-Identifier: Apache-2.0
// Elements that are inverted at a corner. The one-point hexahedron evaluates its mean gradient and its volume only.
// Plastic flow limits the hourglass forces, so a corner can fold without resistance while the volume remains positive.
// The points of the other hexahedra see a folded corner late. Contact loses the nodes behind such faces.
#pragma once
#include "model/model.hpp"

namespace brunt::force {

struct FoldedElements {
  GlobalIndex count = 0;
  double worst = 0;  ///< smallest Jacobian at a corner divided by the largest one of its element; 0: none is negative
  GlobalIndex element = -1;  ///< of that element: position in the input, the last one of equals
  std::int32_t block = -1;
};

/// For this rank's hexahedra that are not rigid, at x_n. A corner counts below -1e-6: the corner of a wedge is flat up
/// to rounding.
FoldedElements folded_elements(const model::Model& model, const model::State& state);

}  // namespace brunt::force
