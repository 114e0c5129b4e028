// SPDX-License-Identifier: Apache-2.0
// Fields between commas: plain ones, as people write them by hand, and those of CSV tables with quotes (RFC 4180).
#pragma once
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace brunt::io {

/// Without spaces, tabs and carriage returns at its ends.
[[nodiscard]] std::string_view trimmed(std::string_view text);

/// What stands between the commas of a line, trimmed: one field more than commas. Quotes have no meaning.
[[nodiscard]] std::vector<std::string_view> comma_fields(std::string_view line);

/// A field of a CSV table: the text itself, or in quotes if it holds a comma, a quote or an end of line.
[[nodiscard]] std::string csv_field(std::string_view text);

struct CsvRecords {
  std::vector<std::vector<std::string>> records;  ///< fields without their quotes
  std::size_t end = 0;  ///< of the last whole record: bytes of the text, its end of line included
};

/// The records of a CSV table that end in an end of line (LF or CR LF); one that is cut off at the end of the text is
/// left out. Quoted fields may hold commas, doubled quotes and ends of lines.
[[nodiscard]] CsvRecords csv_records(std::string_view text);

}  // namespace brunt::io
