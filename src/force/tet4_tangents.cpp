// SPDX-License-Identifier: Apache-2.0
#include "tangent_loop.hpp"
#include "tet4_choice.hpp"

namespace brunt::force {

constinit const Tangents tet4_tangents = tangents_of<Tet4Choice>();

}  // namespace brunt::force
