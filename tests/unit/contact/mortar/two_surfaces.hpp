// SPDX-License-Identifier: Apache-2.0
// Two surfaces that face each other, of quadrilaterals or triangles, over the unit square or a part of it.
#pragma once
#include <cmath>
#include <functional>
#include <numeric>
#include <random>
#include <vector>

#include "contact/mortar/interface.hpp"

namespace brunt::test {

/// Rows n x m of facets over [x0, x1] x [y0, y1], placed by `place`, looking up or down.
struct Sheet {
  int n = 3, m = 3;
  double x0 = 0, x1 = 1, y0 = 0, y1 = 1;
  bool up = true, triangles = false;
};

struct TwoSurfaces {
  contact::MortarSurfaces surfaces;
  std::vector<Vec3> x;
  Ragged<LocalIndex> candidates;  ///< all pairs

  using Place = std::function<Vec3(double, double)>;

  TwoSurfaces(const Sheet& slave, const Place& place_slave, const Sheet& master, const Place& place_master) {
    surfaces.capture = 1;
    add(slave, place_slave, surfaces.slave);
    surfaces.rows.resize(x.size());
    std::iota(surfaces.rows.begin(), surfaces.rows.end(), 0);
    add(master, place_master, surfaces.master);
    for (std::size_t facet = 0; facet < surfaces.slave.size(); ++facet) {
      for (std::size_t c = 0; c < surfaces.master.size(); ++c) candidates.values.push_back(static_cast<LocalIndex>(c));
      candidates.close_row();
    }
  }

 private:
  void add(const Sheet& sheet, const Place& place, std::vector<contact::FacetNodes>& facets) {
    const auto first = static_cast<LocalIndex>(x.size());
    for (int j = 0; j <= sheet.m; ++j)
      for (int i = 0; i <= sheet.n; ++i)
        x.push_back(
            place(sheet.x0 + (sheet.x1 - sheet.x0) * i / sheet.n, sheet.y0 + (sheet.y1 - sheet.y0) * j / sheet.m));
    for (int j = 0; j < sheet.m; ++j)
      for (int i = 0; i < sheet.n; ++i) {
        const LocalIndex a = first + j * (sheet.n + 1) + i, b = a + 1, c = b + sheet.n + 1, d = c - 1;
        if (sheet.triangles) {
          facets.push_back({a, b, c, no_index});
          facets.push_back({a, c, d, no_index});
        } else {
          facets.push_back({a, b, c, d});
        }
      }
    for (contact::FacetNodes& facet : facets)
      if (!sheet.up && facet[0] >= first) {
        if (facet[3] == no_index)
          std::swap(facet[1], facet[2]);
        else
          std::swap(facet[1], facet[3]);
      }
  }
};

/// Wavy surfaces with nodes moved at random: warped facets askew to each other, some of them only partly covered.
inline TwoSurfaces wavy_surfaces(unsigned seed, bool slave_triangles = false, bool master_triangles = false) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> number(-1, 1);
  const auto noise = [&](double size) {
    return Vec3(size * number(random), size * number(random), size * number(random));
  };
  const Sheet slave{3, 2, 0.03, 1.01, 0.02, 1.04, true, slave_triangles};
  const Sheet master{2, 3, -0.13, 0.9, 0.11, 1.2, false, master_triangles};
  return {slave,
          [&](double x, double y) -> Vec3 { return Vec3(x, y, 0.1 * std::sin(3 * x) * std::cos(2 * y)) + noise(0.03); },
          master,
          [&](double x, double y) -> Vec3 {
            return Vec3(x + 0.2 * y, y - 0.1 * x, 0.02 + 0.1 * std::sin(3 * x) * std::cos(2 * y)) + noise(0.03);
          }};
}

}  // namespace brunt::test
