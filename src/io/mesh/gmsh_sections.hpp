// SPDX-License-Identifier: Apache-2.0
// What a Gmsh file says, section by section, before it is made a mesh.
#pragma once
#include <array>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/types.hpp"
#include "gmsh_text.hpp"

namespace brunt::io {

struct GmshElement {
  std::int64_t number = 0, physical = 0, entity = 0;  ///< physical 0: in no group
  int dimension = 0, corners = 0, line = 0;           ///< corners 0: of a type that is not read
  int type = 0;                                       ///< as the file has it
  std::array<LocalIndex, 8> nodes{};
};

constexpr std::string_view gmsh_element_types =
    "first-order tetrahedra, hexahedra, prisms and pyramids, with triangles and quadrilaterals on their faces or as "
    "shells";

struct GmshFile {
  std::vector<Vec3> coordinates;
  std::vector<std::int64_t> node_number;
  std::vector<GmshElement> elements;                         ///< one entry a group; of lines those in groups
  std::map<std::pair<int, std::int64_t>, std::string> name;  ///< of physical groups by (dimension, number)
};

/// Throws InputError with the line for whatever is not as MSH 2.2 or 4.1 have it (Gmsh reference manual, file formats).
GmshFile read_gmsh_sections(LineReader& in);

}  // namespace brunt::io
