// SPDX-License-Identifier: Apache-2.0
#include "element/shell4.hpp"
#include "kernels.hpp"
#include "shell_loop.hpp"

namespace brunt::force {

constinit const Kernels shell4_kernels = shell_kernels_of<ShellChoice<element::Shell4>>();

}  // namespace brunt::force
