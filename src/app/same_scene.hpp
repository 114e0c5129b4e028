// SPDX-License-Identifier: Apache-2.0
// Is a file of this very scene?
#pragma once
#include <string>

namespace brunt::app {

/// What a scene is known by: scene::fingerprint, and the values that it is made of.
struct SceneIdentity {
  std::string fingerprint, values;
};

/// Throws InputError that says which keys differ. Nothing that concerns output and end counts; where the file does not
/// know its values, or another version of the program wrote them, nothing is said.
void refuse_other_scene(const std::string& path, const SceneIdentity& of_file, const SceneIdentity& here);

}  // namespace brunt::app
