// SPDX-License-Identifier: Apache-2.0
// Keywords of the Abaqus Keywords Guide that cannot change a mesh: materials, interactions, steps, loads, output.
#pragma once
#include <string_view>

namespace brunt::io {

/// name: in capitals and without blanks.
bool is_other_keyword(std::string_view name);

}  // namespace brunt::io
