// SPDX-License-Identifier: Apache-2.0
// The section `enforcement`: what holds for all contact of a scene. Entries of `contact` may say it too: an entry keeps
// what the entry before says where it says nothing, and the last one's holds.
#pragma once
#include <optional>
#include <string_view>

#include "brunt/scene/input.hpp"
#include "brunt/scene/reader.hpp"

namespace brunt::scene {

void warn(const Key& key, std::string_view what, Input& input);

/// Reads into input.enforcement: the section first, then entry by entry. A key in both has to say the same.
class EnforcementReader {
 public:
  EnforcementReader(Section& scene, Input& input);
  void read_entry(const Key& whole, Section& entry);
  /// Of the section, when all entries are read: settings that would do nothing, or not what they seem to.
  void judge();

 private:
  [[nodiscard]] bool section_has(std::string_view name) { return section_ && section_->has(name); }
  void judge_figures(Section& given);

  Input& input_;
  std::optional<Section> section_;
  std::optional<Key> softness_;  ///< where it is given last
};

}  // namespace brunt::scene
