// SPDX-License-Identifier: Apache-2.0
// History variables of all solid elements and their positions: one layout for all kinds and laws.
#pragma once
#include <vector>

#include "element/batch.hpp"

namespace brunt::element {

/// Laws with rates or an equation of state, which need circumstances (material/circumstances.hpp).
template <class Response>
concept Thermodynamic = requires {
  requires Response::thermodynamic;
};

/// Beginning of the variables of one integration point.
template <class Number>
struct PointMemory {
  Number *stress, *tensors, *scalars, *log_strain;
  int stride = 1;  ///< between scalars of a point
};

/// Number of doubles of one element with `points` integration points, in this order: mass (set once by the model), all
/// stresses (xx,yy,zz,xy,yz,zx for each point), all tensors of the law, all its scalars (one name after the other, its
/// points together), then energy and last force of bulk viscosity, and ln V of all points if the law follows the
/// logarithmic rate.
template <class Response, int points>
struct SolidMemory {
  static constexpr int at_mass = 0;
  static constexpr int at_stress = 1;
  static constexpr int at_tensors = at_stress + 6 * points;
  static constexpr int at_scalars = at_tensors + 6 * Response::tensors * points;
  static constexpr int at_bulk_energy = at_scalars + Response::scalars * points;
  static constexpr int at_log_strain = at_bulk_energy + 2;
  static constexpr int size = at_log_strain + (Response::logarithmic ? 6 * points : 0);

  template <class Number>
  static PointMemory<Number> point(Number* history, int p = 0) {
    return {history + at_stress + 6 * p, history + at_tensors + 6 * Response::tensors * p, history + at_scalars + p,
            history + at_log_strain + 6 * p, points};
  }

  static std::vector<HistoryField> fields([[maybe_unused]] const Response& law) {
    std::vector<HistoryField> fields{{"mass", 1}, {"stress", 6 * points}};
    if (Response::tensors > 0) fields.push_back({"back_stress", 6 * Response::tensors * points});
    if constexpr (Thermodynamic<Response>) {
      for (const auto& scalar : law.fields()) fields.push_back({scalar.name, points, scalar.start});
    } else if (Response::scalars > 0)
      fields.push_back({"plastic_strain", Response::scalars * points});
    fields.push_back({"bulk_energy", 1});
    fields.push_back({"bulk_force", 1});
    if (Response::logarithmic) fields.push_back({"log_strain", 6 * points});
    return fields;
  }
};

}  // namespace brunt::element
