// SPDX-License-Identifier: Apache-2.0
#include "element/shell3.hpp"
#include "kernels.hpp"
#include "shell_loop.hpp"

namespace brunt::force {

constinit const Kernels shell3_kernels = shell_kernels_of<ShellChoice<element::Shell3>>();

}  // namespace brunt::force
