// SPDX-License-Identifier: Apache-2.0
#include "contact/mortar/normals.hpp"

#include <Eigen/Geometry>

#include "add_block.hpp"
#include "contact/mortar/corners.hpp"
#include "core/cross_matrix.hpp"

namespace brunt::contact {

namespace {

/// Unit normal of a facet (of its two diagonals) and its derivatives by the corners.
struct FacetNormal {
  Vec3 normal = Vec3::Zero();
  double area = 0;
  std::array<Mat3, 4> slope;
  std::array<Vec3, 4> area_slope;

  FacetNormal(FacetCorners x, bool with_slopes) {
    const bool triangle = x.size() == 3;
    const Vec3 d1 = triangle ? x[1] - x[0] : x[2] - x[0], d2 = triangle ? x[2] - x[0] : x[3] - x[1];
    const Vec3 product = d1.cross(d2);
    const double size = product.norm();
    slope.fill(Mat3::Zero());
    area_slope.fill(Vec3::Zero());
    if (!(size > 0)) return;
    normal = product / size;
    area = 0.5 * size;
    if (!with_slopes) return;
    const Mat3 across = (Mat3::Identity() - normal * normal.transpose()) / size;
    const Mat3 by_d1 = -across * cross_matrix(d2), by_d2 = across * cross_matrix(d1);
    slope = triangle ? std::array<Mat3, 4>{-by_d1 - by_d2, by_d1, by_d2, Mat3::Zero()}
                     : std::array<Mat3, 4>{-by_d1, -by_d2, by_d1, by_d2};
    const Vec3 longer_d1 = 0.5 * d2.cross(normal), longer_d2 = 0.5 * normal.cross(d1);
    area_slope = triangle ? std::array<Vec3, 4>{-longer_d1 - longer_d2, longer_d1, longer_d2, Vec3::Zero()}
                          : std::array<Vec3, 4>{-longer_d1, -longer_d2, longer_d1, longer_d2};
  }
};

/// Projector onto the complement of these normals, which need not be orthogonal.
Mat3 projector(std::span<const Vec3> mirrors) {
  Mat3 left = Mat3::Identity();
  for (const Vec3& mirror : mirrors) {
    const Vec3 rest = left * mirror;
    constexpr double parallel = 1e-6;  // sine below which two planes coincide
    if (rest.norm() > parallel) left -= rest.normalized() * rest.normalized().transpose();
  }
  return left;
}

/// The facets around one node and their weights.
class Around {
 public:
  Around(const MortarSurfaces& surfaces, std::span<const LocalIndex> facets, std::span<const Vec3> x,
         const FacetCoverage* coverage)
      : surfaces_(surfaces), facets_(facets), x_(x) {
    double covered = 0;
    for (const LocalIndex facet : facets)
      if (coverage != nullptr) covered += nth(coverage->area, facet);
    if (covered > 0) coverage_ = coverage;
  }

  [[nodiscard]] Vec3 sum() const {
    Vec3 sum = Vec3::Zero();
    for (const LocalIndex facet : facets_) {
      const FacetNormal of_facet(CornersOf(nodes(facet), x_).span(), false);
      sum += weight(facet, of_facet) * of_facet.normal;
    }
    return sum;
  }

  /// Adds left d(sum)/dx to the last row.
  void add_slopes(const Mat3& left, NodeBlocks<Mat3>& slopes) const {
    for (const LocalIndex facet : facets_) {
      const CornersOf corners(nodes(facet), x_);
      const FacetNormal of_facet(corners.span(), true);
      const double share = weight(facet, of_facet);
      if (share == 0) continue;
      const Vec3 turned = left * of_facet.normal;
      for (std::size_t a = 0; a < corners.count; ++a) {
        Mat3 slope = share * (left * of_facet.slope[a]);
        if (coverage_ != nullptr) slope -= share / of_facet.area * (turned * of_facet.area_slope[a].transpose());
        add_block(slopes, nodes(facet)[a], slope);
      }
      if (coverage_ == nullptr) continue;
      const std::span<const LocalIndex> moved = coverage_->slopes.nodes.row(facet);
      for (std::size_t k = 0; k < moved.size(); ++k)
        add_block(slopes, moved[k], Mat3(turned * coverage_->slopes.row(facet)[k].transpose() / of_facet.area));
    }
  }

 private:
  [[nodiscard]] const FacetNodes& nodes(LocalIndex facet) const { return nth(surfaces_.slave, facet); }
  [[nodiscard]] double weight(LocalIndex facet, const FacetNormal& of_facet) const {
    if (coverage_ == nullptr) return 1;
    return of_facet.area > 0 ? nth(coverage_->area, facet) / of_facet.area : 0.0;
  }

  const MortarSurfaces& surfaces_;
  std::span<const LocalIndex> facets_;
  std::span<const Vec3> x_;
  const FacetCoverage* coverage_ = nullptr;
};

}  // namespace

void nodal_normals(const MortarSurfaces& surfaces, const MortarTopology& topology, std::span<const Vec3> x,
                   std::vector<Vec3>& normals, NodeBlocks<Mat3>* slopes, const FacetCoverage* coverage) {
  const std::size_t rows = surfaces.rows.size();
  normals.assign(rows, Vec3::Zero());
  if (slopes != nullptr) slopes->clear();
  for (std::size_t row = 0; row < rows; ++row) {
    const auto index = static_cast<LocalIndex>(row);
    const Mat3 left = surfaces.mirrors.rows() > 0 ? projector(surfaces.mirrors.row(index)) : Mat3(Mat3::Identity());
    const Around around(surfaces, topology.facets_around.row(index), x, coverage);
    const Vec3 mean = left * around.sum();
    const double size = mean.norm();
    if (size > 0) normals[row] = -mean / size;
    if (slopes == nullptr) continue;
    if (size > 0)
      around.add_slopes(-(Mat3::Identity() - normals[row] * normals[row].transpose()) * left / size, *slopes);
    slopes->nodes.close_row();
  }
}

}  // namespace brunt::contact
