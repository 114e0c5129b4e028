// SPDX-License-Identifier: Apache-2.0
// Checks that a file belongs to this scene.
#pragma once
#include <string>

#include "mesh/canonical.hpp"

namespace brunt::app {

/// Identity of a scene with its mesh: scene::fingerprint and mesh_digits, joined by a hyphen (older files have the
/// first alone), and the values of the scene.
struct SceneIdentity {
  std::string fingerprint, values;
};

[[nodiscard]] std::string with_mesh(const std::string& scene, const mesh::CanonicalMesh& whole);

/// The fingerprint that a file of this scene has: that of an older file is without the mesh.
[[nodiscard]] std::string expected_of(const std::string& of_file, const std::string& here);

/// Throws InputError with the keys that differ, or if the scenes are equal and their meshes differ. Keys of output and
/// end do not count. If the file does not contain the values, or another version of the program wrote them, no message
/// is given.
void refuse_other_scene(const std::string& path, const SceneIdentity& of_file, const SceneIdentity& here);

}  // namespace brunt::app
