// SPDX-License-Identifier: Apache-2.0
#include "hex8_full_choice.hpp"
#include "tangent_loop.hpp"

namespace brunt::force {

constinit const Tangents hex8_full_tangents = tangents_of<Hex8FullChoice<false>>();

}  // namespace brunt::force
