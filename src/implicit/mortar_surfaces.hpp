// SPDX-License-Identifier: Apache-2.0
// The whole surfaces of all mortar interfaces, as every rank knows them while interfaces are made.
#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "brunt/comm/communicator.hpp"
#include "brunt/contact/mortar/interface.hpp"
#include "brunt/model/model.hpp"

namespace brunt::implicit {

/// An exterior face of a body in contact.
struct FaceRecord {
  GlobalIndex key = 0;
  std::array<GlobalIndex, 4> node{};  ///< the last -1 for a triangle
  std::int32_t block = 0;
  Rank rank = 0;  ///< that has its element
};

struct NodeRecord {
  GlobalIndex gid = 0;
  Rank owner = 0;
  LocalIndex node = 0;  ///< of the owner
  std::array<double, 3> reference{};
  std::array<double, 9> free{1, 0, 0, 0, 1, 0, 0, 0, 1};  ///< projector on what supports leave free, by rows

  [[nodiscard]] Mat3 free_directions() const;
};

struct MirrorRecord {
  GlobalIndex gid = 0;
  std::array<double, 3> normal{};  ///< of a plane of symmetry that the node lies in
};

struct WholeSurfaces {
  std::vector<FaceRecord> faces;      ///< by key
  std::vector<NodeRecord> nodes;      ///< by gid
  std::vector<MirrorRecord> mirrors;  ///< by gid
  std::vector<Vec3> reference;        ///< of `nodes` [length]
  std::vector<Mat3> free;             ///< of `nodes`
};

/// Collective.
WholeSurfaces tell_surfaces(const comm::Communicator& ranks, const model::Model& model);

/// The faces of one block in the order of their keys; nodes: places in WholeSurfaces::nodes.
struct WholeSide {
  std::vector<contact::FacetNodes> facets;
  std::vector<GlobalIndex> key;
  std::vector<Rank> rank;
};
WholeSide side_of(const WholeSurfaces& whole, std::int32_t block);

}  // namespace brunt::implicit
