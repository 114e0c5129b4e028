// SPDX-License-Identifier: Apache-2.0
// STL: triangles by the coordinates of their corners, as text or in binary.
#include <fmt/core.h>

#include <algorithm>
#include <cstdint>
#include <utility>

#include "core/error.hpp"
#include "core/excerpt.hpp"
#include "core/letter_case.hpp"
#include "io/text_file.hpp"
#include "raw_number.hpp"
#include "surface_formats.hpp"
#include "surface_text.hpp"

namespace brunt::io {
namespace {

constexpr std::size_t header_size = 84;    // bytes: 80 of any content, 4 of the number of triangles
constexpr std::size_t triangle_size = 50;  // bytes: normal and three corners of three floats, 2 of an attribute
constexpr std::size_t normal_size = 12;    // bytes

std::uint64_t announced(std::string_view content) {
  return raw_number<std::uint32_t>(content.data() + header_size - 4, std::endian::little);
}

bool has_binary_size(std::string_view content) {
  return content.size() >= header_size && content.size() == header_size + triangle_size * announced(content);
}

/// Text has no control characters but those that separate; binary headers are padded with zeros, as a rule.
bool is_text(std::string_view content) {
  constexpr std::size_t length = 512;  // bytes that are looked at
  return std::ranges::none_of(content.substr(0, length), [](char c) {
    return (c >= 0 && c < ' ' && c != '\t' && c != '\n' && c != '\r' && c != '\v' && c != '\f') || c == '\x7f';
  });
}

void add_triangle(TriangleSurface& surface) {
  const auto end = static_cast<LocalIndex>(surface.points.size());
  surface.triangles.push_back({end - 3, end - 2, end - 1});
}

TriangleSurface parse_binary(std::string_view content, const std::string& name) {
  const auto count = static_cast<std::size_t>(announced(content));
  need_index(3 * count, name, "corners");
  TriangleSurface surface;
  surface.points.reserve(3 * count);
  surface.triangles.reserve(count);
  for (std::size_t t = 0; t < count; ++t) {
    const std::size_t corners = header_size + t * triangle_size + normal_size;
    for (std::size_t k = 0; k < 3; ++k) {
      Vec3 x;
      for (int axis = 0; axis < 3; ++axis) {
        const std::size_t byte = corners + sizeof(float) * (3 * k + static_cast<std::size_t>(axis));
        x[axis] = static_cast<double>(raw_number<float>(content.data() + byte, std::endian::little));
        if (const std::string fault = coordinate_fault(axis, x[axis]); !fault.empty())
          throw InputError(fmt::format("{}: triangle {} of {}, byte {}: {}", name, t + 1, count, byte, fault));
      }
      surface.points.push_back(x);
    }
    add_triangle(surface);
  }
  return surface;
}

bool same_word(std::string_view word, std::string_view keyword) {
  return std::ranges::equal(word, keyword, {}, [](char c) { return lower_case(c); });
}

/// The statements of an ASCII file; keywords in upper or lower case, in any lines.
class AsciiStl {
 public:
  AsciiStl(std::string content, const std::string& name)
      : content_(std::move(content)), name_(name), in_(content_, name) {}

  TriangleSurface parse() {
    while (!next_solid().empty()) parse_solid();
    return std::move(surface_);
  }

 private:
  /// `solid` and its name; empty at the end of the file.
  std::string_view next_solid() {
    const std::string_view word = in_.word_anywhere();
    if (word.empty()) return {};
    if (!same_word(word, "solid"))
      in_.fail(fmt::format("unknown text '{}'; expected 'solid', or a binary file of 84 + 50 n bytes", excerpt(word)));
    in_.skip_line();
    return word;
  }

  void parse_solid() {
    for (;;) {
      const std::string_view word = in_.word_anywhere();
      if (same_word(word, "endsolid")) break;
      if (!same_word(word, "facet")) fail("facet' or 'endsolid", word);
      parse_facet();
    }
    in_.skip_line();
  }

  void parse_facet() {
    need("normal");
    for (int axis = 0; axis < 3; ++axis) in_.real("component of the normal");
    need("outer");
    need("loop");
    need_index(surface_.points.size() + 3, name_, "corners");
    for (int k = 0; k < 3; ++k) {
      need("vertex");
      surface_.points.push_back(in_.point());
    }
    need("endloop");
    need("endfacet");
    add_triangle(surface_);
  }

  void need(std::string_view keyword) {
    const std::string_view word = in_.word_anywhere();
    if (!same_word(word, keyword)) fail(keyword, word);
  }

  [[noreturn]] void fail(std::string_view keyword, std::string_view word) const {
    if (word.empty()) in_.fail(fmt::format("missing end of a solid: the file is truncated; expected '{}'", keyword));
    in_.fail(fmt::format("unknown text '{}'; expected '{}'", excerpt(word), keyword));
  }

  std::string content_;
  const std::string& name_;
  TextCursor in_;
  TriangleSurface surface_;
};

[[noreturn]] void fail_size(std::string_view content, const std::string& name) {
  if (content.size() < header_size)
    throw InputError(fmt::format("{}: invalid file of {} bytes, neither text nor binary STL; expected at least {}",
                                 name, content.size(), header_size));
  const std::uint64_t count = announced(content), expected = header_size + triangle_size * count;
  throw InputError(fmt::format("{}: invalid size of {} bytes, {}; expected {} for its {} triangles", name,
                               content.size(), content.size() < expected ? "less than needed" : "more than needed",
                               expected, count));
}

}  // namespace

SurfaceFile parse_stl(std::string_view content, const std::string& name) {
  if (has_binary_size(content)) return {parse_binary(content, name), true};
  refuse_utf16(content, name);
  if (!is_text(content)) fail_size(content, name);
  return {AsciiStl(plain_text(std::string(content), name), name).parse(), true};
}

}  // namespace brunt::io
