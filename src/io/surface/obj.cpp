// SPDX-License-Identifier: Apache-2.0
// OBJ: lines of points and faces. The statements of Wavefront's specification that carry polygons are read.
#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <limits>

#include "core/error.hpp"
#include "core/excerpt.hpp"
#include "io/text_file.hpp"
#include "polygons.hpp"
#include "surface_formats.hpp"
#include "surface_text.hpp"

namespace brunt::io {
namespace {

/// Statements that bear on neither points nor faces.
constexpr std::array<std::string_view, 24> skipped = {
    "vt",        "vn",       "vp",       "g",     "o",     "s",     "mg",  "usemtl",
    "mtllib",    "usemap",   "maplib",   "p",     "l",     "bevel", "lod", "shadow_obj",
    "trace_obj", "c_interp", "d_interp", "ctech", "stech", "call",  "csh", "fo_color"};

class ObjParser {
 public:
  ObjParser(std::string_view content, const std::string& name) : name_(name), in_(content, name, LineSyntax::obj) {}

  TriangleSurface parse() {
    while (in_.next_line()) parse_line();
    check_indices();
    const auto where = [this](std::size_t /*face*/, std::int64_t line) { return fmt::format("{}:{}", name_, line); };
    split_polygons(faces_, {where, 1}, surface_);
    return std::move(surface_);
  }

 private:
  void parse_line() {
    const std::string_view keyword = in_.word();
    if (keyword.empty()) return;
    if (keyword == "v") return parse_point();
    if (keyword == "f") return parse_face();
    if (std::ranges::find(skipped, keyword) == skipped.end())
      in_.fail(
          fmt::format("unknown statement '{}'; expected v, f, or what goes with polygons (vt, vn, g, o, s, usemtl, "
                      "...)",
                      excerpt(keyword)));
    while (!in_.word().empty()) continue;  // a long statement goes on in the next lines
  }

  /// Three numbers; a fourth is a weight, three more are colours (and a seventh both).
  void parse_point() {
    need_index(surface_.points.size() + 1, name_, "points");
    surface_.points.push_back(in_.point());
    int more = 0;
    for (std::string_view word = in_.word(); !word.empty(); word = in_.word(), ++more) {
      double unused = 0;
      if (!parse_number(word, unused))
        in_.fail(fmt::format("invalid weight or colour '{}'; expected a number", excerpt(word)));
    }
    if (more > 4) in_.fail(fmt::format("invalid point of {} numbers; expected 3, 4, 6 or 7", more + 3));
  }

  void parse_face() {
    const std::int64_t line = in_.line();
    const std::size_t begin = faces_.corners.size();
    for (std::string_view word = in_.word(); !word.empty(); word = in_.word()) faces_.corners.push_back(corner(word));
    if (const std::size_t count = faces_.corners.size() - begin; count < 3)
      in_.fail(fmt::format("invalid face of {} corners; expected at least 3", count));
    faces_.ends.push_back(faces_.corners.size());
    faces_.places.push_back(line);
  }

  /// `a`, `a/b`, `a//c` or `a/b/c`: a is the point. Positive indices may name points that follow.
  LocalIndex corner(std::string_view word) {
    const auto slash = word.find('/');
    std::int64_t index = 0;
    if (!parse_number(word.substr(0, slash), index) || !are_others(slash, word))
      in_.fail(fmt::format("invalid corner '{}'; expected a, a/b, a//c or a/b/c of integers", excerpt(word)));
    const auto count = static_cast<std::int64_t>(surface_.points.size());
    if (index == 0 || index < -count || index > std::numeric_limits<LocalIndex>::max())
      in_.fail(fmt::format("out of range: index {} of a point; expected one of the {} points above, or a later one",
                           index, count));
    return static_cast<LocalIndex>(index > 0 ? index - 1 : count + index);
  }

  /// Indices of texture and normal: integers, which are not looked at.
  static bool are_others(std::size_t slash, std::string_view word) {
    if (slash == std::string_view::npos) return true;
    word.remove_prefix(slash + 1);
    const auto second = word.find('/');
    const std::string_view texture = word.substr(0, second);
    std::int64_t unused = 0;
    if (second == std::string_view::npos) return parse_number(texture, unused);
    return (texture.empty() || parse_number(texture, unused)) && parse_number(word.substr(second + 1), unused);
  }

  void check_indices() const {
    const std::size_t count = surface_.points.size();
    for (std::size_t face = 0, k = 0; face < faces_.ends.size(); ++face)
      for (; k < faces_.ends[face]; ++k)
        if (static_cast<std::size_t>(faces_.corners[k]) >= count)
          throw InputError(fmt::format("{}:{}: out of range: index {} of a point; expected at most {}", name_,
                                       faces_.places[face], std::int64_t{faces_.corners[k]} + 1, count));
  }

  const std::string& name_;
  TextCursor in_;
  TriangleSurface surface_;
  Polygons faces_;
};

}  // namespace

SurfaceFile parse_obj(std::string_view content, const std::string& name) {
  const std::string plain = plain_text(std::string(content), name);
  return {ObjParser(plain, name).parse(), false};
}

}  // namespace brunt::io
