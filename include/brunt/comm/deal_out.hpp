// SPDX-License-Identifier: Apache-2.0
// Independent tasks dealt to the ranks as they become free.
#pragma once
#include <cstddef>
#include <functional>
#include <span>
#include <vector>

#include "brunt/comm/communicator.hpp"

namespace brunt::comm {

/// Calls work(k) for each k in [0, count) once, on whichever rank is free, the least k first. What it returns is handed
/// to take(k, bytes) on the root in the order of k, as soon as those before are there and the root is between two tasks
/// of its own. Results depend on k alone, so they are the same on any number of ranks. What `work` throws on one rank
/// the others do not know of: see app::guarded. Collective.
void deal_out(const Communicator& ranks, GlobalIndex count,
              const std::function<std::vector<std::byte>(GlobalIndex)>& work,
              const std::function<void(GlobalIndex, std::span<const std::byte>)>& take);

}  // namespace brunt::comm
