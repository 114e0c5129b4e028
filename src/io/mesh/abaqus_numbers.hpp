// SPDX-License-Identifier: Apache-2.0
// Which numbers of nodes and elements exist, and which of them a set names.
#pragma once
#include <set>
#include <string>
#include <vector>

#include "abaqus_parts.hpp"

namespace brunt::io {

/// The nodes and elements of a part, or those of the assembly.
class AbaqusNumbers {
 public:
  explicit AbaqusNumbers(const AbaqusPart& part) : part_(&part) {}
  explicit AbaqusNumbers(const AbaqusModel& model) : assembly_(&model) {}

  enum class Kind { node, element };
  /// In ascending order; found when they are asked for first.
  const std::vector<std::int64_t>& all(Kind kind);

 private:
  const AbaqusPart* part_ = nullptr;
  const AbaqusModel* assembly_ = nullptr;
  std::vector<std::int64_t> nodes_, elements_;
  bool has_nodes_ = false, has_elements_ = false;
};

/// The existing numbers among `members` of set or surface `name`. Throws InputError for a number that does not exist
/// and for a range without any. Adds a note where a range names numbers that do not exist.
std::vector<std::int64_t> existing(const AbaqusDeck& deck, const AbaqusMembers& members, AbaqusNumbers& numbers,
                                   AbaqusNumbers::Kind kind, const std::string& name, std::set<std::string>& notes);

}  // namespace brunt::io
