// SPDX-License-Identifier: Apache-2.0
// The outside of the bodies as a function of the mesh and of which elements live: a face is outside where its own
// element lives and no element on its other side does, whichever rank has that one. Faces keep their keys for the whole
// run, so that whoever remembers a face finds it again.
#pragma once
#include <span>
#include <vector>

#include "brunt/comm/communicator.hpp"
#include "brunt/comm/halo.hpp"
#include "brunt/core/ragged.hpp"
#include "brunt/mesh/local_mesh.hpp"

namespace brunt::surface {

/// Flags of this rank's elements by block: > 0 lives, < 0 its nodes go with it. A block without flags lives whole.
using Alive = std::span<const std::vector<double>>;

/// Faces between elements that may come to the outside, of this rank's elements, and what is behind them.
struct InnerFaces {
  std::vector<mesh::ExteriorFace> faces;  ///< ascending by key
  Ragged<LocalIndex> beyond;              ///< elements on the other side, a row a face: see `exposed_surface`
  comm::Halo foreign;                     ///< brings the flags of other ranks' elements among them
  bool any_foreign = false;               ///< on any rank
};

/// `faces`: both sides of each face that may be exposed, every rank those of its own elements (their bodies are those
/// of the mesh at the start). Collective.
InnerFaces join_faces(const comm::Communicator& ranks, const mesh::LocalMesh& mesh,
                      std::vector<mesh::ExteriorFace> faces);

/// Nodes of this rank that no living element of any rank holds, ascending.
struct BareNodes {
  std::vector<LocalIndex> kept;     ///< fly on as mass points
  std::vector<LocalIndex> dropped;  ///< one of their elements took them along
};

/// Collective.
BareNodes bare_nodes(const comm::Communicator& ranks, const mesh::LocalMesh& mesh, Alive alive);

/// A corner of a removed element on a node that flies on as a mass point.
struct MassPoint {
  GlobalIndex key = 0;  ///< of the face of the removed element, the first one there
  LocalIndex node = 0;
  std::int32_t block = 0, body = 0;
};

struct ExposedSurface {
  std::vector<mesh::ExteriorFace> faces;  ///< of this rank's living elements, ascending by key
  std::vector<MassPoint> points;          ///< ascending by node, then by block: of this rank's removed elements
};

/// The outside as it is now. Collective.
ExposedSurface exposed_surface(const comm::Communicator& ranks, const mesh::LocalMesh& mesh, const InnerFaces& inner,
                               Alive alive);

}  // namespace brunt::surface
