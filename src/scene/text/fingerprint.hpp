// SPDX-License-Identifier: Apache-2.0
// The part of a scene that determines the motion of the bodies, and that must not change at a restart.
#pragma once
#include <span>
#include <string>
#include <vector>

namespace brunt::scene {

/// A hash of the scene after overrides, without what a restart may change (`free_to_change` in fingerprint.cpp). Empty
/// for an invalid scene.
std::string fingerprint(const std::string& text, const std::string& file_name, std::span<const std::string> overrides);

/// The same part of the scene as text, one line `key.path=value` for each value. Empty for an invalid scene.
std::string decisive_values(const std::string& text, const std::string& file_name,
                            std::span<const std::string> overrides);

/// The values in which two such texts differ, in order of keys.
std::vector<std::string> differences(const std::string& there, const std::string& here);

}  // namespace brunt::scene
