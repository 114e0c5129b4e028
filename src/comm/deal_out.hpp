// SPDX-License-Identifier: Apache-2.0
// Independent tasks distributed to the ranks as they become idle.
#pragma once
#include <cstddef>
#include <functional>
#include <span>
#include <vector>

#include "comm/communicator.hpp"

namespace brunt::comm {

/// Calls work(k) once for each k in [0, count), on any idle rank, smallest k first. The result is passed to take(k,
/// bytes) on the root in the order of k, as soon as all earlier results have arrived and the root is between two tasks
/// of its own. Results depend on k only, so they are the same on any number of ranks. An exception thrown by `work` on
/// one rank is not known to the others: see app::guarded. Collective.
void deal_out(const Communicator& ranks, GlobalIndex count,
              const std::function<std::vector<std::byte>(GlobalIndex)>& work,
              const std::function<void(GlobalIndex, std::span<const std::byte>)>& take);

}  // namespace brunt::comm
