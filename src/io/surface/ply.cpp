// SPDX-License-Identifier: Apache-2.0
// PLY: the entries of the elements, of which points and faces are kept.
#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cstdint>

#include "core/error.hpp"
#include "io/text_file.hpp"
#include "ply_body.hpp"
#include "ply_header.hpp"
#include "polygons.hpp"
#include "surface_formats.hpp"
#include "surface_text.hpp"

namespace brunt::io {
namespace {

/// Which properties of an entry are kept.
struct PointLayout {
  std::array<std::size_t, 3> coordinates{};
  bool single_precision = false;
};

[[noreturn]] void fail(const std::string& name, std::int64_t line, const std::string& fault) {
  throw InputError(fmt::format("{}:{}: {}", name, line, fault));
}

const PlyElement& need_element(const PlyHeader& header, std::string_view wanted, const std::string& name) {
  for (const PlyElement& element : header.elements)
    if (element.name == wanted) return element;
  fail(name, header.lines, fmt::format("missing element {}; expected vertex and face", wanted));
}

PointLayout point_layout(const PlyElement& element, const std::string& name) {
  constexpr std::array<std::string_view, 3> names = {"x", "y", "z"};
  PointLayout layout;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto found = element.find(names[axis]);
    if (!found || element.properties[*found].length)
      fail(name, element.line, fmt::format("missing property {} of vertex; expected numbers x, y, z", names[axis]));
    layout.coordinates[axis] = *found;
    layout.single_precision |= element.properties[*found].type == PlyType::float32;
  }
  return layout;
}

std::size_t corner_list(const PlyElement& element, const std::string& name) {
  const auto found = element.find(element.find("vertex_indices") ? "vertex_indices" : "vertex_index");
  if (!found || !element.properties[*found].length || !is_integer(element.properties[*found].type))
    fail(name, element.line,
         "missing list vertex_indices (or vertex_index) of face; expected a list of an integer type");
  return *found;
}

template <class Body>
class PlyParser {
 public:
  PlyParser(const PlyHeader& header, std::string_view content, const std::string& name)
      : header_(header),
        name_(name),
        body_(content, name, header),
        vertex_(need_element(header, "vertex", name)),
        face_(need_element(header, "face", name)),
        point_(point_layout(vertex_, name)),
        list_(corner_list(face_, name)) {}

  SurfaceFile parse() {
    need_index(static_cast<std::size_t>(vertex_.count), name_, "points");
    for (const PlyElement& element : header_.elements) {
      if (element.properties.empty()) continue;  // its entries take no room
      if (&element == &vertex_)
        parse_points();
      else if (&element == &face_)
        parse_faces();
      else
        for (std::int64_t i = 0; i < element.count; ++i) skip_entry(element, i);
    }
    body_.need_end();
    const auto where = [this](std::size_t face, std::int64_t place) {
      return body_.where(face_, static_cast<std::int64_t>(face), place);
    };
    split_polygons(faces_, {where, 0}, surface_);
    return {std::move(surface_), point_.single_precision};
  }

 private:
  void skip(const PlyProperty& property) { body_.skip(property.type, property.length ? length_of(property) : 1); }

  std::int64_t length_of(const PlyProperty& list) {
    const std::int64_t length = body_.integer(*list.length, "length of a list");
    if (length < 0) body_.fail(fmt::format("out of range: a list of {} entries; expected a length >= 0", length));
    body_.need_room(list.type, length);
    return length;
  }

  void skip_entry(const PlyElement& element, std::int64_t entry) {
    body_.begin(element, entry);
    for (const PlyProperty& property : element.properties) skip(property);
    body_.end();
  }

  void parse_points() {
    surface_.points.reserve(static_cast<std::size_t>(vertex_.count));
    constexpr std::array<std::string_view, 3> names = {"coordinate x", "coordinate y", "coordinate z"};
    for (std::int64_t i = 0; i < vertex_.count; ++i) {
      body_.begin(vertex_, i);
      Vec3 x = Vec3::Zero();
      for (std::size_t k = 0; k < vertex_.properties.size(); ++k) {
        const auto axis = std::ranges::find(point_.coordinates, k) - point_.coordinates.begin();
        if (axis == 3) {
          skip(vertex_.properties[k]);
          continue;
        }
        x[axis] = body_.real(vertex_.properties[k].type, nth(names, axis));
        const std::string fault = coordinate_fault(static_cast<int>(axis), x[axis]);
        if (!fault.empty()) body_.fail(fault);
      }
      body_.end();
      surface_.points.push_back(x);
    }
  }

  void parse_faces() {
    faces_.ends.reserve(static_cast<std::size_t>(face_.count));
    faces_.places.reserve(static_cast<std::size_t>(face_.count));
    for (std::int64_t i = 0; i < face_.count; ++i) {
      body_.begin(face_, i);
      faces_.places.push_back(body_.place());
      for (std::size_t k = 0; k < face_.properties.size(); ++k) {
        if (k == list_)
          parse_corners(face_.properties[k]);
        else
          skip(face_.properties[k]);
      }
      body_.end();
      faces_.ends.push_back(faces_.corners.size());
    }
  }

  void parse_corners(const PlyProperty& list) {
    const std::int64_t length = length_of(list);
    if (length < 3) body_.fail(fmt::format("invalid face of {} corners; expected at least 3", length));
    for (std::int64_t k = 0; k < length; ++k) {
      const std::int64_t index = body_.integer(list.type, "index of a point");
      if (index < 0 || index >= vertex_.count)
        body_.fail(fmt::format("out of range: index {} of a point; expected 0 to {}", index, vertex_.count - 1));
      faces_.corners.push_back(static_cast<LocalIndex>(index));
    }
  }

  const PlyHeader& header_;
  const std::string& name_;
  Body body_;
  const PlyElement &vertex_, &face_;
  PointLayout point_;
  std::size_t list_;
  TriangleSurface surface_;
  Polygons faces_;
};

/// The content with line feeds in place of carriage returns in its header, if the header's lines end with these alone;
/// otherwise empty. The entries of a binary file may begin with any byte, so they stay.
std::string with_plain_header(std::string_view content) {
  const auto end = content.find_first_of("\r\n");
  if (end == std::string_view::npos || content[end] != '\r' || content.substr(end + 1).starts_with('\n')) return {};
  constexpr std::string_view last = "\rend_header\r";
  const auto header = content.find(last);
  if (header == std::string_view::npos) return {};
  std::string own(content);
  std::replace(own.begin(), own.begin() + static_cast<std::ptrdiff_t>(header + last.size()), '\r', '\n');
  return own;
}

}  // namespace

SurfaceFile parse_ply(std::string_view content, const std::string& name) {
  refuse_utf16(content, name);
  const std::string own = with_plain_header(content);
  if (!own.empty()) content = own;
  const PlyHeader header = read_ply_header(content, name);
  if (header.encoding != PlyEncoding::ascii) return PlyParser<PlyBinaryBody>(header, content, name).parse();
  const std::string plain = plain_text(std::string(content), name);
  return PlyParser<PlyAsciiBody>(read_ply_header(plain, name), plain, name).parse();
}

}  // namespace brunt::io
