// SPDX-License-Identifier: Apache-2.0
// Choices of the user for the elements of a part.
#pragma once

namespace brunt::element {

enum class ElementKind {
  hex8,       ///< eight nodes, one point, hourglass control
  hex8_full,  ///< eight nodes, 2x2x2 points
  hex8_bbar,  ///< eight nodes, 2x2x2 points, dilatation averaged over the element (B-bar)
  tet4        ///< four nodes, one point; stiff (locks) in bending and in nearly incompressible flow
};

/// The name in a scene.
constexpr const char* name_of(ElementKind kind) {
  switch (kind) {
    case ElementKind::hex8:
      return "hex8";
    case ElementKind::hex8_full:
      return "hex8_full";
    case ElementKind::hex8_bbar:
      return "hex8_bbar";
    case ElementKind::tet4:
      return "tet4";
  }
  return "";
}

enum class HourglassKind {
  none,
  viscous,
  stiffness,  ///< springs whose forces plastic flow reduces together with the stress deviator
  elastic  ///< springs without such a reduction: they restrain the rim of regions of large flow, and prevent folding of
           ///< corners
};

struct Hourglass {
  HourglassKind kind = HourglassKind::stiffness;
  double coefficient = 0.05;  ///< dimensionless
};

/// Bulk viscosity: pressure -(linear rho c L e + quadratic^2 rho L^2 |e| e, the second in compression only), e the rate
/// of volume strain.
struct BulkViscosity {
  double linear = 0.06, quadratic = 1.2;  ///< dimensionless
};

}  // namespace brunt::element
