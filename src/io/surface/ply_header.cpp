// SPDX-License-Identifier: Apache-2.0
// PLY: the header (see there).
#include "ply_header.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <set>

#include "core/error.hpp"
#include "core/excerpt.hpp"
#include "surface_text.hpp"

namespace brunt::io {
namespace {

struct TypeName {
  std::string_view name;
  PlyType type;
};
constexpr std::array<TypeName, 16> type_names = {{{"char", PlyType::int8},
                                                  {"uchar", PlyType::uint8},
                                                  {"short", PlyType::int16},
                                                  {"ushort", PlyType::uint16},
                                                  {"int", PlyType::int32},
                                                  {"uint", PlyType::uint32},
                                                  {"float", PlyType::float32},
                                                  {"double", PlyType::float64},
                                                  {"int8", PlyType::int8},
                                                  {"uint8", PlyType::uint8},
                                                  {"int16", PlyType::int16},
                                                  {"uint16", PlyType::uint16},
                                                  {"int32", PlyType::int32},
                                                  {"uint32", PlyType::uint32},
                                                  {"float32", PlyType::float32},
                                                  {"float64", PlyType::float64}}};

class HeaderParser {
 public:
  HeaderParser(std::string_view content, const std::string& name)
      : content_(content), name_(name), in_(content, name) {}

  PlyHeader parse() {
    in_.next_filled_line();
    if (const std::string_view word = in_.word(); word != "ply")
      in_.fail(fmt::format("invalid beginning '{}' of the file; expected 'ply'", excerpt(word)));
    while (parse_line()) continue;
    if (!has_format_) in_.fail("missing format; expected 'format ascii 1.0' or a binary one");
    header_.size = std::min(in_.next(), content_.size());
    header_.lines = in_.line();
    check_counts();
    return std::move(header_);
  }

 private:
  /// False after end_header.
  bool parse_line() {
    if (!in_.next_line()) in_.fail("missing end of the header; expected 'end_header'");
    const std::string_view keyword = in_.word();
    if (keyword == "end_header") return false;
    if (keyword.empty() || keyword == "comment" || keyword == "obj_info") return true;
    if (keyword == "format")
      parse_format();
    else if (keyword == "element")
      parse_element();
    else if (keyword == "property")
      parse_property();
    else
      in_.fail(
          fmt::format("unknown statement '{}'; expected format, comment, obj_info, element, property or end_header",
                      excerpt(keyword)));
    if (const std::string_view more = in_.word(); !more.empty())
      in_.fail(fmt::format("unknown text '{}'; expected the end of the line", excerpt(more)));
    return true;
  }

  void parse_format() {
    const std::string_view encoding = in_.word(), version = in_.word();
    if (encoding == "ascii")
      header_.encoding = PlyEncoding::ascii;
    else if (encoding == "binary_little_endian")
      header_.encoding = PlyEncoding::little_endian;
    else if (encoding == "binary_big_endian")
      header_.encoding = PlyEncoding::big_endian;
    else
      in_.fail(fmt::format("unknown format '{}'; expected ascii, binary_little_endian or binary_big_endian",
                           excerpt(encoding)));
    if (version != "1.0") in_.fail(fmt::format("unknown version '{}' of PLY; expected 1.0", excerpt(version)));
    if (has_format_) in_.fail("invalid second format; expected one format");
    has_format_ = true;
  }

  void parse_element() {
    PlyElement element;
    element.name = need("name of the element");
    element.line = in_.line();
    const std::string_view count = in_.word();
    if (!parse_number(count, element.count) || element.count < 0)
      in_.fail(fmt::format("invalid number '{}' of entries; expected an integer >= 0", excerpt(count)));
    if (!element_names_.insert(element.name).second)
      in_.fail(fmt::format("invalid second element {}; expected different names", excerpt(element.name)));
    header_.elements.push_back(std::move(element));
    property_names_.clear();
  }

  void parse_property() {
    if (header_.elements.empty()) in_.fail("invalid property without an element; expected 'element' before it");
    PlyProperty property;
    std::string_view type = in_.word();
    if (type == "list") {
      property.length = type_of(in_.word());
      if (!is_integer(*property.length)) in_.fail("invalid list with a length of type float; expected an integer type");
      type = in_.word();
    }
    property.type = type_of(type);
    property.name = need("name of the property");
    if (!property_names_.insert(property.name).second)
      in_.fail(fmt::format("invalid second property {}; expected different names", excerpt(property.name)));
    header_.elements.back().properties.push_back(std::move(property));
  }

  std::string need(std::string_view what) {
    const std::string_view word = in_.word();
    if (word.empty()) in_.fail(fmt::format("missing {}; expected a word", what));
    return std::string(word);
  }

  PlyType type_of(std::string_view word) const {
    for (const auto& [name, type] : type_names)
      if (name == word) return type;
    in_.fail(
        fmt::format("unknown type '{}'; expected char, uchar, short, ushort, int, uint, float, double, or int8 to "
                    "float64",
                    excerpt(word)));
  }

  /// Counts are believed only where the file is long enough for them.
  void check_counts() const {
    // the last word of a text needs no blank after it
    std::size_t left = content_.size() - header_.size + (header_.encoding == PlyEncoding::ascii ? 1 : 0);
    for (const PlyElement& element : header_.elements) {
      const std::size_t least = least_size(element, header_.encoding);
      if (least == 0) continue;
      const auto count = static_cast<std::uint64_t>(element.count);
      if (count > left / least)
        throw InputError(fmt::format(
            "{}:{}: out of range: {} entries of {}; expected at most {}, which the rest of the file can hold", name_,
            element.line, count, excerpt(element.name), left / least));
      left -= count * least;
    }
  }

  std::string_view content_;
  const std::string& name_;
  TextCursor in_;
  PlyHeader header_;
  std::set<std::string> element_names_, property_names_;
  bool has_format_ = false;
};

}  // namespace

std::optional<std::size_t> PlyElement::find(std::string_view property) const {
  for (std::size_t k = 0; k < properties.size(); ++k)
    if (properties[k].name == property) return k;
  return std::nullopt;
}

std::size_t size_of(PlyType type) {
  switch (type) {
    case PlyType::int8:
    case PlyType::uint8:
      return 1;
    case PlyType::int16:
    case PlyType::uint16:
      return 2;
    case PlyType::int32:
    case PlyType::uint32:
    case PlyType::float32:
      return 4;
    case PlyType::float64:
      break;
  }
  return 8;
}

bool is_integer(PlyType type) {
  return type != PlyType::float32 && type != PlyType::float64;
}

std::size_t least_size(const PlyElement& element, PlyEncoding encoding) {
  std::size_t size = 0;
  for (const PlyProperty& property : element.properties)
    size += encoding == PlyEncoding::ascii ? 2 : size_of(property.length.value_or(property.type));
  return size;
}

PlyHeader read_ply_header(std::string_view content, const std::string& name) {
  return HeaderParser(content, name).parse();
}

}  // namespace brunt::io
