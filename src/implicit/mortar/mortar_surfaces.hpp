// SPDX-License-Identifier: Apache-2.0
// The whole surfaces of all mortar interfaces, known to every rank during the set-up of interfaces.
#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "comm/communicator.hpp"
#include "contact/mortar/interface.hpp"
#include "model/model.hpp"

namespace brunt::implicit {

/// An exterior face of a body in contact.
struct FaceRecord {
  GlobalIndex key = 0;
  std::array<GlobalIndex, 4> node{};  ///< the last is -1 for a triangle
  std::int32_t block = 0;
  Rank rank = 0;  ///< rank of its element
};

struct NodeRecord {
  GlobalIndex gid = 0;
  Rank owner = 0;
  LocalIndex node = 0;  ///< local index on the owner
  std::array<double, 3> reference{};
  std::array<double, 9> free{1, 0, 0, 0, 1, 0, 0, 0, 1};  ///< projector onto directions without supports, by rows

  [[nodiscard]] Mat3 free_directions() const;
};

struct MirrorRecord {
  GlobalIndex gid = 0;
  std::array<double, 3> normal{};  ///< of a plane of symmetry that contains the node
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

/// For the node of each row: unit normals of the planes of symmetry that contain it.
Ragged<Vec3> mirrors_at(const WholeSurfaces& whole, std::span<const LocalIndex> rows);

}  // namespace brunt::implicit
