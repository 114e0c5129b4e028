// SPDX-License-Identifier: Apache-2.0
// Elements that are turned inside out at a corner. The one-point hexahedron sees its mean gradient and its volume
// alone: plastic flow takes the hourglass forces with it, and then nothing holds a corner that folds, while the volume
// stays positive. Contact loses the nodes behind such faces.
#pragma once
#include "brunt/model/model.hpp"

namespace brunt::force {

struct FoldedElements {
  GlobalIndex count = 0;
  double worst = 0;          ///< smallest Jacobian at a corner over the largest in size of its element; 0: none < 0
  GlobalIndex element = -1;  ///< of which it is: position in the input, the last one of equals
  std::int32_t block = -1;
};

/// Of this rank's one-point hexahedra, at x_n. A corner counts from -1e-6 on: one of a wedge is flat, to rounding.
FoldedElements folded_elements(const model::Model& model, const model::State& state);

}  // namespace brunt::force
