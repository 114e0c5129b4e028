// SPDX-License-Identifier: Apache-2.0
// The readers of surface files, one a format, and what they share. Faults: see read_surface.
#pragma once
#include <string>
#include <string_view>

#include "io/surface/surface_file.hpp"

namespace brunt::io {

[[nodiscard]] SurfaceFile parse_stl(std::string_view content, const std::string& name);
[[nodiscard]] SurfaceFile parse_obj(std::string_view content, const std::string& name);
[[nodiscard]] SurfaceFile parse_ply(std::string_view content, const std::string& name);

/// Throws InputError where an array of `count` items is too long for LocalIndex; `what`: "points".
void need_index(std::size_t count, const std::string& name, std::string_view what);

}  // namespace brunt::io
