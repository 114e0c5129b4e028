// SPDX-License-Identifier: Apache-2.0
// The change of a facet's unit normal in a step, as an exact linear function of the motion of its corners.
//
// With the diagonals d_1, d_2 (of a triangle: two sides) the normal n is defined by n . d_1 = n . d_2 = 0, n . n = 1.
// The change of a product of two vectors is each one's change times the mean of the other. The change of the normal is
// therefore the solution y of
//   y . d_i = - n . (change of d_i),  y . n = 0,
// where d_i and n are means of both ends of the step. As a linear function of any motion, y is the derivative of the
// normal up to second order in the step, and a rotation of the mean corners turns the mean n exactly. So the forces
// D^T q of a vector q do the work q . (change of n), and their moment is (mean n) x q: ties keep energy and angular
// momentum (O. Gonzalez, CMAME 174 (1999) 1: constraints by discrete derivatives).
#pragma once
#include <array>
#include <cstddef>

#include "contact/mortar/segment.hpp"

namespace brunt::contact {

class NormalChange {
 public:
  /// From one end of a step to the other.
  NormalChange(FacetCorners before, FacetCorners now);
  /// The derivative at one configuration.
  explicit NormalChange(FacetCorners x);

  /// Unit, at the end; outward.
  [[nodiscard]] const Vec3& normal() const { return normal_; }
  /// The change of the normal by the motion of a corner [1/length].
  [[nodiscard]] Mat3 by_corner(std::size_t corner) const;
  /// Derivative, by corner `by` at the end, of by_corner(corner)^T q [force/length, if q is a force times a length].
  [[nodiscard]] Mat3 slope(const Vec3& q, std::size_t corner, std::size_t by) const;

 private:
  /// Coefficient of a corner in a diagonal.
  [[nodiscard]] double sign(std::size_t corner, std::size_t diagonal) const;

  bool triangle_;
  double share_;                  ///< of the end in the means
  Vec3 normal_, mean_normal_;     ///< the mean is not unit
  std::array<Vec3, 3> dual_;      ///< to both mean diagonals and the mean normal
  std::array<Vec3, 2> dual_now_;  ///< to the diagonals at the end
};

}  // namespace brunt::contact
