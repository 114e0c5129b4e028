// SPDX-License-Identifier: Apache-2.0
#include "element/shell4_full.hpp"
#include "kernels.hpp"
#include "shell_loop.hpp"

namespace brunt::force {

constinit const Kernels shell4_full_kernels = shell_kernels_of<ShellChoice<element::Shell4Full>>();

}  // namespace brunt::force
