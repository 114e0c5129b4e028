// SPDX-License-Identifier: Apache-2.0
// Quantities of rigid parts for probes: every rank knows them, so nothing here is collective.
#pragma once
#include <Eigen/Geometry>
#include <optional>
#include <string>
#include <string_view>

#include "app/state/prepared.hpp"
#include "part_sums.hpp"

namespace brunt::app {

/// Axis times angle, the shorter way round.
Vec3 rotation_vector(Eigen::Quaterniond q);

/// Position of the part's body in Model::bodies; none for a deformable part.
std::optional<std::size_t> body_of_part(const model::Model& model, const std::string& part);

/// At t_n: position of the centre of mass in the scene's coordinates, its displacement, and `rotation` as a rotation
/// vector (axis times angle, of length at most pi); at the previous half step: velocity of the centre and
/// angular_velocity. Before the step advances.
Vec3 body_motion(const Prepared& run, std::size_t body, std::string_view field);

/// Since t = 0: `force` and `moment` (about the centre of mass) of everything that acts on the body except its
/// supports; `reaction` and `reaction_moment` of the supports.
Vec3 body_impulse(const Prepared& run, std::size_t body, std::string_view field);

/// Of the part without the masses of deformable elements on its nodes, as the sums of app/part_sums.
Vec3 body_part_center(const Prepared& run, std::size_t body);
Vec3 body_part_momentum(const Prepared& run, std::size_t body);
Vec3 body_part_angular_momentum(const Prepared& run, std::size_t body, const Vec3& about);
PartEnergy body_part_energy(const Prepared& run, std::size_t body);

}  // namespace brunt::app
