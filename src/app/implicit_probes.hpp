// SPDX-License-Identifier: Apache-2.0
// What probes of contact see in implicit runs.
#pragma once
#include <string>

#include "brunt/contact/contact_ledger.hpp"
#include "prepare.hpp"

namespace brunt::app {

/// Impulses that the other part (empty: all others) has exerted on `part` through mortar interfaces since t = 0.
contact::TrackedTotals watched_contact(const Prepared& run, const std::string& part, const std::string& other);

}  // namespace brunt::app
