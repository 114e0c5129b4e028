// SPDX-License-Identifier: Apache-2.0
// The section `enforcement`: settings of all contact of a scene. Entries of `contact` may also contain them: an entry
// inherits the values of the previous one, and those of the last entry apply.
#pragma once
#include <optional>
#include <string_view>

#include "scene/input.hpp"
#include "scene/text/reader.hpp"

namespace brunt::scene {

void warn(const Key& key, std::string_view what, Input& input);

/// Reads into input.enforcement: first the section, then each entry. A key given in both must have the same value.
class EnforcementReader {
 public:
  EnforcementReader(Section& scene, Input& input);
  void read_entry(const Key& whole, Section& entry);
  /// After all entries are read: warns of settings of the section without effect.
  void judge();

 private:
  [[nodiscard]] bool section_has(std::string_view name) { return section_ && section_->has(name); }
  void judge_figures(Section& given);

  Input& input_;
  std::optional<Section> section_;
  std::optional<Key> softness_;  ///< where it is given last
};

}  // namespace brunt::scene
