// SPDX-License-Identifier: Apache-2.0
#include "block_loop.hpp"
#include "kernels.hpp"
#include "tet4_choice.hpp"

namespace brunt::force {

constinit const Kernels tet4_kernels = kernels_of<Tet4Choice>();

}  // namespace brunt::force
