// SPDX-License-Identifier: Apache-2.0
// Checks that a file belongs to this scene.
#pragma once
#include <string>

namespace brunt::app {

/// Identity of a scene: scene::fingerprint, and its values.
struct SceneIdentity {
  std::string fingerprint, values;
};

/// Throws InputError with the keys that differ. Keys of output and end do not count. If the file does not contain the
/// values, or another version of the program wrote them, no message is given.
void refuse_other_scene(const std::string& path, const SceneIdentity& of_file, const SceneIdentity& here);

}  // namespace brunt::app
