// SPDX-License-Identifier: Apache-2.0
// The numbers of contact (data/tolerances.hpp) for those who only hand them on: a value that changes there compiles
// nothing of theirs.
#pragma once

namespace brunt::contact {

struct Tolerances;
extern const Tolerances standard_tolerances;

}  // namespace brunt::contact
