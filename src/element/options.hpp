// SPDX-License-Identifier: Apache-2.0
// Choices of the user for the elements of a part.
#pragma once

namespace brunt::element {

enum class ElementKind {
  hex8,         ///< eight nodes, one point, hourglass control
  hex8_full,    ///< eight nodes, 2x2x2 points
  hex8_bbar,    ///< eight nodes, 2x2x2 points, dilatation averaged over the element (B-bar)
  tet4,         ///< four nodes, one point; stiff (locks) in bending and in nearly incompressible flow
  shell4,       ///< shell of four nodes, one point in its plane, hourglass control (Belytschko, Tsay)
  shell4_full,  ///< shell of four nodes, 2x2 points in its plane, assumed shear strains (Bathe, Dvorkin)
  shell3        ///< shell of three nodes, one point in its plane
};

constexpr bool is_shell(ElementKind kind) {
  return kind == ElementKind::shell4 || kind == ElementKind::shell4_full || kind == ElementKind::shell3;
}

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
    case ElementKind::shell4:
      return "shell4";
    case ElementKind::shell4_full:
      return "shell4_full";
    case ElementKind::shell3:
      return "shell3";
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

/// Points through the thickness of a shell.
enum class ThicknessRule {
  gauss,   ///< Gauss and Legendre: exact for polynomials of degree 2 n - 1, none on the faces
  lobatto  ///< with points on both faces; from two on
};

/// What a shell is besides its reference surface, the surface of its nodes.
struct ShellSection {
  static constexpr int most_points = 10;
  double thickness = 0;  ///< at the start [length] > 0
  int points = 5;        ///< through the thickness, 1 to most_points; one point has no resistance to bending
  ThicknessRule rule = ThicknessRule::gauss;
  double offset = 0;     ///< of the middle from the reference surface along the normal, in thicknesses [-0.5, 0.5]
  bool thinning = true;  ///< the thickness follows the strain normal to the shell
  bool warping = true;   ///< one-point quadrilaterals: fibres follow the warped surface
};

}  // namespace brunt::element
