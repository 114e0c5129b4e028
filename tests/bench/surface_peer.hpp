// SPDX-License-Identifier: Apache-2.0
// Surface files as CGAL reads them.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "core/types.hpp"

namespace brunt::bench {

struct PolygonSoup {
  std::vector<Vec3> points;
  std::vector<std::vector<std::size_t>> polygons;
};

/// By CGAL::IO::read_polygon_soup; nothing where it refuses the file.
std::optional<PolygonSoup> cgal_soup(const std::string& path);

}  // namespace brunt::bench
