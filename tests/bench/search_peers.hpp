// SPDX-License-Identifier: Apache-2.0
// Searches of other libraries behind one signature, each in its own file and there only if the library was found.
#pragma once
#include <array>
#include <vector>

#include "search_scenes.hpp"

namespace brunt::bench {

/// (box, node) in any order.
using BoxNode = std::array<LocalIndex, 2>;

/// Builds from nothing, finds all nodes in closed boxes, own nodes of a face among them, and appends the pairs.
using Search = void (*)(const SearchScene& scene, std::vector<BoxNode>& pairs);

void search_boost(const SearchScene& scene, std::vector<BoxNode>& pairs);      ///< rtree, packed, over the nodes
void search_bullet(const SearchScene& scene, std::vector<BoxNode>& pairs);     ///< btDbvt, inserted in random order
void search_cgal(const SearchScene& scene, std::vector<BoxNode>& pairs);       ///< box_intersection_d
void search_embree(const SearchScene& scene, std::vector<BoxNode>& pairs);     ///< point queries in user geometry
void search_fcl(const SearchScene& scene, std::vector<BoxNode>& pairs);        ///< dynamic tree of objects
void search_nanoflann(const SearchScene& scene, std::vector<BoxNode>& pairs);  ///< balls around boxes, then filtered

}  // namespace brunt::bench
