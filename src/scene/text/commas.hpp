// SPDX-License-Identifier: Apache-2.0
// Commas in numbers: they may separate thousands ("7,800") or decimals ("0,9"), depending on the country.
#pragma once
#include <string>
#include <string_view>

#include "scene/text/reader.hpp"

namespace brunt::scene {

/// Whether a text is a value.
using IsValue = bool (*)(std::string_view text);

[[nodiscard]] bool is_number(std::string_view text);

/// Adds the fault of a value that would be valid without its commas, or with points instead; returns false for other
/// values.
bool comma_in_value(const Key& key, std::string_view expected, IsValue is_value = is_number);

/// The remark for a list of numbers that is longer than `size` because decimal commas separate its entries.
[[nodiscard]] std::string comma_in_list(const Tree& list, std::size_t size);

/// In {density: 7,800} the comma makes a key '800' without a value. Whether `name` is such a continuation of the
/// previous value.
[[nodiscard]] bool is_rest_of_number(const Tree& before, std::string_view name);

}  // namespace brunt::scene
