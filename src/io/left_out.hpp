// SPDX-License-Identifier: Apache-2.0
// Blocks of a mesh file that are left out because the user asked for it, and those that cannot be read.
#pragma once
#include <map>
#include <string>
#include <vector>

#include "brunt/mesh/mesh.hpp"

namespace brunt::io {

/// A block of the file that is no block of the mesh.
struct ForeignBlock {
  std::string name{};
  GlobalIndex id = 0;  ///< 0: none
  std::string type{};  ///< of its elements, as the file says it
  GlobalIndex count = 0;
  int dimension = 3;       ///< of a name that several have, the highest dimension is meant
  std::string fault{};     ///< "PATH[:LINE]: what is wrong; accepted: ...", unless it is ignored; empty: it may stay
  bool passed = false;     ///< is left out in any case
  std::string own_sets{};  ///< name of the node set and side set that go with it
};

/// What a reader found, before anything is left out.
struct FileContent {
  mesh::Mesh mesh{};
  std::vector<ForeignBlock> foreign{};
  std::map<std::string, GlobalIndex> foreign_sides{};  ///< by side set: sides of elements of foreign blocks
};

/// The mesh without the blocks that `ignore` names (by name or number) and without the nodes that only they use; sets
/// keep what is left, and notes say what they lost. Then it passes mesh::check. Throws InputError: a name that the file
/// does not have, foreign blocks that are not ignored, no block left, faults of the mesh.
mesh::Mesh leave_out(const std::string& path, FileContent&& content, const std::vector<std::string>& ignore);

/// The name that a user would write: the block's name, or its number without one.
std::string name_or_number(const std::string& name, GlobalIndex id);

}  // namespace brunt::io
