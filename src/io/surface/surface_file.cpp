// SPDX-License-Identifier: Apache-2.0
// Chooses the reader of a surface file.
#include "io/surface/surface_file.hpp"

#include <fmt/core.h>

#include <limits>

#include "core/error.hpp"
#include "core/excerpt.hpp"
#include "core/letter_case.hpp"
#include "io/text_file.hpp"
#include "surface_formats.hpp"
#include "surface_text.hpp"

namespace brunt::io {
namespace {

SurfaceFile parse(std::string_view content, const std::string& name, SurfaceFormat format) {
  switch (format) {
    case SurfaceFormat::stl:
      return parse_stl(content, name);
    case SurfaceFormat::obj:
      return parse_obj(content, name);
    case SurfaceFormat::ply:
      break;
  }
  return parse_ply(content, name);
}

}  // namespace

SurfaceFormat surface_format(const std::string& path) {
  const auto folder = path.find_last_of('/');
  const std::string file = folder == std::string::npos ? path : path.substr(folder + 1);
  const auto dot = file.find_last_of('.');
  const std::string extension = dot == std::string::npos ? "" : lower_case(file.substr(dot));
  if (extension == ".stl") return SurfaceFormat::stl;
  if (extension == ".obj") return SurfaceFormat::obj;
  if (extension == ".ply") return SurfaceFormat::ply;
  throw InputError(fmt::format("{}: unknown extension '{}' of a surface file; expected .stl, .obj or .ply", path,
                               excerpt(extension)));
}

SurfaceFile read_surface(const std::string& path) {
  const SurfaceFormat format = surface_format(path);
  return parse_surface(read_text(path), path, format);
}

SurfaceFile parse_surface(std::string_view content, const std::string& name, SurfaceFormat format) {
  if (content.empty()) throw InputError(name + ": invalid surface file: it is empty; expected a surface");
  if (is_web_page(content)) throw InputError(name + ":1: invalid surface file: it is a web page; expected a surface");
  SurfaceFile file = parse(content, name, format);
  if (file.surface.triangles.empty()) throw InputError(name + ": missing faces; expected at least one");
  return file;
}

void need_index(std::size_t count, const std::string& name, std::string_view what) {
  constexpr auto most = static_cast<std::size_t>(std::numeric_limits<LocalIndex>::max());
  if (count > most)
    throw InputError(fmt::format("{}: out of range: {} {}; expected at most {}", name, count, what, most));
}

}  // namespace brunt::io
