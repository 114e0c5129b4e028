// SPDX-License-Identifier: Apache-2.0
// Thresholds of the guards of a run.
#pragma once

namespace brunt::scene {

/// Energies as shares of the largest energy of the run; depths as shares of an element.
struct Guards {
  double energy_warning = 0.01;    ///< the usual bound of the error of an energy balance
  double energy_stop = 0.1;        ///< velocities are wrong by a third (energy is proportional to the square)
  double kinetic = 1.5;            ///< kinetic energy over the energy that was supplied
  double depth_warning = 0.1;      ///< nodes and edges in other bodies
  double depth_stop = 1;           ///< contact reaches half an element: what is deeper than one is lost
  double depth_step = 0.2;         ///< deeper in an implicit step than at its start: the step is halved
  double parted = 0.03;            ///< taken by contact of bodies that have separated again
  double hourglass = 0.1;          ///< of the largest internal energy
  double angular_momentum = 1e-3;  ///< angular_momentum_error of contact
};

}  // namespace brunt::scene
