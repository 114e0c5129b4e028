// SPDX-License-Identifier: Apache-2.0
// Fields separated by commas: plain ones in manual input, and those of CSV tables with quotes (RFC 4180).
#pragma once
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace brunt::io {

/// Without spaces, tabs and carriage returns at both ends.
[[nodiscard]] std::string_view trimmed(std::string_view text);

/// The trimmed fields of a line, one more than its commas. Quotes have no meaning.
[[nodiscard]] std::vector<std::string_view> comma_fields(std::string_view line);

/// A field of a CSV table: the text itself, or in quotes if it contains a comma, a quote or an end of line.
[[nodiscard]] std::string csv_field(std::string_view text);

struct CsvRecords {
  std::vector<std::vector<std::string>> records;  ///< fields without their quotes
  std::size_t end = 0;  ///< of the last whole record: bytes of the text, its end of line included
};

/// The records of a CSV table that end with an end of line (LF or CR LF); an incomplete last record is omitted. Quoted
/// fields may contain commas, doubled quotes and ends of lines.
[[nodiscard]] CsvRecords csv_records(std::string_view text);

}  // namespace brunt::io
