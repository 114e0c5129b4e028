// SPDX-License-Identifier: Apache-2.0
// Commas in numbers: of thousands ("7,800") or decimal ("0,9"), they mean another thing in every country.
#pragma once
#include <string>
#include <string_view>

#include "brunt/scene/reader.hpp"

namespace brunt::scene {

/// Does a text stand for a value?
using IsValue = bool (*)(std::string_view text);

[[nodiscard]] bool is_number(std::string_view text);

/// Tells the fault of a value that has commas and would be one without them, or with points; false where it has none.
bool comma_in_value(const Key& key, std::string_view expected, IsValue is_value = is_number);

/// What to say of a list of numbers that is longer than `size` because decimal commas part its entries.
[[nodiscard]] std::string comma_in_list(const Tree& list, std::size_t size);

/// In {density: 7,800} the comma makes a key '800' without a value: is `name` such a piece of the value before it?
[[nodiscard]] bool is_rest_of_number(const Tree& before, std::string_view name);

}  // namespace brunt::scene
