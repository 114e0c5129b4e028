// SPDX-License-Identifier: Apache-2.0
// The work of a `brunt depth` command: bodies, and their poses.
#pragma once
#include <string>
#include <vector>

#include "app/program/depth_options.hpp"
#include "comm/communicator.hpp"
#include "depth/body.hpp"
#include "depth_bodies.hpp"

namespace brunt::app {

struct DepthWork {
  std::vector<NamedSurface> surfaces;
  std::vector<depth::Body> bodies;  ///< of these surfaces
  struct Pose {
    std::size_t a, b;
    Placement start;  ///< of a, in the coordinates of b
  };
  std::vector<Pose> poses;
  ConvexPieces pieces;             ///< of two files
  std::vector<Placement> samples;  ///< of a, in contact with b; none: not asked for
  std::vector<Vec3> along;         ///< axes of admitted translations; none: all
};

/// Translations first: their answers start the others.
[[nodiscard]] std::vector<depth::Metric> metrics_of(const DepthOptions& options);

/// Of two files and their poses, or of the pairs of a scene's parts that overlap. The same on all ranks. Collective;
/// throws InputError on all ranks.
[[nodiscard]] DepthWork depth_work(const comm::Communicator& ranks, const DepthOptions& options);

/// Everything on which the rows of a run depend, except its number of ranks.
[[nodiscard]] std::string fingerprint_of(const DepthOptions& options, const DepthWork& work);

}  // namespace brunt::app
