// SPDX-License-Identifier: Apache-2.0
// Surfaces of triangles from STL, OBJ and PLY files. Not collective: for the root rank.
#pragma once
#include <string>
#include <string_view>

#include "core/triangle_surface.hpp"

namespace brunt::io {

enum class SurfaceFormat { stl, obj, ply };

struct SurfaceFile {
  /// As in the file: points are not merged (an STL file has three for each triangle), and the surface may be open.
  TriangleSurface surface;
  /// The coordinates have about seven digits: STL, and PLY with `float` coordinates. Otherwise they are doubles.
  bool single_precision = false;
};

/// Largest magnitude of a coordinate that is read [length]. Volumes, squared areas and products of three lengths of
/// such points stay finite.
constexpr double largest_coordinate = 1e60;

/// Chosen by the extension: .stl, .obj or .ply, in upper or lower case. Throws InputError for any other.
[[nodiscard]] SurfaceFormat surface_format(const std::string& path);

/// Reads a surface file; the extension chooses the format.
///
/// - STL: ASCII or binary. A file of 84 + 50 n bytes, n its own count, is binary, whatever its header begins with.
///   Normals and attributes are skipped.
/// - OBJ: `v` (3 numbers; 4 with a weight, 6 with colours, which are skipped) and `f` (indices from 1, or negative ones
///   from the end; `a/b`, `a//c`, `a/b/c`). Other statements of polygons are skipped; free-form surfaces are refused.
/// - PLY: ascii, binary_little_endian, binary_big_endian; any types. Elements but `vertex` and `face`, and properties
///   but `x`, `y`, `z` and `vertex_indices` (or `vertex_index`) are skipped.
///
/// Numbers are read in double precision, independent of the locale. A quadrilateral is split along its shorter diagonal
/// unless that lies outside; polygons with more corners are split by ear clipping in the plane of their area vector.
///
/// Throws InputError, `FILE:LINE: what is wrong; expected ...`, or `FILE: triangle 17 of 20 ...` in binary files, for
/// content that violates the format, is truncated or continues after its end; coordinates that are not finite, or
/// larger than `largest_coordinate`; faces with fewer than three corners, with a repeated corner, with an unknown
/// index, or that intersect themselves; counts that exceed the file; a surface without triangles.
[[nodiscard]] SurfaceFile read_surface(const std::string& path);

/// The same of the content of a file; `name` stands for it in messages.
[[nodiscard]] SurfaceFile parse_surface(std::string_view content, const std::string& name, SurfaceFormat format);

/// Writes a binary PLY file in double precision; an existing file of that name is replaced. Throws MachineError.
void write_ply(const std::string& path, const TriangleSurface& surface);

}  // namespace brunt::io
