// SPDX-License-Identifier: Apache-2.0
// One material point driven by strain increments or by deformation gradients; all eight lanes do the same.
#pragma once
// g++ 12 takes the undefined lanes of its own AVX-512 intrinsics for a fault (GCC bug 105593); Eigen brings them in
#pragma GCC diagnostic ignored "-Wmaybe-uninitialized"
#include <Eigen/Dense>
#include <random>

#include "core/simd.hpp"
#include "element/logarithmic_rate.hpp"

namespace brunt::test {

using Matrix = Eigen::Matrix3d;

[[nodiscard]] Matrix symmetric_matrix(const Pack* s, int lane = 0);
void set_symmetric(const Matrix& m, Pack (&s)[6]);
void set_full(const Matrix& m, Pack (&F)[9]);
/// Entries uniform in [-size, size].
[[nodiscard]] Matrix random_matrix(std::mt19937& engine, double size);
[[nodiscard]] double equivalent(const Matrix& s);
/// Gradient of the displacement increment from `before` to `after` in the midpoint configuration.
[[nodiscard]] Matrix midpoint_gradient(const Matrix& before, const Matrix& after);

/// A rate law and its state.
template <class Response>
struct RatePoint {
  Response law;
  Pack stress[6]{}, tensors[6]{}, scalars[1]{}, log_strain[6]{};

  void strain(const Matrix& increment) {
    Pack de[6];
    set_symmetric(increment, de);
    law.update(de, stress, tensors, scalars);
  }
  /// The step an element makes: gradient of the displacement increment in the midpoint configuration.
  void deform(const Matrix& before, const Matrix& after) {
    Pack L[9];
    set_full(midpoint_gradient(before, after), L);
    const element::PointMemory<Pack> memory{stress, tensors, scalars, log_strain};
    const element::PointMemory<const Pack> committed{stress, tensors, scalars, log_strain};
    Pack s[6];
    element::update_stress(law, element::strain_step_of<Response>(L, 1.0, committed, memory), committed, memory, s);
  }
  [[nodiscard]] Matrix cauchy(int lane = 0) const { return symmetric_matrix(stress, lane); }
  [[nodiscard]] double plastic_strain(int lane = 0) const { return scalars[0][lane]; }
};

/// Cauchy stress of a hyperelastic law.
template <class Response>
Matrix cauchy_stress(const Response& law, const Matrix& F) {
  Pack gradient[9], stress[6];
  set_full(F, gradient);
  law.stress(gradient, stress);
  return symmetric_matrix(stress);
}

using Matrix9 = Eigen::Matrix<double, 9, 9>;

/// The quadratic form lambda tr(L)^2 + 2 mu L : L on the nine entries of L.
[[nodiscard]] Matrix9 bound_form(double lambda, double mu);
[[nodiscard]] double smallest_eigenvalue(const Matrix9& form);

/// The form L : d(nominal stress)/dt for velocity gradients L; `nominal(H)` is the nominal stress after the
/// displacement gradient H, by central differences.
template <class Nominal>
Matrix9 stiffness_form(const Nominal& nominal, double step) {
  Matrix9 form;
  for (int c = 0; c < 9; ++c) {
    Matrix H = Matrix::Zero();
    H.data()[c] = step;
    const Matrix rate = (nominal(H) - nominal(-H)) / (2 * step);
    form.col(c) = Eigen::Map<const Eigen::Matrix<double, 9, 1>>(rate.data());
  }
  return 0.5 * (form + form.transpose());
}

}  // namespace brunt::test
