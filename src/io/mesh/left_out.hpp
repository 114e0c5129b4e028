// SPDX-License-Identifier: Apache-2.0
// Blocks of a mesh file that are excluded: by `ignore`, without elements, or of unsupported elements.
#pragma once
#include <map>
#include <string>
#include <vector>

#include "mesh/mesh.hpp"

namespace brunt::io {

/// A block of the file that does not become a block of the mesh.
struct ForeignBlock {
  std::string name{};
  GlobalIndex id = 0;  ///< 0: none
  std::string type{};  ///< of its elements, as the file says it
  GlobalIndex count = 0;
  int dimension = 3;       ///< if several blocks have this name, the one of the highest dimension is meant
  std::string fault{};     ///< "PATH[:LINE]: what is wrong; expected ...", unless it is ignored; empty: no fault
  bool passed = false;     ///< excluded in any case: without elements, or of elements beside solids
  std::string own_sets{};  ///< name of the node set and side set that go with it
};

/// The content of a file, before anything is excluded.
struct FileContent {
  mesh::Mesh mesh{};
  std::vector<ForeignBlock> foreign{};
  std::map<std::string, GlobalIndex> foreign_sides{};  ///< by side set: sides of elements of foreign blocks
};

/// The mesh without the blocks that `ignore` names (by name or number) and without the nodes that only they use. Sets
/// keep the remaining members, and notes list the lost ones. The result is checked by mesh::check. Throws InputError
/// for a name that the file does not have, unsupported blocks that are not ignored, no remaining block, and faults of
/// the mesh.
mesh::Mesh leave_out(const std::string& path, FileContent&& content, const std::vector<std::string>& ignore);

/// The name that a user would write: the block's name, or its number without one.
std::string name_or_number(const std::string& name, GlobalIndex id);

}  // namespace brunt::io
