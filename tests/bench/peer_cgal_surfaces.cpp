// SPDX-License-Identifier: Apache-2.0
#include <CGAL/IO/polygon_soup_io.h>
#include <CGAL/Simple_cartesian.h>

#include "surface_peer.hpp"

namespace brunt::bench {

std::optional<PolygonSoup> cgal_soup(const std::string& path) {
  using Point = CGAL::Simple_cartesian<double>::Point_3;
  std::vector<Point> points;
  PolygonSoup soup;
  if (!CGAL::IO::read_polygon_soup(path, points, soup.polygons)) return std::nullopt;
  for (const Point& x : points) soup.points.emplace_back(x.x(), x.y(), x.z());
  return soup;
}

}  // namespace brunt::bench
