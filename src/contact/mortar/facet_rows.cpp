// SPDX-License-Identifier: Apache-2.0
#include "facet_rows.hpp"

#include <Eigen/Geometry>
#include <algorithm>

#include "contact/mortar/corners.hpp"
#include "fading.hpp"

namespace brunt::contact {

using Form = MultiplierFunctions::Form;

bool FacetRows::evaluate(const MortarSurfaces& surfaces, std::size_t facet, std::span<const LocalIndex> candidates,
                         std::span<const Vec3> x, bool with_slopes) {
  const FacetNodes& slave = surfaces.slave[facet];
  const CornersOf corners(slave, x);
  corners_ = corners.count;
  integrals_.clear();
  if (candidates.empty() || !make_slave_plane(corners.span(), plane_)) return false;
  find_segments(surfaces, facet, candidates, x, with_slopes);
  functions_ = multiplier_functions(plane_, integrals_, surfaces.multiplier_of(facet));
  if (functions_.form == Form::none) return false;
  number_nodes(surfaces, slave, x);
  fill_weights();
  if (with_slopes) fill_slopes();
  return true;
}

void FacetRows::find_segments(const MortarSurfaces& surfaces, std::size_t facet, std::span<const LocalIndex> candidates,
                              std::span<const Vec3> x, bool with_slopes) {
  masters_.clear();
  master_corners_.clear();
  SegmentIntegrals integrals;
  for (const LocalIndex master : candidates) {
    const CornersOf corners(nth(surfaces.master, master), x);
    const std::size_t next = integrals_.size();
    if (with_slopes && segment_slopes_.size() == next) segment_slopes_.emplace_back();
    if (!integrate_segment(plane_, corners.span(), surfaces.capture, integrals,
                           with_slopes ? &segment_slopes_[next] : nullptr))
      continue;
    if (integrals.distance < -surfaces.deepest(facet, static_cast<std::size_t>(master))) continue;
    if (surfaces.fading)
      fade(plane_, corners.span(), surfaces.capture, integrals, with_slopes ? &segment_slopes_[next] : nullptr);
    integrals_.push_back(integrals);
    masters_.push_back(master);
    master_corners_.push_back(corners.count);
  }
}

void FacetRows::number_nodes(const MortarSurfaces& surfaces, const FacetNodes& slave, std::span<const Vec3> x) {
  nodes_.assign(slave.begin(), slave.begin() + static_cast<std::ptrdiff_t>(corners_));
  local_.assign(masters_.size(), {});
  for (std::size_t s = 0; s < masters_.size(); ++s)
    for (std::size_t c = 0; c < master_corners_[s]; ++c) {
      const LocalIndex node = nth(surfaces.master, masters_[s])[c];
      const auto at = std::find(nodes_.begin() + static_cast<std::ptrdiff_t>(corners_), nodes_.end(), node);
      local_[s][c] = static_cast<std::size_t>(at - nodes_.begin());
      if (at == nodes_.end()) nodes_.push_back(node);
    }
  positions_.clear();
  for (const LocalIndex node : nodes_) positions_.push_back(nth(x, node) - plane_.centre);
}

void FacetRows::fill_weights() {
  const std::size_t n = nodes_.size();
  weights_.assign(corners_ * n, 0);
  hats_.assign(corners_ * n, 0);
  for (std::size_t j = 0; j < corners_; ++j)
    for (std::size_t k = 0; k < corners_; ++k) weights_[j * n + k] = functions_.slave_weight(j, k);
  for (std::size_t s = 0; s < integrals_.size(); ++s)
    for (std::size_t c = 0; c < master_corners_[s]; ++c)
      for (std::size_t j = 0; j < corners_; ++j) {
        const std::size_t at = j * n + local_[s][c];
        weights_[at] -= functions_.master_weight(j, c, integrals_[s]);
        hats_[at] += integrals_[s].master[j][c];
      }
}

/// Derivatives of M_jk, j <= k, by all coordinates.
void FacetRows::sum_mass_slopes() {
  const std::size_t size = 3 * nodes_.size();
  mass_slopes_.assign(10 * size, 0);
  for (std::size_t s = 0; s < integrals_.size(); ++s)
    for (std::size_t pair = 0; pair < 10; ++pair)
      for (std::size_t k = 0; k < 8; ++k) {
        if (k < 4 ? k >= corners_ : k - 4 >= master_corners_[s]) continue;
        double* to = mass_slopes_.data() + pair * size + 3 * local_node(s, k);
        const double* from = segment_slopes_[s].slave[pair].data() + 3 * k;
        for (int i = 0; i < 3; ++i) to[i] += from[i];
      }
}

/// Derivatives of the matrix A by all coordinates, and of the slave's weights.
void FacetRows::differentiate_functions() {
  const std::size_t size = 3 * nodes_.size();
  matrix_slopes_.assign(16 * size, 0);
  std::array<std::array<double, 4>, 4> mass{};
  for (std::size_t direction = 0; direction < size; ++direction) {
    std::array<double, 4> share{};
    for (std::size_t j = 0; j < corners_; ++j)
      for (std::size_t k = 0; k < corners_; ++k) {
        mass[j][k] = mass_slopes_[SegmentSlopes::pair_of_corners(j, k) * size + direction];
        share[j] += mass[j][k];
      }
    const double area = area_slope(direction);
    const auto slope = matrix_slope(functions_, share, mass, area);
    const double theta = functions_.dual_share, dtheta = dual_share_slope(functions_, share, area);
    for (std::size_t j = 0; j < corners_; ++j)
      for (std::size_t k = 0; k < corners_; ++k) {
        matrix_slopes_[(4 * j + k) * size + direction] = slope[j][k];
        const double lumped = j == k ? theta * share[j] + dtheta * functions_.share[j] : 0.0;
        row_slope(j, k)[direction] = lumped + (1 - theta) * mass[j][k] - dtheta * functions_.mass[j][k];
      }
  }
}

/// d(A X) = A dX + dA X, X_kC = int N_k N_C: the first part segment by segment, the second over all nodes.
void FacetRows::fill_slopes() {
  const std::size_t n = nodes_.size(), size = 3 * n;
  slopes_.assign(corners_ * n * size, 0);
  sum_mass_slopes();
  differentiate_functions();
  for (std::size_t s = 0; s < integrals_.size(); ++s)
    for (std::size_t j = 0; j < corners_; ++j)
      for (std::size_t c = 0; c < master_corners_[s]; ++c) {
        SegmentSlopes::Slopes sum{};
        for (std::size_t k = 0; k < corners_; ++k)
          for (std::size_t d = 0; d < sum.size(); ++d)
            sum[d] += functions_.matrix[j][k] * segment_slopes_[s].master[k][c][d];
        double* to = row_slope(j, local_[s][c]);
        for (std::size_t k = 0; k < 8; ++k) {
          if (k < 4 ? k >= corners_ : k - 4 >= master_corners_[s]) continue;
          for (std::size_t i = 0; i < 3; ++i) to[3 * local_node(s, k) + i] -= sum[3 * k + i];
        }
      }
  if (functions_.form != Form::dual) return;
  for (std::size_t j = 0; j < corners_; ++j)
    for (std::size_t c = corners_; c < n; ++c) {
      double* to = row_slope(j, c);
      for (std::size_t k = 0; k < corners_; ++k) {
        const double hat = hats_[k * n + c];
        const double* of_matrix = matrix_slopes_.data() + (4 * j + k) * size;
        for (std::size_t d = 0; d < size; ++d) to[d] -= hat * of_matrix[d];
      }
    }
}

double FacetRows::covered_area() const {
  double sum = 0;
  for (std::size_t j = 0; j < corners_; ++j) sum += functions_.share[j];
  return sum;
}

Vec3 FacetRows::share_slope(std::size_t j, std::size_t node) const {
  Vec3 sum = Vec3::Zero();
  for (std::size_t k = 0; k < corners_; ++k)
    sum += Vec3(&mass_slopes_[SegmentSlopes::pair_of_corners(j, k) * 3 * nodes_.size() + 3 * node]);
  return sum;
}

double FacetRows::area_slope(std::size_t direction) const {
  const std::size_t corner = direction / 3;
  if (corner >= corners_) return 0;
  const Vec3 by_d1 = 0.5 * plane_.diagonal[1].cross(plane_.normal),
             by_d2 = 0.5 * plane_.normal.cross(plane_.diagonal[0]);
  const std::array<Vec3, 4> quadrilateral{-by_d1, -by_d2, by_d1, by_d2}, triangle{-by_d1 - by_d2, by_d1, by_d2, {}};
  return (corners_ == 3 ? triangle : quadrilateral)[corner][static_cast<Eigen::Index>(direction % 3)];
}

Vec3 FacetRows::covered_area_slope(std::size_t node) const {
  Vec3 sum = Vec3::Zero();
  for (std::size_t j = 0; j < corners_; ++j) sum += share_slope(j, node);
  return sum;
}

Vec3 FacetRows::gap_vector(std::size_t j) const {
  Vec3 sum = Vec3::Zero();
  for (std::size_t k = 0; k < nodes_.size(); ++k) sum += weight(j, k) * positions_[k];
  return sum;
}

void FacetRows::gap_slopes(std::size_t j, std::vector<Mat3>& slopes) const {
  const std::size_t n = nodes_.size();
  slopes.resize(n);
  for (std::size_t k = 0; k < n; ++k) slopes[k] = weight(j, k) * Mat3::Identity();
  for (std::size_t k = 0; k < n; ++k) {
    const std::span<const double> of_weight = slope(j, k);
    for (std::size_t l = 0; l < n; ++l)
      slopes[l] += positions_[k] * Vec3(of_weight[3 * l], of_weight[3 * l + 1], of_weight[3 * l + 2]).transpose();
  }
}

void FacetRows::fixed_slopes(std::size_t j, std::span<const Vec3> places, std::vector<Mat3>& slopes) const {
  const std::size_t n = nodes_.size();
  slopes.assign(n, Mat3::Zero());
  for (std::size_t k = 0; k < n; ++k) {
    const std::span<const double> of_weight = slope(j, k);
    const Vec3 place = nth(places, nodes_[k]) - plane_.centre;  // weights have sum zero
    for (std::size_t l = 0; l < n; ++l)
      slopes[l] += place * Vec3(of_weight[3 * l], of_weight[3 * l + 1], of_weight[3 * l + 2]).transpose();
  }
}

void FacetRows::traction_patch(const std::array<Vec3, 4>& tractions, std::vector<double>& values) const {
  const std::size_t n = nodes_.size(), size = 3 * n;
  values.assign(size * size, 0);
  for (std::size_t j = 0; j < corners_; ++j) {
    if (tractions[j].isZero(0)) continue;
    for (std::size_t k = 0; k < n; ++k) {
      const std::span<const double> of_weight = slope(j, k);
      for (std::size_t i = 0; i < 3; ++i) {
        const double traction = tractions[j][static_cast<Eigen::Index>(i)];
        double* to = values.data() + (3 * k + i) * size;
        for (std::size_t d = 0; d < size; ++d) to[d] += traction * of_weight[d];
      }
    }
  }
}

}  // namespace brunt::contact
