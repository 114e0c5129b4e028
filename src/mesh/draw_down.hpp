// SPDX-License-Identifier: Apache-2.0
// What a solid sphere and its surface share: the check of their parameters, and the map that refines the lowest point.
#pragma once
#include <string>
#include <vector>

#include "mesh/primitives.hpp"

namespace brunt::mesh {

/// Throws InputError with all faults.
void check_sphere(const std::string& part, double radius, int elements, const SphereForm& form);

/// Moves nodes of the uniform ball, or half ball, of this radius towards its lowest point, as `form.finer` says.
void draw_down(std::vector<Vec3>& coordinates, double radius, const SphereForm& form);

}  // namespace brunt::mesh
