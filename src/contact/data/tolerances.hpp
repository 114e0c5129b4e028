// SPDX-License-Identifier: Apache-2.0
// The numbers that determine decisions in contact: detection, lists, seams, ties, classes of surfaces, and the initial
// geometry (setup). All are dimensionless. "Size" is the longest edge of a face, or the length of the shorter of two
// edges; "element depth" is MasterFace::element_depth. They are data of a run, so that a study can vary one without
// compiling (tests/hard/sweep_tolerances.py); a scene cannot set them. Numbers that influence no decision are defined
// where they are used: widths of batches, limits of iterations, margins of searches.
#pragma once
#include <algorithm>

#include "contact/data/standard_tolerances.hpp"

namespace brunt::contact {

struct Tolerances {
  // Directions.

  /// Normals within this angle count as one direction: one row constrains them, and an edge between them is not sharp
  /// [degrees].
  double same_direction = 20;
  /// Cosine above which directions coincide: `same_direction`, rounded. Used for coincident faces, an edge along a
  /// normal, and a force of the last step along a new row.
  double aligned = 0.94;
  /// Cosine between a normal and the reversed other normal above which surfaces face each other: 60 degrees. Below, a
  /// row does not act along the other's normal.
  double facing = 0.5;
  /// Share or cosine below which a quantity is small. A face whose reversed normal has a smaller cosine with the
  /// slave's normal cone (see detection/cones.hpp) is a side, along which bodies slide. An edge slides along a face if
  /// its motion across it is below this share. Depths that differ by less than this share of their zone are equal.
  /// Normals with a shorter sum point away from each other (a blade without thickness). Iterations end at this share of
  /// the required accuracy.
  double slight = 0.1;
  /// Share of a quantity above which a second one competes with it: an opposition relative to the best one; the depth
  /// of a surface behind a face relative to a node's; motion along a ledge relative to that into its side.
  double competing = 0.5;
  /// Sine of the rotation of the normal of a warped face along its rim: normals of rows may lie outside the cone of an
  /// edge by this angle, and must lie inside it by this angle where a chain of edges ends.
  double warp = 0.1;
  /// Sine of the angle between neighbouring facets of a flat surface; smaller angles are not edges.
  double facet_curvature = 0.02;
  /// Sine up to which edges are parallel.
  double parallel = 1e-3;
  /// Angle between edges of a chain that a node has deformed [radians].
  double kink = 0.5;

  // Edges of the surface, by the angle between the normals of their faces [degrees].

  /// Convex edges are blunt from this angle between the normals of their faces, and sharp from `same_direction`
  /// [degrees]. Facets of round bodies differ by 22.5 degrees with 16 elements around, by 5.6 with 64. Flatter edges
  /// pass over a rim between its nodes with an energy error below 1e-7. Also: a row within this angle of an edge's row
  /// constrains the edge.
  double blunt_angle = 4;

  // Reach, as shares of the size.

  /// A node farther from a face's swept box, or deeper below it, has no contact with the face.
  double capture = 0.25;
  /// The same as a share of the element depth: behind flat elements lie other bodies that touch the far side, and the
  /// motion due to a step's impulses scales with the thickness of elements, not with their length.
  double element_share = 0.5;
  /// Accuracy of positions: a node whose projection misses a face by less may still touch it (rims of equal bodies
  /// slide and bulge), and hits closer to each other than this at a convex edge or corner are one.
  double rim = 0.02;
  /// A node above a face with a smaller motion in the step is judged by its closest point only.
  double slow = 0.05;
  /// Nodes of two bodies closer than this share of the mean element depth are coincident: one pass is then sufficient.
  double coincidence = 0.01;

  // Depth.

  /// Share of the size: a node no farther from a plane lies in it (dents between faces, rounding in mesh files, facets
  /// of a curved fit). Nodes deeper inside at the start overlap. For fitted bodies it also replaces `drift`.
  double touching = 1e-4;

  // Ledges and seams.

  /// Share of the size: settlement of flush bodies under load. Steps up to this height are ledges, which are ignored.
  /// Rims extend over flat edges by this share: on flat surfaces rows of nodes carry the load, and rows of rims remain
  /// open, since a row that exists only when a rim has penetrated would alternate from step to step.
  double ledge = 1e-3;
  /// Faces of two bodies are flush if one, continued by this share of its size (for a flat element, of twice its
  /// depth), comes no farther from the other.
  double seam_reach = 0.05;
  /// Sampling points along the side of a face for the search of the other one: at this share from both ends.
  double seam_sample = 0.25;

  // Recovery of penetrations.

  /// Share of a penetration (of a drift, a slip) that a step may recover.
  double recovery = 0.05;
  /// Upper bound of this recovery as a share of the size.
  double recovery_limit = 1e-3;
  /// Share of the time of sound along the size: the shortest step in the formula for recovery.
  double recovery_time = 0.5;
  /// Share of the size: penetration that a step leaves at a surface by itself.
  double drift = 3e-5;

  // Rounding.

  /// Quantities below this share of their reference are rounding of positions and normals.
  double rounding = 1e-6;
  /// The same for quantities that are rounded only a few times.
  double fine_rounding = 1e-9;

  // Bodies.

  /// Mean areas and masses of two bodies that differ by less than this share are equal: the next criterion decides.
  double equal_figures = 0.01;
  /// Ratio of edges up to which meshes are similar. It affects cost only: two passes are valid for meshes of any ratio,
  /// but the error of one pass decreases with the ratio (tables of cases/patch_test and cases/stack), and two passes
  /// cost about 1.4 times as much.
  double similar_edges = 1.4;

  // Start of a run.

  /// Ratio of edges above which a slave that the scene names is reported as coarse. The penetration of the master's
  /// unconstrained nodes grows with the ratio, from a few percent of their edge at 1.5 to a quarter at 2.2 and a full
  /// edge at 6.7 (sliding rubber blocks); up to 2 it is that of any one-pass contact.
  double coarse_slave = 2;
  /// Share of its volume that an element must keep at each corner when overlaps are moved out.
  double kept_volume = 0.2;

  /// Depth behind a face up to which a node is in contact with it; this far below a seam its side is ignored, whatever
  /// the settlement of flush bodies under load: a step at the start is not a seam (`seam_reach`). size: the face's
  /// longest edge.
  [[nodiscard]] double max_penetration(double size, double element_depth) const {
    return std::min(capture * size, element_share * element_depth);
  }
  /// Distance from the swept box of a face (or edge) beyond which nothing is considered; increases with the size.
  [[nodiscard]] double reach(double size, double element_depth) const {
    return std::max(rim * size, max_penetration(size, element_depth));
  }
};

}  // namespace brunt::contact
