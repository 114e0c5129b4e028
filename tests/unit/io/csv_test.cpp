// SPDX-License-Identifier: Apache-2.0
// Fields between commas, and tables with quotes: what is written is read back.
#include "io/csv.hpp"

#include <catch2/catch.hpp>

using namespace brunt::io;
using Fields = std::vector<std::string_view>;
using Record = std::vector<std::string>;

TEST_CASE("csv: fields of a line are trimmed, and there is one more than commas") {
  CHECK(comma_fields("") == Fields{""});
  CHECK(comma_fields("a") == Fields{"a"});
  CHECK(comma_fields(" x,\ty y ,, \"z\" ,\r") == Fields{"x", "y y", "", "\"z\"", ""});
  CHECK(trimmed(" \t\r").empty());
}

TEST_CASE("csv: a field is quoted where it would not be read back") {
  CHECK(csv_field("left.stl") == "left.stl");
  CHECK(csv_field("a, b.stl") == "\"a, b.stl\"");
  CHECK(csv_field("5\" bolt") == "\"5\"\" bolt\"");
  CHECK(csv_field("") == "");
}

TEST_CASE("csv: records are read back, whatever their fields hold; one that is cut off is left out") {
  const Record texts{"plain", "a, b", "5\" bolt", "two\nlines", "", "\"", "ends in CR\r"};
  std::string table;
  for (int row = 0; row < 2; ++row)
    for (std::size_t k = 0; k < texts.size(); ++k)
      table += csv_field(texts[k]) + (k + 1 < texts.size() ? "," : row == 0 ? "\n" : "\r\n");
  const CsvRecords read = csv_records(table);
  REQUIRE(read.records.size() == 2);
  CHECK(read.records[0] == texts);
  CHECK(read.end == table.size());
  for (const char* rest : {"x", "1,2,3", "\"open\n", "\"open\n\n,"}) {
    const CsvRecords cut = csv_records(table + rest);
    CHECK(cut.records.size() == 2);
    CHECK(cut.end == table.size());
  }
  CHECK(csv_records("a,b\r\n").records == std::vector<Record>{{"a", "b"}});
  CHECK(csv_records("").records.empty());
}
