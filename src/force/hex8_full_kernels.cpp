// SPDX-License-Identifier: Apache-2.0
#include "block_loop.hpp"
#include "hex8_full_choice.hpp"
#include "kernels.hpp"

namespace brunt::force {

constinit const Kernels hex8_full_kernels = kernels_of<Hex8FullChoice<false>>();

}  // namespace brunt::force
