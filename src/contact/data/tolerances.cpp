// SPDX-License-Identifier: Apache-2.0
#include "contact/data/tolerances.hpp"

namespace brunt::contact {

const Tolerances standard_tolerances{};

}  // namespace brunt::contact
