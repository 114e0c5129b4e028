// SPDX-License-Identifier: Apache-2.0
// Input and output of a shell kernel: a batch of elements at once, one for each lane of a pack.
//
// A kernel is a small struct with its constants, templated over a material response, and
//   static constexpr int nodes, most_history;   corners an element; the largest number of values of its history
//   std::vector<HistoryField> history() const;  their names, in order; the first two are "mass" and "rotary_inertia"
//   void operator()(const ShellMotion<nodes>&, const Pack* committed, Pack* trial, ShellForce<nodes>&) const;
// as for solids (element/batch.hpp): `committed` at the start of the step, `trial` at its end, which may be the same
// memory. The first two entries are set once by the model and never written.
#pragma once
#include "core/simd.hpp"

namespace brunt::element {

/// Nodes move along chords, x(end) - x(start) = v dt, and turn by rotations whose Cayley vector is r dt: the rotation
/// (1 - [r dt/2])^-1 (1 + [r dt/2]), [.] the cross product. A rigid motion of a step then has v = r x (x - dt/2 v) +
/// const exactly, whatever its angle, and gives no strain at the midpoint.
template <int nodes>
struct ShellMotion {
  Pack x[3][nodes];  ///< positions at the end of the step [length]
  Pack v[3][nodes];  ///< mean velocities of the step [length/time]
  Pack r[3][nodes];  ///< rates of rotation of the step: Cayley's vector over dt [1/time]
  double dt = 0;     ///< of the step; zero in the first of a run
};

template <int nodes>
struct ShellForce {
  Pack f[3][nodes];  ///< minus the internal force on each corner [force]
  Pack m[3][nodes];  ///< minus the internal moment on each corner, about the node [force length]
  Pack rate;         ///< at least 1 / (largest stable step) of the free element [1/time]
  Pack volume;       ///< area times thickness; not positive (or NaN) where the element is turned inside out [length^3]
};

/// Positions in the history of all shells.
constexpr int at_shell_mass = 0, at_rotary_inertia = 1;

}  // namespace brunt::element
