// SPDX-License-Identifier: Apache-2.0
// Positions of the moving body of `brunt depth`, pose by pose.
#pragma once
#include <string>
#include <vector>

#include "core/triangle_surface.hpp"

namespace brunt::app {

/// `--at x,y,z` and `--turn x,y,z,degrees`: first rotated about the origin of the file, then translated. Empty texts:
/// no motion. Throws InputError.
[[nodiscard]] Placement pose_of(const std::string& at, const std::string& turn);

/// A CSV file: columns x, y, z and, for rotations, axis_x, axis_y, axis_z, degrees or qw, qx, qy, qz, in any order;
/// lines that begin with # are comments. Throws InputError with file and line.
[[nodiscard]] std::vector<Placement> read_poses(const std::string& path);

/// Axes named in `--along x,y`. Throws InputError.
[[nodiscard]] std::vector<Vec3> axes_named(const std::string& text);

}  // namespace brunt::app
