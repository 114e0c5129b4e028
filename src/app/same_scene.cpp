// SPDX-License-Identifier: Apache-2.0
#include "same_scene.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "brunt/core/error.hpp"
#include "brunt/scene/fingerprint.hpp"

namespace brunt::app {

void refuse_other_scene(const std::string& path, const SceneIdentity& of_file, const SceneIdentity& here) {
  if (of_file.fingerprint == here.fingerprint || of_file.values.empty()) return;
  const std::vector<std::string> different = scene::differences(of_file.values, here.values);
  if (different.empty()) return;
  constexpr std::size_t most = 3;
  std::string listed;
  for (std::size_t k = 0; k < std::min(most, different.size()); ++k) listed += (k > 0 ? "; " : "") + different[k];
  if (different.size() > most) listed += fmt::format("; {} more keys differ", different.size() - most);
  throw InputError(
      fmt::format("{}: invalid for this scene: written by another one: {}; expected changes of title, output, history, "
                  "checkpoint, scaling, run.end, run.steps, run.min_step_ratio and run.wall_limit only",
                  path, listed));
}

}  // namespace brunt::app
