// SPDX-License-Identifier: Apache-2.0
// Several parts as one rigid body: parts that join another one, which names the body.
#include <algorithm>

#include "scene/build/rigid_parts.hpp"

namespace brunt::scene {

const std::string& lead_of(const Input& input, const std::string& part) {
  const auto found = std::ranges::find(input.parts, part, &Part::name);
  const bool joins = found != input.parts.end() && found->rigid && !found->rigid->joins.empty();
  return joins ? found->rigid->joins : part;
}

bool are_one_body(const Input& input, const std::string& a, const std::string& b) {
  return names_rigid_part(input, a) && names_rigid_part(input, b) && lead_of(input, a) == lead_of(input, b);
}

}  // namespace brunt::scene
