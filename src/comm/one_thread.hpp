// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace brunt::comm {

/// From here on the BLAS that this program was given runs on one thread. With several, a product's terms are added in
/// another order, and the cores belong to the ranks. Does nothing for a BLAS without threads.
void keep_blas_on_one_thread();

}  // namespace brunt::comm
