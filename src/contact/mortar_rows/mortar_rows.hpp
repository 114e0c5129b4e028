// SPDX-License-Identifier: Apache-2.0
// Mortar rows of explicit steps: one a slave node and smooth part of its surface, of the gap averaged over what is
// covered of the facets around the node. See README.md.
//
//   renew:   weights, where bodies have moved against each other, have come near, or are old
//   rows:    of kept weights and the positions of this step; between renewals weights follow the slip to first order
//   friction: a node that sticks counts what it slips, and its row recovers that
#pragma once
#include <span>
#include <vector>

#include "contact/data/history.hpp"
#include "contact/detection/detection.hpp"
#include "contact/detection/tilts.hpp"
#include "contact/mortar_rows/integrate.hpp"

namespace brunt::contact {

/// Arrays of a step; they keep their memory.
struct MortarScratch {
  FacetCovers covers;
  NodeIntegration integration;
  MortarHistory fresh, next;  ///< of the slaves that are integrated, of all
  std::vector<LocalIndex> fresh_places, next_places;
  std::vector<char> renew;         ///< of each slave
  std::vector<Vec3> apart;         ///< of each kept row: sum of its weights and positions [length]
  std::vector<Vec3> facet_normal;  ///< unit
  std::vector<Vec3> normal;        ///< of each kept row, out of the master
  std::vector<double> kept_gap;    ///< of the rows before a renewal [length]
  std::vector<double> weights;     ///< of the rows of a step, see Row::wide_weights
};

/// Integrates the weights of slaves that need it. places: of the terms, contact nodes and facets; follows `history`.
/// Returns whether the kept rows are others than before.
bool renew_weights(const MortarScene& scene, MortarHistory& history, std::vector<LocalIndex>& places,
                   MortarScratch& scratch);

/// Appends the rows that may act in this step. Spans of the rows point into `places` and `scratch`.
void append_mortar_rows(const StepView& step, const MortarScene& scene, std::span<const LocalIndex> places,
                        MortarHistory& history, MortarScratch& scratch, std::vector<Row>& rows);

/// Share of the slip that is recovered in a step, and its bound [length].
struct SlipRecovery {
  double share = 0, limit = 0;
};

/// Row::drift and its share of the slip. Rows and history in order of their keys.
void aim_at_slips(std::span<Row> rows, const MortarHistory& history, const SlipRecovery& recovery, double dt);

/// Row::tilts of rows with friction, see detection/tilts.hpp. Rows and history in order of their keys.
void tilt_mortar_rows(std::span<Row> rows, const MortarHistory& history, const TiltScene& scene, TiltStore& store);

/// What nodes have slipped after the step: nothing where they were not pressed. slid: see write_anchors.
void keep_slips(std::span<const Row> rows, std::span<const Vec3> impulses, std::span<const Vec3> slid, double dt,
                const Tolerances& tolerances, MortarHistory& history);

}  // namespace brunt::contact
