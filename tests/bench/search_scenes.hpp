// SPDX-License-Identifier: Apache-2.0
// Scenes of contact nodes and capture boxes on which searches are compared.
#pragma once
#include <array>
#include <string>
#include <vector>

#include "core/types.hpp"
#include "geometry/box.hpp"

namespace brunt::bench {

/// Coordinates are floats kept as doubles, so that single-precision libraries find the same pairs.
struct SearchScene {
  std::string name;
  std::vector<Vec3> nodes;
  std::vector<geometry::Box> boxes;
  std::vector<std::array<LocalIndex, 4>> own;  ///< nodes of each face, which are no partners of it; -1: none
};

/// Two facing plates, meshes 1.00 : 0.93, gap 0.05 and capture 0.1 of an edge; in the axes or turned.
SearchScene plates(std::size_t node_count, bool turned);
/// A shell folded into 40 layers 0.6 edges apart, bent and jittered, in contact with itself: 15 pairs a face.
SearchScene crumple(std::size_t node_count);
/// Uniform in a cube, box sides 0.5 to 1.5 mean distances.
SearchScene random_volume(std::size_t node_count);
/// A rod of 1000 : 1 in a sleeve, along a diagonal, and 24 nodes and faces up to 1000 lengths away.
SearchScene rod(std::size_t node_count);
/// Plates whose edges grow geometrically along one side by 1 : 1000.
SearchScene graded(std::size_t node_count);
/// Nodes of a turned plane whose faces do not reach out of it.
SearchScene flat(std::size_t node_count);
/// A third of the nodes at one place with one face around them, the rest uniform in a cube.
SearchScene one_place(std::size_t node_count);
/// A cube of uniform nodes 10^6 sizes from the origin, a copy of it a thousandth in size as far on the other side, and
/// a hundred nodes and faces anywhere between.
SearchScene clusters(std::size_t node_count);

/// Nodes and boxes after a wave-like motion with some noise, at most about `by` times the mean box edge.
SearchScene moved(SearchScene scene, double by);

SearchScene scene_by_name(const std::string& name, std::size_t node_count);

}  // namespace brunt::bench
