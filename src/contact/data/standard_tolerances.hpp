// SPDX-License-Identifier: Apache-2.0
// The tolerances of contact (data/tolerances.hpp) for code that only passes them on: a change of a value there does not
// recompile it.
#pragma once

namespace brunt::contact {

struct Tolerances;
extern const Tolerances standard_tolerances;

}  // namespace brunt::contact
