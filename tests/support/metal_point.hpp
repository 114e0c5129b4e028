// SPDX-License-Identifier: Apache-2.0
// One material point of a law that is told of circumstances, driven by velocity gradients; all lanes do the same.
#pragma once
#include "element/objective.hpp"
#include "material/circumstances.hpp"
#include "support/material_point.hpp"

namespace brunt::test {

template <class Response>
struct MetalPoint {
  Response law;
  Pack stress[6]{}, scalars[Response::scalars]{};
  double volume = 1;

  explicit MetalPoint(Response response) : law(std::move(response)) {
    const auto fields = law.fields();
    for (std::size_t k = 0; k < fields.size(); ++k) scalars[k] = broadcast(fields[k].start);
  }

  /// From one deformation gradient to the next in a time dt, as an element does it.
  void deform(const Matrix& before, const Matrix& after, double dt, double viscous_work = 0) {
    Pack L[9], s[6], lambda, mu;
    set_full(midpoint_gradient(before, after) / dt, L);
    volume = after.determinant();
    const element::PointMemory<Pack> memory{stress, nullptr, scalars, nullptr};
    const element::PointMemory<const Pack> committed{stress, nullptr, scalars, nullptr};
    element::update_stress(law, element::strain_step<Pack>(L, dt), {dt, broadcast(volume), broadcast(viscous_work)},
                           committed, memory, s, lambda, mu);
  }
  [[nodiscard]] Matrix cauchy() const { return symmetric_matrix(stress); }
  [[nodiscard]] double pressure() const { return -cauchy().trace() / 3; }
  [[nodiscard]] double scalar(int at) const { return scalars[at][0]; }
};

}  // namespace brunt::test
