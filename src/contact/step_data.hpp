// SPDX-License-Identifier: Apache-2.0
// The arrays of one contact step. They are sized when lists are rebuilt, so that a step allocates nothing.
#pragma once
#include <array>
#include <vector>

#include "contact/data/constraint.hpp"
#include "contact/data/held_bodies.hpp"
#include "contact/data/history.hpp"
#include "contact/detection/detection.hpp"
#include "contact/detection/tilts.hpp"
#include "contact/enforcement/impact_return.hpp"
#include "contact/enforcement/system.hpp"
#include "contact/lists/list_motion.hpp"
#include "contact/lists/lists.hpp"
#include "contact/mortar_rows/mortar_rows.hpp"

namespace brunt::contact {

/// The data that `gather` reads from the model, so that it need not traverse the whole surface.
struct GatherPlan {
  struct Node {
    LocalIndex contact_node, model_node;
  };
  struct Facet {
    LocalIndex face, corner_count;
    std::array<LocalIndex, 4> model_nodes;
  };
  std::vector<Node> nodes;    ///< contact nodes that this rank's mesh has
  std::vector<Facet> facets;  ///< surface faces whose area vector some rank needs
};

/// The validity of the lists, and data that are created with them.
struct ListState {
  ListMotion motion;          ///< of surface nodes, then of walls
  double motion_allowed = 0;  ///< [length]
  double separation = 0;      ///< of candidates of any rank when the lists were made: see detection/separation.hpp
  double last_dt = 0;         ///< of the step before [time]
  bool exist = false;
  bool are_new = false;                  ///< of this step
  GatherPlan gather;                     ///< of these lists
  std::vector<LocalIndex> faces_by_key;  ///< of these lists; empty where nothing looks faces up
  ListScratch scratch;
};

/// Arrays over the contact nodes of this rank.
struct ContactNodes {
  std::vector<NodeMotion> motion;
  std::vector<Mobility> mobility;
  std::vector<CarriedPoint> carried;  ///< by rigid bodies, ascending
  std::vector<Vec3> velocity;         ///< after contact
  std::vector<Vec3> reference;        ///< at the start; empty where no overlaps of the start are accepted
  std::vector<double> transit;        ///< of half an element, see transits.hpp [time]; empty without Impact::elastic
};

struct StepScratch {
  DetectionScratch detection;
  std::vector<NodeHold> holds;  ///< of each contact node
  RowSortScratch row_sort;
  std::vector<BirthRecord> births;
  MortarScratch mortar;
  EnforcementScratch enforcement;
  ImpactScratch impact;
  TiltStore tilts;
  std::vector<HistoryRecord> next_pairs;
  std::vector<AnchorRecord> next_anchors;
  std::vector<Vec3> slid;  ///< of each row with friction, see write_anchors [length]
};

struct StepData {
  ContactNodes nodes;
  std::vector<Vec3> own_area, facet_area;  ///< area vectors of faces, a corner's share: of this rank's, of the lists'
  std::vector<LocalIndex> mortar_places;   ///< of the terms of kept mortar rows: contact nodes, facets
  std::vector<HeldBodies> held;            ///< of contact nodes; empty without mortar rows
  std::vector<char> settled;               ///< of the candidate faces of slaves, see FaceInput
  std::vector<Row> rows;                   ///< of the last step, on this rank
  std::vector<Vec3> impulses;              ///< of those rows [momentum]
  StepScratch scratch;
};

}  // namespace brunt::contact
