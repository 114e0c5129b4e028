// SPDX-License-Identifier: Apache-2.0
// The parts of an Abaqus input file that define a mesh: parts, their positions, sets and surfaces.
#pragma once
#include <array>
#include <map>
#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

#include "abaqus_deck.hpp"
#include "brunt/core/types.hpp"

namespace brunt::io {

struct AbaqusElement {
  std::int64_t number = 0;
  int corners = 0, line = 0;
  std::array<LocalIndex, 8> nodes{};  ///< positions in the part
};

/// An element of an unsupported type, of which only the block is listed.
struct AbaqusOther {
  std::int64_t number = 0;
  std::string type;   ///< in capitals
  std::string dealt;  ///< element set of its card, in capitals
  std::string fault;  ///< why it is not supported; empty: lines and surfaces beside solids, which are ignored
  int line = 0;       ///< of its card
};

/// A node or element of an instance of the assembly; within a part, the part's own.
struct AbaqusMember {
  std::string instance;     ///< in capitals; empty within a part
  std::int64_t number = 0;  ///< in the part
};

struct AbaqusSet {
  std::string name;  ///< as written first
  std::vector<AbaqusMember> members;
};
using AbaqusSets = std::map<std::string, AbaqusSet>;  ///< by the name in capitals

struct AbaqusSurface {
  std::string name;
  bool of_nodes = false;
  struct Piece {
    std::vector<AbaqusMember> members;
    int face = 0;  ///< from 1, as in S1; 0: all faces that no other element shares; -1: a side of a shell
    int line = 0;
  };
  std::vector<Piece> pieces;
};

/// Sets and surfaces of a part or of the assembly.
struct AbaqusScope {
  AbaqusSets node_sets, element_sets;
  std::vector<AbaqusSurface> surfaces;
};

struct AbaqusPart : AbaqusScope {
  std::string name;  ///< empty: content outside of parts
  std::vector<std::int64_t> node_number;
  std::vector<Vec3> coordinates;
  std::unordered_map<std::int64_t, LocalIndex> node_at, element_at;  ///< by number
  std::vector<AbaqusElement> elements;
  std::vector<AbaqusOther> others;
  std::unordered_map<std::int64_t, std::size_t> other_at;
  std::vector<std::pair<std::string, int>> other_sections;  ///< as sections, of all kinds but solid ones
  std::vector<std::pair<std::string, int>> sections;  ///< element sets of solid sections, in capitals; their lines
  std::vector<std::string> dealt;                     ///< element sets of *ELEMENT cards in turn, in capitals
};

struct AbaqusInstance {
  std::string name;  ///< empty: content outside of parts
  std::size_t part = 0;
  Vec3 shift = Vec3::Zero();
  std::optional<std::array<Vec3, 2>> axis;  ///< two points, after the shift
  double degrees = 0;
};

struct AbaqusModel {
  std::vector<AbaqusPart> parts;  ///< the first one is the content outside of parts
  std::vector<AbaqusInstance> instances;
  AbaqusScope assembly;
};

/// Throws InputError with the line for content that violates the Abaqus keywords reference, and for generated nodes and
/// elements, which would change the mesh and are not supported. Elements other than solid ones of first order are
/// `others`.
AbaqusModel read_abaqus_model(const AbaqusDeck& deck);

}  // namespace brunt::io
