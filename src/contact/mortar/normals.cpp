// SPDX-License-Identifier: Apache-2.0
#include "brunt/contact/mortar/normals.hpp"

#include <Eigen/Geometry>

#include "add_block.hpp"
#include "brunt/core/cross_matrix.hpp"
#include "corners.hpp"

namespace brunt::contact {

namespace {

/// Unit normal of a facet (of its two diagonals) and its slopes by the corners.
struct FacetNormal {
  Vec3 normal = Vec3::Zero();
  std::array<Mat3, 4> slope;

  FacetNormal(FacetCorners x, bool with_slopes) {
    const bool triangle = x.size() == 3;
    const Vec3 d1 = triangle ? x[1] - x[0] : x[2] - x[0], d2 = triangle ? x[2] - x[0] : x[3] - x[1];
    const Vec3 area = d1.cross(d2);
    const double size = area.norm();
    slope.fill(Mat3::Zero());
    if (!(size > 0)) return;
    normal = area / size;
    if (!with_slopes) return;
    const Mat3 across = (Mat3::Identity() - normal * normal.transpose()) / size;
    const Mat3 by_d1 = -across * cross_matrix(d2), by_d2 = across * cross_matrix(d1);
    slope = triangle ? std::array<Mat3, 4>{-by_d1 - by_d2, by_d1, by_d2, Mat3::Zero()}
                     : std::array<Mat3, 4>{-by_d1, -by_d2, by_d1, by_d2};
  }
};

/// What leaves no component along these normals, which need not be orthogonal.
Mat3 projector(std::span<const Vec3> mirrors) {
  Mat3 left = Mat3::Identity();
  for (const Vec3& mirror : mirrors) {
    const Vec3 rest = left * mirror;
    constexpr double parallel = 1e-6;  // sine below which two planes are one
    if (rest.norm() > parallel) left -= rest.normalized() * rest.normalized().transpose();
  }
  return left;
}

}  // namespace

void nodal_normals(const MortarSurfaces& surfaces, const MortarTopology& topology, std::span<const Vec3> x,
                   std::vector<Vec3>& normals, NodeBlocks<Mat3>* slopes) {
  const std::size_t rows = surfaces.rows.size();
  normals.assign(rows, Vec3::Zero());
  if (slopes != nullptr) slopes->clear();
  for (std::size_t row = 0; row < rows; ++row) {
    const auto index = static_cast<LocalIndex>(row);
    const Mat3 left = surfaces.mirrors.rows() > 0 ? projector(surfaces.mirrors.row(index)) : Mat3(Mat3::Identity());
    const std::span<const LocalIndex> around = topology.facets_around.row(index);
    Vec3 sum = Vec3::Zero();
    for (const LocalIndex facet : around)
      sum += FacetNormal(CornersOf(surfaces.slave[static_cast<std::size_t>(facet)], x).span(), false).normal;
    const Vec3 mean = left * sum;
    const double size = mean.norm();
    if (size > 0) normals[row] = -mean / size;
    if (slopes == nullptr) continue;
    if (size > 0) {
      const Mat3 across = -(Mat3::Identity() - normals[row] * normals[row].transpose()) * left / size;
      for (const LocalIndex facet : around) {
        const FacetNodes& nodes = surfaces.slave[static_cast<std::size_t>(facet)];
        const CornersOf corners(nodes, x);
        const FacetNormal of_facet(corners.span(), true);
        for (std::size_t a = 0; a < corners.count; ++a) add_block(*slopes, nodes[a], Mat3(across * of_facet.slope[a]));
      }
    }
    slopes->nodes.close_row();
  }
}

}  // namespace brunt::contact
