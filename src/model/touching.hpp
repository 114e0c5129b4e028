// SPDX-License-Identifier: Apache-2.0
// What bodies may touch: each other, walls, and their mirror images. Constant during a run.
#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "contact/data/mortar_pair.hpp"
#include "contact/data/specification.hpp"
#include "core/types.hpp"
#include "model/curve.hpp"

namespace brunt::model {

/// What a wall of a scene and one of a model have in common.
struct PlaneWall {
  std::string name;
  Vec3 point = Vec3::Zero();    ///< of a model: less the mesh's origin
  Vec3 normal = Vec3::UnitZ();  ///< outward, towards the bodies
  bool bilateral = false;       ///< nodes that start in the plane stay in it
  contact::FrictionLaw friction;
};
struct RigidWall : PlaneWall {
  Curve motion;  ///< velocity along the normal
  bool moves = false;
  std::vector<std::int32_t> blocks{};  ///< that it acts on, ascending; empty: all
};

/// Nodes in a plane of symmetry: the other half of each body lies behind it.
struct SymmetryNodes {
  Vec3 normal = Vec3::UnitZ();    ///< unit
  std::vector<LocalIndex> nodes;  ///< ascending
};

struct Touching {
  contact::Specification contact;
  std::vector<RigidWall> walls;
  std::vector<char> in_symmetry_plane;      ///< a flag for each of Model::mesh.faces: not a contact face
  std::vector<contact::MortarPair> mortar;  ///< of implicit scenes
  std::vector<SymmetryNodes> symmetries;    ///< likewise
};

}  // namespace brunt::model
