// SPDX-License-Identifier: Apache-2.0
// What of a scene decides how the bodies move: the part that may not change over a restart.
#pragma once
#include <span>
#include <string>

namespace brunt::scene {

/// The scene after overrides as one line of text, without what a restart may change (run.end, run.steps,
/// run.wall_limit, output, history, checkpoint, title), shortened to a hash. Empty for a faulty scene.
std::string fingerprint(const std::string& text, const std::string& file_name, std::span<const std::string> overrides);

}  // namespace brunt::scene
