// SPDX-License-Identifier: Apache-2.0
// The exterior surface of the bodies as a function of the mesh and of the remaining elements. A face is exterior if its
// own element remains and no element on its other side does, on whichever rank. Faces keep their keys for the whole
// run, so that stored references to them stay valid.
#pragma once
#include <span>
#include <vector>

#include "comm/communicator.hpp"
#include "comm/halo.hpp"
#include "core/ragged.hpp"
#include "mesh/local_mesh.hpp"

namespace brunt::surface {

/// Flags of this rank's elements by block: > 0 the element remains; < 0 it is removed together with its nodes. All
/// elements of a block without flags remain.
using Alive = std::span<const std::vector<double>>;

/// Interior faces of this rank's elements that may become exterior, and the elements behind them.
struct InnerFaces {
  std::vector<mesh::ExteriorFace> faces;  ///< ascending by key
  Ragged<LocalIndex> beyond;              ///< elements on the other side, a row a face: see `exposed_surface`
  comm::Halo foreign;                     ///< brings the flags of elements of other ranks among them
  bool any_foreign = false;               ///< on any rank
};

/// `faces`: both sides of each face that may be exposed; every rank gives those of its own elements (their bodies are
/// those of the mesh at the start). Collective.
InnerFaces join_faces(const comm::Communicator& ranks, const mesh::LocalMesh& mesh,
                      std::vector<mesh::ExteriorFace> faces);

/// Nodes of this rank without any remaining element on any rank, ascending.
struct BareNodes {
  std::vector<LocalIndex> kept;     ///< continue as mass points
  std::vector<LocalIndex> dropped;  ///< removed together with one of their elements
};

/// Collective.
BareNodes bare_nodes(const comm::Communicator& ranks, const mesh::LocalMesh& mesh, Alive alive);

/// A corner of a removed element at a node that continues as a mass point.
struct MassPoint {
  GlobalIndex key = 0;  ///< of the face of the removed element, the first one there
  LocalIndex node = 0;
  std::int32_t block = 0, body = 0;
};

struct ExposedSurface {
  std::vector<mesh::ExteriorFace> faces;  ///< of this rank's living elements, ascending by key
  std::vector<MassPoint> points;          ///< ascending by node, then by block: of this rank's removed elements
};

/// The present exterior surface. Collective.
ExposedSurface exposed_surface(const comm::Communicator& ranks, const mesh::LocalMesh& mesh, const InnerFaces& inner,
                               Alive alive);

}  // namespace brunt::surface
