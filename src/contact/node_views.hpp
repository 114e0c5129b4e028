// SPDX-License-Identifier: Apache-2.0
// Views of nodal vectors of the model for reading and writing by contact, and the input of a step.
#pragma once
#include <cstddef>
#include <span>

#include "contact/data/carriers.hpp"
#include "contact/detection/detection.hpp"
#include "core/types.hpp"

namespace brunt::contact {

/// Vectors of the model's local nodes in any memory layout: node i starts at data[i * stride].
struct VectorView {
  const double* data = nullptr;
  std::ptrdiff_t stride = 3;
  [[nodiscard]] Vec3 operator[](LocalIndex node) const { return Vec3(data + node * stride); }
  void fetch(LocalIndex node) const { __builtin_prefetch(data + node * stride); }  ///< to the cache, for later
};
struct MutableVectorView {
  double* data = nullptr;
  std::ptrdiff_t stride = 3;
  [[nodiscard]] Vec3 operator[](LocalIndex node) const { return Vec3(data + node * stride); }
  void set(LocalIndex node, const Vec3& value) const { Eigen::Map<Vec3>(data + node * stride) = value; }
};

/// One step, before contact.
struct StepInput {
  VectorView position;         ///< x_n
  VectorView old_velocity;     ///< v at n - 1/2
  MutableVectorView velocity;  ///< v*; `correct` replaces it by v at n + 1/2
  std::span<const Wall> walls;
  double dt = 0;
  std::span<const Carrier> bodies{};         ///< rigid bodies at t_n
  std::span<const CoupledBodies> coupled{};  ///< those with joints
  /// Of the model's local nodes: sum of the plastic strains of the elements around them, infinite beside a material
  /// that dissipates without one. Any change counts as flow. Empty: nothing flows, or Impact::plastic.
  std::span<const double> flow{};
  double mobility_scale = 1;  ///< factor of the inverse masses in W: 1 / (1 + alpha dt / 2) with mass damping

  [[nodiscard]] VectorView predicted() const { return {velocity.data, velocity.stride}; }
};

}  // namespace brunt::contact
