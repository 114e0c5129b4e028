// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace brunt::comm {

/// Restricts the BLAS of this program to one thread. With several threads the terms of a product are added in another
/// order, and the cores are used by the ranks. Does nothing for a BLAS without threads.
void keep_blas_on_one_thread();

}  // namespace brunt::comm
