// SPDX-License-Identifier: Apache-2.0
// Faces of a surface file as they are read, and their way to triangles.
#pragma once
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "core/triangle_surface.hpp"

namespace brunt::io {

struct Polygons {
  std::vector<LocalIndex> corners;   ///< of all faces, indices of points
  std::vector<std::size_t> ends;     ///< the end of each face in corners
  std::vector<std::int64_t> places;  ///< the line or the byte of each face
};

/// How faults of a face are worded.
struct FaceWords {
  std::function<std::string(std::size_t face, std::int64_t place)> where;  ///< "FILE:LINE", or "FILE: face 17 ..."
  LocalIndex first_index = 0;                                              ///< number of the first point in the file
};

/// Splits the faces into the triangles of `surface`, whose points are there, in the order of the faces. Indices are
/// sound. Throws InputError: a face with a corner twice, one that crosses itself, more triangles than fit an index.
void split_polygons(const Polygons& polygons, const FaceWords& words, TriangleSurface& surface);

}  // namespace brunt::io
