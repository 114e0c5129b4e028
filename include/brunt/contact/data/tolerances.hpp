// SPDX-License-Identifier: Apache-2.0
// The numbers that decide in contact: detection, lists, seams, ties, classes of surfaces, and the geometry of the start
// (setup). All are dimensionless. "Size" is the longest edge of a face, or the length of the shorter of two edges;
// "element depth" is MasterFace::element_depth. They are data of a run, so that an experiment can vary one without
// compiling (tests/hard/sweep_tolerances.py); a scene cannot set them. Numbers that change no decision stay where they
// are used: widths of batches, limits of iterations, margins of searches.
#pragma once
#include <algorithm>

#include "brunt/contact/data/standard_tolerances.hpp"

namespace brunt::contact {

struct Tolerances {
  // Directions.

  /// Normals within this angle are one direction: one row holds them, and an edge between them is not sharp [degrees].
  double same_direction = 20;
  /// Cosine from which directions are one: `same_direction`, rounded. Of faces that lie on each other, of an edge along
  /// a normal, of a force of the last step along a new row.
  double aligned = 0.94;
  /// Cosine between a normal and the reversed other from which surfaces face each other: 60 degrees. Below, a row does
  /// not hold along the other's normal.
  double facing = 0.5;
  /// Share or cosine below which something is slight: a face whose reversed normal has a lesser cosine with the slave's
  /// normal cone (see detection/cones.hpp) is a side, along which bodies slide; an edge slides along a face though it
  /// moves across it by so much; depths that differ by so much of their zone are equal; normals whose sum is shorter
  /// look away from each other (a blade without thickness). Iterations end at so much of what is wanted.
  double slight = 0.1;
  /// Share of a quantity from which a second one competes with it: a lesser opposition with the best; the depth of a
  /// surface behind a face with a node's; motion along a ledge with that into its side.
  double competing = 0.5;
  /// Sine by which the normal of a warped face turns along its rim: normals of rows may lie so far outside of the cone
  /// of an edge, and must lie so far inside of it where a chain of edges ends.
  double warp = 0.1;
  /// Sine of the angle between neighbouring facets of a flat surface; below, an edge is none.
  double facet_curvature = 0.02;
  /// Sine up to which edges are parallel.
  double parallel = 1e-3;
  /// Angle between edges of a chain that a node presses in [radians].
  double kink = 0.5;

  // Edges of the surface, by the angle between the normals of their faces [degrees].

  /// Convex edges are blunt from this angle between the normals of their faces on, and sharp from `same_direction` on
  /// [degrees]. Facets of round bodies differ by 22.5 degrees with 16 around, by 5.6 with 64. Edges flatter than 4 slip
  /// over a rim between its nodes without harm: a steel peg with 96 around (3.75 degrees) that drifts in its hole is
  /// given 3e-8 of its energy as it goes in, as with 80 (4.5 degrees).
  /// A row within this angle of an edge's holds the edge.
  double blunt_angle = 4;

  // Reach, as shares of the size.

  /// A node farther from a face's swept box, or deeper below it, has nothing to do with the face.
  double capture = 0.25;
  /// The same as a share of the element depth: behind flat elements lie other bodies that touch the far side, and what
  /// a step's impulses move goes with the thickness of elements, not with their length.
  double element_share = 0.5;
  /// A place is exact to this share: a node that projects beside a face by less may still meet it (rims of equal bodies
  /// slide and bulge), and hits nearer to each other at a convex edge or corner are one.
  double rim = 0.02;
  /// A node above a face that moves less than this within the step is judged by its closest point alone.
  double slow = 0.05;
  /// Nodes of two bodies nearer than this share of the mean element depth are coincident: one pass is as good as two.
  double coincidence = 0.01;

  // Depth.

  /// Share of the size: a node that is no farther from a plane is in it (dents between faces, rounding in mesh files,
  /// facets of a curved fit). Nodes deeper inside at the start overlap. Of fitted bodies it stands for `drift` as well.
  double touching = 1e-4;

  // Ledges and seams.

  /// Share of the size: what flush bodies settle under load. Steps up to this height are ledges, which are passed over;
  /// rims hang over flat edges by so much: on flat surfaces rows of nodes hold all, and those of rims are left open. (A
  /// row that is there only when a rim has sunk in lets go of it for a step.)
  double ledge = 1e-3;
  /// Faces of two bodies are flush where one, continued by this share of its size (of a flat element, of twice its
  /// depth), comes no farther from the other.
  double seam_reach = 0.05;
  /// Where along the side of a face the other one is looked for: at this share from either end.
  double seam_sample = 0.25;

  // Recovery of penetrations.

  /// Share of a penetration (of a drift, a slip) that a step may recover.
  double recovery = 0.05;
  /// The same limited to this share of the size.
  double recovery_limit = 1e-3;
  /// Share of the time that sound takes along the size: the shortest step that recovery is measured with.
  double recovery_time = 0.5;
  /// Share of the size: penetration that a step leaves at a surface by itself.
  double drift = 3e-5;

  // Rounding.

  /// What is less than this share of what it is compared with is rounding of positions and normals.
  double rounding = 1e-6;
  /// The same of quantities that are rounded a few times alone.
  double fine_rounding = 1e-9;

  // Bodies.

  /// Mean areas and masses of two bodies that differ by less than this share are equal: the next criterion decides.
  double equal_figures = 0.01;
  /// Ratio of edges up to which meshes are similar. A matter of cost alone: two passes hold meshes of any ratio, but
  /// one pass errs less the more they differ (cases/patch_test: by 14 % at 2 on 3, 4 % at 4 on 7). In cases/stack, 2 on
  /// 3, both ways are as deep (6e-6 of a side) and as still; two passes take 3.0 iterations a step for 1.6, and 1.4
  /// times the time.
  double similar_edges = 1.4;

  // Start of a run.

  /// Ratio of edges from which a slave that the scene names is reported as coarse. Blocks of rubber that slide on finer
  /// ones at 5 m/s, with edges 1.5, 1.9, 2.2, 3.3, 6.7 times as long: nodes of the master that are not held (all with
  /// `one`) sink by 3, 10, 24, 42, 105 % of an edge of theirs. Up to twice that is what one pass leaves anyway.
  double coarse_slave = 2;
  /// Share of its volume that an element must keep at each corner where overlaps are moved out.
  double kept_volume = 0.2;

  /// How far behind a face a node is in contact with it; so far below a seam its side is not met, however far flush
  /// bodies sag under load: a step at the start is no seam (`seam_reach`). size: the face's longest edge.
  [[nodiscard]] double max_penetration(double size, double element_depth) const {
    return std::min(capture * size, element_share * element_depth);
  }
  /// What is farther from the swept box of a face (or edge) is not looked at; grows with the size.
  [[nodiscard]] double reach(double size, double element_depth) const {
    return std::max(rim * size, max_penetration(size, element_depth));
  }
};

}  // namespace brunt::contact
