// SPDX-License-Identifier: Apache-2.0
// What of a scene decides how the bodies move: the part that may not change over a restart.
#pragma once
#include <span>
#include <string>
#include <vector>

namespace brunt::scene {

/// The scene after overrides as one line of text, without what a restart may change (run.end, run.steps,
/// run.wall_limit, output, history, checkpoint, title), shortened to a hash. Empty for a faulty scene.
std::string fingerprint(const std::string& text, const std::string& file_name, std::span<const std::string> overrides);

/// The same part of the scene as text, a line `key.path=value` for each value. Empty for a faulty scene.
std::string decisive_values(const std::string& text, const std::string& file_name,
                            std::span<const std::string> overrides);

/// Values that two such texts do not share, as "run.cfl is 0.9 there and 0.5 here", in order of keys.
std::vector<std::string> differences(const std::string& there, const std::string& here);

}  // namespace brunt::scene
