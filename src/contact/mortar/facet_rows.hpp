// SPDX-License-Identifier: Apache-2.0
// The part of one slave facet in the rows of its nodes: weights over its own nodes, and their derivatives.
#pragma once
#include <vector>

#include "contact/mortar/interface.hpp"

namespace brunt::contact {

class FacetRows {
 public:
  /// Returns false if nothing is covered. candidates: master facets.
  bool evaluate(const MortarSurfaces& surfaces, std::size_t facet, std::span<const LocalIndex> candidates,
                std::span<const Vec3> x, bool with_slopes);

  [[nodiscard]] std::size_t corners() const { return corners_; }
  [[nodiscard]] std::size_t segments() const { return integrals_.size(); }
  /// The slave's corners, then master nodes.
  [[nodiscard]] std::span<const LocalIndex> nodes() const { return nodes_; }
  /// w_jK: + int psi_j N_K at slave nodes, - int psi_j N_K at master nodes.
  [[nodiscard]] double weight(std::size_t j, std::size_t node) const { return weights_[j * nodes_.size() + node]; }
  /// Derivatives of w_jK by all coordinates of the facet's nodes: 3 node + axis.
  [[nodiscard]] std::span<const double> slope(std::size_t j, std::size_t node) const {
    const std::size_t size = 3 * nodes_.size();
    return {slopes_.data() + (j * nodes_.size() + node) * size, size};
  }
  [[nodiscard]] double share(std::size_t j) const { return functions_.share[j]; }
  /// Its derivative by each of nodes(); after an evaluation with slopes [length].
  [[nodiscard]] Vec3 share_slope(std::size_t j, std::size_t node) const;
  /// Of the overlap [length^2].
  [[nodiscard]] double covered_area() const;
  /// Its derivative by each of nodes(); after an evaluation with slopes [length].
  [[nodiscard]] Vec3 covered_area_slope(std::size_t node) const;
  /// Of the facet's own area, in direction 3 node + axis of nodes() [length].
  [[nodiscard]] double area_slope(std::size_t direction) const;
  /// sum_K w_jK (x_K - centre).
  [[nodiscard]] Vec3 gap_vector(std::size_t j) const;
  /// Its derivative by node `node`, for all nodes at once [length^2].
  void gap_slopes(std::size_t j, std::vector<Mat3>& slopes) const;
  /// Derivatives by all nodes of sum_K w_jK y_K, for positions y that do not move with the nodes [length^2].
  void fixed_slopes(std::size_t j, std::span<const Vec3> places, std::vector<Mat3>& slopes) const;
  /// sum_j T_j (x) dw_jK: matrix with 3 nodes() rows and columns.
  void traction_patch(const std::array<Vec3, 4>& tractions, std::vector<double>& values) const;

 private:
  void find_segments(const MortarSurfaces& surfaces, std::size_t facet, std::span<const LocalIndex> candidates,
                     std::span<const Vec3> x, bool with_slopes);
  void number_nodes(const MortarSurfaces& surfaces, const FacetNodes& slave, std::span<const Vec3> x);
  void fill_weights();
  void fill_slopes();
  void sum_mass_slopes();
  void differentiate_functions();
  double* row_slope(std::size_t j, std::size_t node) {
    return slopes_.data() + (j * nodes_.size() + node) * 3 * nodes_.size();
  }
  /// Target of direction 3 k of a segment's derivatives: k is a corner of the slave or 4 + one of the master.
  [[nodiscard]] std::size_t local_node(std::size_t segment, std::size_t k) const {
    return k < 4 ? k : local_[segment][k - 4];
  }

  SlavePlane plane_;
  std::size_t corners_ = 0;
  std::vector<SegmentIntegrals> integrals_;
  std::vector<SegmentSlopes> segment_slopes_;      ///< of each segment; unused entries keep their memory
  std::vector<LocalIndex> masters_;                ///< of each segment
  std::vector<std::array<std::size_t, 4>> local_;  ///< of each segment: places of its master's corners in nodes_
  std::vector<std::size_t> master_corners_;        ///< of each segment
  MultiplierFunctions functions_;
  std::vector<LocalIndex> nodes_;
  std::vector<Vec3> positions_;  ///< from the slave's centre
  std::vector<double> weights_, slopes_;
  std::vector<double> hats_;                         ///< 4 x nodes: sums of int N_k N_C
  std::vector<double> mass_slopes_, matrix_slopes_;  ///< 10, 16 rows of 3 nodes
};

}  // namespace brunt::contact
