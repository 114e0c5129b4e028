// SPDX-License-Identifier: Apache-2.0
// The parts of an Abaqus input file that define a mesh: parts, their positions, sets and surfaces.
#pragma once
#include <array>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <unordered_map>
#include <vector>

#include "abaqus_deck.hpp"
#include "core/types.hpp"

namespace brunt::io {

struct AbaqusElement {
  std::int64_t number = 0;
  int corners = 0, line = 0;
  bool shell = false;
  std::array<LocalIndex, 8> nodes{};  ///< positions in the part
};

/// An element of an unsupported type, of which only the block is listed.
struct AbaqusOther {
  std::int64_t number = 0;
  std::string type;   ///< in capitals
  std::string dealt;  ///< key of the element set of its card
  std::string fault;  ///< why it is not supported; empty: lines and surfaces beside solids, which are ignored
  int line = 0;       ///< of its card
};

/// Numbers of nodes or elements: a single one, or those of GENERATE that exist.
struct AbaqusMembers {
  std::int64_t first = 0, last = 0, step = 1;
  int instance = -1;  ///< position among the instances; -1: of the own part, or of no instance
  int line = 0;
  bool generated = false;
};

struct AbaqusChoice {
  std::vector<AbaqusMembers> members;
  std::vector<AbaqusMembers> of_elements;  ///< of nodes: the elements whose nodes belong to it
};

struct AbaqusSet : AbaqusChoice {
  std::string name;  ///< as written first
  int taken_at = 0;  ///< line in which another set or surface took its members; 0: none
};
using AbaqusSets = std::map<std::string, AbaqusSet>;  ///< by DeckLabel::key

struct AbaqusSurface {
  DeckLabel name;
  bool of_nodes = false;
  int line = 0;
  struct Piece : AbaqusChoice {
    int face = 0;  ///< from 1, as in S1; 0: all faces that no other element shares; of shells see below
    int line = 0;
  };
  std::vector<Piece> pieces;
  static constexpr int top = -1, bottom = -2, edge = -3;  ///< SPOS, SNEG; E1 to E4 and the ends of beams
};

/// Sets and surfaces of a part or of the assembly.
struct AbaqusScope {
  AbaqusSets node_sets, element_sets;
  std::vector<AbaqusSurface> surfaces;
};

struct AbaqusPart : AbaqusScope {
  DeckLabel name;        ///< empty: content outside of parts, or of an instance
  bool is_used = false;  ///< by an instance
  std::vector<std::int64_t> node_number;
  std::vector<Vec3> coordinates;
  std::unordered_map<std::int64_t, LocalIndex> node_at, element_at;  ///< by number
  std::vector<AbaqusElement> elements;
  std::vector<AbaqusOther> others;
  std::unordered_map<std::int64_t, std::size_t> other_at;
  std::vector<std::pair<std::string, int>> other_sections;  ///< as sections, of all kinds but solids and shells
  std::vector<std::pair<std::string, int>> sections;  ///< keys of the element sets of solids and shells; their lines
  std::vector<std::string> dealt;                     ///< of each element the key of its card's set
};

struct AbaqusInstance {
  DeckLabel name;  ///< empty: content outside of parts
  std::size_t part = 0;
  Vec3 shift = Vec3::Zero();
  std::optional<std::array<Vec3, 2>> axis;  ///< two points, after the shift
  double degrees = 0;
};

struct AbaqusModel {
  std::vector<AbaqusPart> parts;  ///< the first one is the content outside of parts
  std::vector<AbaqusInstance> instances;
  AbaqusScope assembly;
  std::set<std::int64_t> assembly_nodes, assembly_elements;  ///< of no instance: points and masses, which are not read
  std::vector<std::string> notes;                            ///< what is not read
};

/// Throws InputError with the line for content that violates the Abaqus keywords reference, and for keywords and
/// parameters that would change the mesh and are not supported. Elements other than solid ones of first order are
/// `others`.
AbaqusModel read_abaqus_model(const AbaqusDeck& deck);

/// The label of a parameter that must be given.
DeckLabel needed_label(const AbaqusDeck& deck, const DeckCard& card, const std::string& parameter);

/// A number of a node or element, from 1 to 999999999.
std::int64_t number_in(const AbaqusDeck& deck, const DeckLine& line, std::string_view field, std::string_view what);

}  // namespace brunt::io
