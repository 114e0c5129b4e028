// SPDX-License-Identifier: Apache-2.0
// Small surfaces, and their text as files of each format.
#pragma once
#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <cstring>
#include <string>
#include <vector>

#include "core/triangle_surface.hpp"

namespace brunt::test {

struct PolygonSurface {
  std::vector<Vec3> points;
  std::vector<std::vector<LocalIndex>> faces;
};

/// A box with quadrilaterals for faces, outside counter-clockwise.
inline PolygonSurface box_surface(const Vec3& low, const Vec3& high) {
  PolygonSurface box;
  for (int i = 0; i < 8; ++i)
    box.points.emplace_back((i & 1 ? high : low)[0], (i & 2 ? high : low)[1], (i & 4 ? high : low)[2]);
  box.faces = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
  return box;
}

/// An L of two arms of length 2 and width 1, from z = 0 to 1; its ends are concave polygons of six corners.
inline PolygonSurface l_surface() {
  PolygonSurface l;
  constexpr std::array<std::array<double, 2>, 6> outline = {{{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}}};
  for (const double z : {0., 1.})
    for (const auto& [x, y] : outline) l.points.emplace_back(x, y, z);
  l.faces = {{5, 4, 3, 2, 1, 0}, {6, 7, 8, 9, 10, 11}};
  for (LocalIndex k = 0; k < 6; ++k) l.faces.push_back({k, (k + 1) % 6, (k + 1) % 6 + 6, k + 6});
  return l;
}

/// Of the polygons as a fan: for convex ones.
inline TriangleSurface fans_of(const PolygonSurface& surface) {
  TriangleSurface fans{surface.points, {}};
  for (const auto& face : surface.faces)
    for (std::size_t k = 1; k + 1 < face.size(); ++k) fans.triangles.push_back({face[0], face[k], face[k + 1]});
  return fans;
}

template <class T>
void append(std::string& bytes, T value, std::endian order = std::endian::little) {
  std::array<char, sizeof(T)> raw;
  std::memcpy(raw.data(), &value, sizeof(T));
  if (order != std::endian::native) std::reverse(raw.begin(), raw.end());
  bytes.append(raw.data(), sizeof(T));
}

inline std::string ascii_stl(const TriangleSurface& surface, const std::string& name = "body") {
  std::string text = "solid " + name + "\n";
  for (const auto& triangle : surface.triangles) {
    text += "  facet normal 0 0 0\n    outer loop\n";
    for (const LocalIndex corner : triangle) {
      const Vec3& x = surface.points[static_cast<std::size_t>(corner)];
      text += fmt::format("      vertex {} {} {}\n", x[0], x[1], x[2]);
    }
    text += "    endloop\n  endfacet\n";
  }
  return text + "endsolid " + name + "\n";
}

/// `header`: up to 80 bytes, filled up with zeros.
inline std::string binary_stl(const TriangleSurface& surface, std::string header = "made by a test") {
  header.resize(80, '\0');
  append(header, static_cast<std::uint32_t>(surface.triangles.size()));
  for (const auto& triangle : surface.triangles) {
    for (int k = 0; k < 3; ++k) append(header, 0.f);
    for (const LocalIndex corner : triangle)
      for (const double x : surface.points[static_cast<std::size_t>(corner)]) append(header, static_cast<float>(x));
    append(header, std::uint16_t{0});
  }
  return header;
}

inline std::string obj(const PolygonSurface& surface) {
  std::string text = "# made by a test\nmtllib none.mtl\no body\n";
  for (const Vec3& x : surface.points) text += fmt::format("v {} {} {}\n", x[0], x[1], x[2]);
  text += "vn 0 0 1\nusemtl grey\ns off\n";
  for (const auto& face : surface.faces) {
    text += "f";
    for (const LocalIndex corner : face) text += fmt::format(" {}", corner + 1);
    text += "\n";
  }
  return text;
}

/// `format`: ascii, binary_little_endian, binary_big_endian.
inline std::string ply_header(const PolygonSurface& surface, const std::string& format, const std::string& real) {
  return fmt::format(
      "ply\nformat {} 1.0\ncomment made by a test\nelement vertex {}\nproperty {} x\nproperty {} y\nproperty {} z\n"
      "element face {}\nproperty list uchar int vertex_indices\nend_header\n",
      format, surface.points.size(), real, real, real, surface.faces.size());
}

inline std::string ascii_ply(const PolygonSurface& surface) {
  std::string text = ply_header(surface, "ascii", "double");
  for (const Vec3& x : surface.points) text += fmt::format("{} {} {}\n", x[0], x[1], x[2]);
  for (const auto& face : surface.faces) {
    text += fmt::format("{}", face.size());
    for (const LocalIndex corner : face) text += fmt::format(" {}", corner);
    text += "\n";
  }
  return text;
}

/// Coordinates of type Real: float or double.
template <class Real>
std::string binary_ply(const PolygonSurface& surface, std::endian order) {
  std::string bytes = ply_header(surface, order == std::endian::big ? "binary_big_endian" : "binary_little_endian",
                                 sizeof(Real) == 4 ? "float" : "double");
  for (const Vec3& point : surface.points)
    for (const double x : point) append(bytes, static_cast<Real>(x), order);
  for (const auto& face : surface.faces) {
    append(bytes, static_cast<std::uint8_t>(face.size()));
    for (const LocalIndex corner : face) append(bytes, corner, order);
  }
  return bytes;
}

}  // namespace brunt::test
