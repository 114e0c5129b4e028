// SPDX-License-Identifier: Apache-2.0
// The header of a PLY file: which elements follow, and of which properties an entry of each is made.
#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace brunt::io {

enum class PlyType { int8, uint8, int16, uint16, int32, uint32, float32, float64 };
enum class PlyEncoding { ascii, little_endian, big_endian };

struct PlyProperty {
  std::string name;
  PlyType type = PlyType::int8;   ///< of a scalar, or of the entries of a list
  std::optional<PlyType> length;  ///< type of the length of a list; none for a scalar
};

struct PlyElement {
  std::string name;
  std::int64_t count = 0;  ///< of entries
  std::int64_t line = 0;   ///< where the header announces it
  std::vector<PlyProperty> properties;

  /// Position in properties; no value where there is none of this name.
  [[nodiscard]] std::optional<std::size_t> find(std::string_view property) const;
};

struct PlyHeader {
  PlyEncoding encoding = PlyEncoding::ascii;
  std::vector<PlyElement> elements;  ///< in the order of the file
  std::size_t size = 0;              ///< bytes; the entries follow
  std::int64_t lines = 0;
};

[[nodiscard]] std::size_t size_of(PlyType type);  ///< bytes
[[nodiscard]] bool is_integer(PlyType type);

/// Least number of bytes that an entry takes: with empty lists, or as words of one digit.
[[nodiscard]] std::size_t least_size(const PlyElement& element, PlyEncoding encoding);

/// Throws InputError, "NAME:LINE: ...": what is no header; more entries than the rest of the file can hold.
[[nodiscard]] PlyHeader read_ply_header(std::string_view content, const std::string& name);

}  // namespace brunt::io
