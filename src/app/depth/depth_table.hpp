// SPDX-License-Identifier: Apache-2.0
// The table depth.csv of `brunt depth`: a row an answer, written and read back.
#pragma once
#include <span>
#include <string>

#include "depth_row.hpp"

namespace brunt::app {

[[nodiscard]] std::string csv_header();

/// Numbers in the shortest form that reads back to the same bits, names in quotes where they need them (RFC 4180); the
/// time stands last.
[[nodiscard]] std::string csv_row(const DepthRow& row);

/// What a row tells that an earlier run wrote.
struct EarlierRow {
  DepthRow row;              ///< all of its answer but motion and contacts, and nothing of what it was asked about
  PlacedScrew screw;         ///< of its motion
  std::size_t contacts = 0;  ///< their number
};

/// Throws InputError where the fields are not those of a row; place: of the row, for the message.
[[nodiscard]] EarlierRow row_of_record(std::span<const std::string> fields, const std::string& place);

}  // namespace brunt::app
