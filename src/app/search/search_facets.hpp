// SPDX-License-Identifier: Apache-2.0
// `brunt search --method kdop`: trees of 18-DOPs, on scenes of nodes and boxes and on scenes of facets.
#pragma once
#include <span>
#include <string>

#include "core/ragged.hpp"
#include "geometry/box.hpp"
#include "search_report.hpp"

namespace brunt::app {

/// Whether a file begins as a scene of facets does.
bool is_facet_scene(const std::string& path);

/// Pairs of the facets of two sides in a scene of the format
///
///   facets1 NAME n m d
///   x y z              n nodes
///   side n0 n1 n2 n3   m facets: side 0 slave, 1 master; corners are nodes from 0, n3 is -1 of a triangle
///
/// whose 18-DOPs overlap, each facet enlarged by the distance d [length]. Under several ranks slave facets stay in the
/// blocks they are dealt out in, and master facets come as ghosts. Collective.
SearchResult search_facets(const comm::Communicator& ranks, const SearchOptions& options);

/// pairs row p: the boxes that contain point p, ascending, by a tree of the points and a tree of the boxes.
Timing search_boxes_by_trees(std::span<const Vec3> points, std::span<const geometry::Box> boxes,
                             Ragged<LocalIndex>& pairs);

}  // namespace brunt::app
