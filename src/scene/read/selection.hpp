// SPDX-License-Identifier: Apache-2.0
// The keys `part` and `set`, by which entries of lists select nodes, faces or elements.
#pragma once
#include <string>
#include <vector>

#include "scene/keys/table.hpp"

namespace brunt::scene {

/// Both keys, of which one is required. Parts are noted as references; sets are judged when the mesh is known.
template <class T>
std::vector<Row<T>> selection(std::string T::*where, std::string of_part = "Name of a part.",
                              std::string of_set = "Name of a set.") {
  return {
      {"part", value(where, Named::part), "-", std::move(of_part), "required, or `set`"},
      {"set", value(where, Text{"name", "the name of a set or part"}), "-", std::move(of_set), "required, or `part`"}};
}

/// The faults of both keys, or none.
inline void judge_selection(const Key& map) {
  demand_one(map, {"part", "set"}, "missing selection; expected part: name, or set: name",
             "invalid selection: part and set are both given; expected one of them");
}

}  // namespace brunt::scene
