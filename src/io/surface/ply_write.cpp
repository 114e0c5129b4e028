// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <cstring>

#include "io/surface/surface_file.hpp"
#include "io/text_file.hpp"

namespace brunt::io {

void write_ply(const std::string& path, const TriangleSurface& surface) {
  std::string text = fmt::format(
      "ply\nformat binary_little_endian 1.0\nelement vertex {}\nproperty double x\nproperty double y\nproperty double "
      "z\nelement face {}\nproperty list uchar int vertex_indices\nend_header\n",
      surface.points.size(), surface.triangles.size());
  const auto put = [&](const auto& value) {
    char bytes[sizeof value];
    std::memcpy(bytes, &value, sizeof value);
    text.append(bytes, sizeof value);
  };
  for (const Vec3& x : surface.points)
    for (int c = 0; c < 3; ++c) put(x[c]);
  for (const std::array<LocalIndex, 3>& triangle : surface.triangles) {
    put(static_cast<unsigned char>(3));
    for (const LocalIndex corner : triangle) put(corner);
  }
  replace_text(path, text);
}

}  // namespace brunt::io
