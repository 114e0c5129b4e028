// SPDX-License-Identifier: Apache-2.0
#include "same_scene.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "core/error.hpp"
#include "mesh_identity.hpp"
#include "scene/text/fingerprint.hpp"

namespace brunt::app {

namespace {

constexpr char joint = '-';

std::string scene_of(const std::string& fingerprint) {
  return fingerprint.substr(0, fingerprint.find(joint));
}

bool has_mesh(const std::string& fingerprint) {
  return fingerprint.find(joint) != std::string::npos;
}

}  // namespace

std::string with_mesh(const std::string& scene, const mesh::CanonicalMesh& whole) {
  return scene + joint + mesh_digits(whole);
}

std::string expected_of(const std::string& of_file, const std::string& here) {
  return has_mesh(of_file) ? here : scene_of(here);
}

void refuse_other_scene(const std::string& path, const SceneIdentity& of_file, const SceneIdentity& here) {
  if (of_file.fingerprint == expected_of(of_file.fingerprint, here.fingerprint)) return;
  if (scene_of(of_file.fingerprint) == scene_of(here.fingerprint))
    throw InputError(path +
                     ": invalid for this mesh: nodes, elements or sets differ from those of the earlier run, although "
                     "the scene is the same; expected unchanged mesh files, or a new run");
  if (of_file.values.empty()) return;
  const std::vector<std::string> different = scene::differences(of_file.values, here.values);
  if (different.empty()) return;
  constexpr std::size_t most = 3;
  std::string listed;
  for (std::size_t k = 0; k < std::min(most, different.size()); ++k) listed += (k > 0 ? "; " : "") + different[k];
  if (different.size() > most) listed += fmt::format("; {} more keys differ", different.size() - most);
  throw InputError(
      fmt::format("{}: invalid for this scene: written by another one: {}; expected changes of title, output, history, "
                  "checkpoint, guards, scaling, search, run.end, run.steps, run.min_step_ratio and run.wall_limit only",
                  path, listed));
}

}  // namespace brunt::app
