// SPDX-License-Identifier: Apache-2.0
// What masters cover of the slave facets of tied parts at the start: segments, and the multiplier functions of the
// corners (contact/TIES.md).
#pragma once
#include <span>
#include <vector>

#include "contact/mortar_rows/covers.hpp"

namespace brunt::contact {

/// Numbers that decide, see contact/TIES.md.
struct TieNumbers {
  double smooth = 0.866;   ///< cosine of the angle between a facet and the faces that cover it: 30 degrees
  double inclined = 0.05;  ///< share of the covered area that may be covered by faces at a larger angle
  double share = 0.4;      ///< of the largest share of a corner: where less is covered, a corner has no function
  double folded = 1e-6;    ///< of the facet: area covered twice
};
constexpr TieNumbers tie_numbers{};

struct TieSegment {
  LocalIndex face = 0;                            ///< of the master
  std::array<std::array<double, 4>, 4> weight{};  ///< int psi_j N_c over the segment [length^2]
};

/// Of one body on one slave facet.
struct TieCover {
  LocalIndex facet = 0;
  std::int32_t body = 0, block = 0;             ///< block: the lowest one of the faces
  bool whole = false;                           ///< nothing of the facet is left
  Vec3 normal = Vec3::Zero();                   ///< of the facet, unit, outward
  std::array<double, 4> share{};                ///< int psi_j; 0: the corner has no function [length^2]
  std::array<std::array<double, 4>, 4> own{};   ///< int psi_j N_k [length^2]
  std::array<std::array<double, 4>, 4> mass{};  ///< int N_j N_k [length^2]
  std::size_t first = 0, end = 0;               ///< segments
};

struct TieCovers {
  std::vector<TieCover> covers;
  std::vector<TieSegment> segments;
  std::vector<std::size_t> first;  ///< of the covers of each facet, and the end

  [[nodiscard]] std::span<const TieCover> of(LocalIndex facet) const {
    const auto f = static_cast<std::size_t>(facet);
    return std::span(covers).subspan(first[f], first[f + 1] - first[f]);
  }
  [[nodiscard]] std::span<const TieSegment> segments_of(const TieCover& cover) const {
    return std::span(segments).subspan(cover.first, cover.end - cover.first);
  }
};

/// Of all facets of the scene, by body. Facets whose faces are inclined against them, or cover a place twice, have
/// none.
TieCovers find_tie_covers(const MortarScene& scene);

/// Of each slave owned here the direction in which its functions are: that of the facets around it, within `facing` of
/// each other, that have most of it; zero for other nodes. So no node has functions on both sides of a feature edge.
std::vector<Vec3> tied_sides(const MortarScene& scene, const TieCovers& covers);

/// Gives the functions of corners that have little of a cover, or are of another side, to the other corners. sides: of
/// all contact nodes, from their owners.
void settle_functions(const MortarScene& scene, std::span<const Vec3> sides, TieCovers& covers);

}  // namespace brunt::contact
