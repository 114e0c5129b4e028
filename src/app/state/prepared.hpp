// SPDX-License-Identifier: Apache-2.0
// All data of a run on one rank.
#pragma once
#include <array>
#include <memory>
#include <string>
#include <vector>

#include "app/program/start_up.hpp"
#include "app/whole/treat_overlaps.hpp"
#include "comm/communicator.hpp"
#include "contact/contact.hpp"
#include "driven_parts.hpp"
#include "guards.hpp"
#include "implicit/owner.hpp"
#include "mesh/canonical.hpp"
#include "model/model.hpp"
#include "model/registry.hpp"
#include "scene/input.hpp"
#include "step_work.hpp"
#include "time/assembled_step.hpp"
#include "time/erosion.hpp"
#include "time/links.hpp"

namespace brunt::implicit {
struct Scene;
}

namespace brunt::app {

/// Of each probe in Prepared::contact_memory.
constexpr std::size_t contact_memory_width = 5;

/// Elements eroded since this program started.
struct ErosionAccount {
  bool any = false;                          ///< whether any part erodes
  std::vector<time::ErosionCount> counts{};  ///< by block
  std::vector<time::ErosionCount> now{};     ///< likewise, of the last step
  GlobalIndex steps = 0;                     ///< steps in which elements were removed
};

/// Surfaces and pairs of parts that meet in an implicit scene, for judgements by positions; see implicit_watch.hpp.
struct WatchedBodies {
  contact::Surface surface;
  contact::PairTable pairs;
  std::vector<double> thinnest;  ///< of each block: least element depth at its surface at the start [length]
  std::vector<double> shares;    ///< depths at x_n, see DeepNodes
  double time = -1;              ///< to which they belong
};

struct Prepared {
  scene::Input input{};
  std::string fingerprint{};            ///< of scene and mesh, which must not change at a restart
  std::vector<std::string> warnings{};  ///< on the root
  TreatedOverlaps overlaps{};           ///< on the root, but for what is accepted or recovered
  model::Model model{};
  model::State state{};
  model::Scratch scratch{};
  time::Links links;
  std::unique_ptr<contact::Contact> contact{};        ///< null without contact and walls
  std::vector<std::array<std::string, 2>> tracked{};  ///< parts of contacts whose impulses are summed, as in the probes
  std::vector<double> contact_sums{};                 ///< exact sums of contact in the form of a checkpoint
  contact::HistoryTables contact_history{};           ///< history of contact, likewise

  std::vector<double> force_memory{};  ///< of force probes: impulse (3) and time of the last row
  Extremes extremes{};                 ///< extremes since t = 0

  std::vector<std::string>
      left_out{};  ///< on the root: blocks of mesh files that are ignored, and what sets lost by it
  std::vector<double> contact_memory{};  ///< of contact probes: friction (3), sizes (2); empty without such
  DrivenParts driven{};                  ///< parts that supports move through each other

  ErosionAccount erosion{};

  implicit::SolverOwner implicit{};          ///< null in explicit scenes
  std::unique_ptr<WatchedBodies> watched{};  ///< null in explicit scenes, and where nothing is to be watched

  time::AssembledStep assembled{};  ///< sized where run.step_bound asks for it

  std::string scene_values{};  ///< what the fingerprint is made of, so that a restart can say what differs
  std::string scene_yaml{};    ///< the whole scene after its overrides

  StartUp start_up{};
  StepWork work{};  ///< of this rank in this start

  /// All arrays of the state, the sums and the history of contact among them. Collective.
  model::Registry registry();
  /// Updates the state after a checkpoint has filled the registry.
  void after_restart();
};

/// The parts of a prepared run that implicit steps use.
implicit::Scene implicit_scene(Prepared& run);

/// Ends the relaxation phase: initial velocities, t = 0, ledgers and sums from zero. Collective.
void begin_run(Prepared& run);

}  // namespace brunt::app
