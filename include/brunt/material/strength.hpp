// SPDX-License-Identifier: Apache-2.0
// Yield stress over plastic strain and temperature, and the plastic strain that closes a return to it.
#pragma once
#include <limits>
#include <optional>
#include <variant>

#include "brunt/material/exponential.hpp"
#include "brunt/material/law.hpp"
#include "brunt/material/yield_curve.hpp"

namespace brunt::material {

/// The state that a return begins from. `scale` multiplies the yield stress: rate and damage.
struct FlowStart {
  Pack equivalent;      ///< of the trial stress [stress]
  Pack plastic_strain;  ///< p
  Pack temperature;     ///< T
  Pack heating;         ///< dT/dp with the yield stress at the start
  Pack scale;
  Pack pressure;  ///< [stress]
};

/// Plastic increment dp >= 0 with q = 3 G dp + scale Y(p + dp, T + heating dp), and the yield stress there.
struct FlowEnd {
  Pack increment, yield;
};

/// G. R. Johnson, W. H. Cook, Proc. 7th Int. Symp. Ballistics (1983) 541.
class JohnsonCookFlow {
 public:
  JohnsonCookFlow(const JohnsonCook& constants, double three_shear)
      : c_(constants),
        three_shear_(three_shear),
        over_melt_(constants.melt > constants.room ? 1 / (constants.melt - constants.room) : 0) {}

  [[nodiscard]] Pack homologous(Pack temperature) const {
    return pack_min(pack_max((temperature - c_.room) * over_melt_, Pack{}), broadcast(1.0));
  }

  [[nodiscard]] Pack yield(const FlowStart& at) const {
    return at.scale * (c_.a + c_.b * pack_power(at.plastic_strain, c_.n)) * left_by_heat(homologous(at.temperature));
  }

  /// Newton's method within a bracket: the left side less q is negative at dp = 0, where the trial stress is beyond
  /// yield, and positive at q / 3 G. Each lane stops by itself, so that no lane depends on others.
  [[nodiscard]] FlowEnd close(const FlowStart& start) const {
    const Pack before = yield(start);
    PackMask open = start.equivalent > before;
    FlowEnd end{Pack{}, before};
    if (!any(open)) return end;
    Pack low{}, high = start.equivalent * (1 / three_shear_);
    Pack guess = select(open, (start.equivalent - before) * (1 / three_shear_), Pack{});
    for (int iteration = 0; iteration < most_iterations && any(open); ++iteration) {
      const Yield at = at_end(start, guess);
      const Pack excess = start.equivalent - three_shear_ * guess - at.value;
      low = select(excess > 0.0, guess, low);
      high = select(excess > 0.0, high, guess);
      Pack next = guess + excess / (three_shear_ + at.slope);
      next = select((next > low) & (next < high), next, 0.5 * (low + high));
      const PackMask moves = pack_abs(excess) > tolerance * start.equivalent;
      end.increment = select(open, guess, end.increment);
      end.yield = select(open, at.value, end.yield);
      open &= moves;
      guess = select(open, next, guess);
    }
    return end;
  }

 private:
  struct Yield {
    Pack value, slope;  ///< by dp
  };
  static constexpr int most_iterations = 60;  ///< halving alone ends below rounding by then
  static constexpr double tolerance = 1e-13;  ///< of the trial stress: rounding of the left side

  [[nodiscard]] Pack left_by_heat(Pack homologous) const {
    return over_melt_ > 0 ? 1.0 - pack_power(homologous, c_.m) : broadcast(1.0);
  }

  [[nodiscard]] Yield at_end(const FlowStart& start, Pack increment) const {
    const Pack p = start.plastic_strain + increment;
    const Pack power = pack_power(p, c_.n);
    const Pack hard = c_.a + c_.b * power;
    const Pack floor = broadcast(std::numeric_limits<double>::min());
    const Pack hardening = c_.b * c_.n * power / pack_max(p, floor);
    if (over_melt_ == 0) return {start.scale * hard, start.scale * hardening};
    const Pack hot = homologous(start.temperature + start.heating * increment);
    const Pack lost = pack_power(hot, c_.m);
    const Pack softening = select((hot > 0.0) & (hot < 1.0), c_.m * lost / pack_max(hot, floor), Pack{});
    return {start.scale * hard * (1.0 - lost),
            start.scale * (hardening * (1.0 - lost) - hard * softening * start.heating * over_melt_)};
  }

  JohnsonCook c_;
  double three_shear_, over_melt_;
};

/// Yield stress by table, lane by lane where one yields.
class TableFlow {
 public:
  TableFlow(const TableStrength& constants, double three_shear)
      : curve_(constants.table, three_shear / 3), three_shear_(three_shear) {}

  [[nodiscard]] Pack yield(const FlowStart& at) const {
    Pack value;
    for (int lane = 0; lane < pack_width; ++lane) value[lane] = curve_.at(at.plastic_strain[lane]);
    return at.scale * value;
  }

  [[nodiscard]] FlowEnd close(const FlowStart& start) const {
    FlowEnd end{Pack{}, yield(start)};
    for (int lane = 0; lane < pack_width; ++lane) {
      const double excess = start.equivalent[lane] - end.yield[lane], scale = start.scale[lane];
      if (!(excess > 0)) continue;
      const double p = start.plastic_strain[lane];
      // scale -> 0, a point without strength: all of the trial stress goes
      end.increment[lane] = scale > smallest_scale ? curve_.plastic_increment(p, excess / scale, three_shear_ / scale)
                                                   : excess / three_shear_;
      end.yield[lane] = scale * curve_.at(p + end.increment[lane]);
    }
    return end;
  }

 private:
  static constexpr double smallest_scale = 1e-12;
  YieldCurve curve_;
  double three_shear_;
};

/// Closed form.
class LinearFlow {
 public:
  LinearFlow(const LinearStrength& constants, double three_shear) : c_(constants), three_shear_(three_shear) {}

  [[nodiscard]] Pack yield(const FlowStart& at) const {
    return at.scale * (c_.yield + c_.hardening * at.plastic_strain + c_.pressure_yield * pack_max(at.pressure, Pack{}));
  }

  [[nodiscard]] FlowEnd close(const FlowStart& start) const {
    const Pack before = yield(start), slope = start.scale * c_.hardening;
    if (three_shear_ == 0) return {Pack{}, before};  // a fluid
    const Pack increment = pack_max(start.equivalent - before, Pack{}) / (three_shear_ + slope);
    return {increment, before + slope * increment};
  }

 private:
  LinearStrength c_;
  double three_shear_;
};

/// The strength law of a material, chosen once a pack: a branch that always goes the same way.
class Strength {
 public:
  Strength(const Metal& constants)
      : flow_(std::visit([&](const auto& strength) { return flow_of(strength, 3 * constants.shear); },
                         constants.strength)) {}

  [[nodiscard]] Pack yield(const FlowStart& at) const {
    return std::visit([&](const auto& flow) { return flow.yield(at); }, flow_);
  }
  [[nodiscard]] FlowEnd close(const FlowStart& start) const {
    return std::visit([&](const auto& flow) { return flow.close(start); }, flow_);
  }
  /// T* where the law has one, else 0.
  [[nodiscard]] Pack homologous(Pack temperature) const {
    const auto* flow = std::get_if<JohnsonCookFlow>(&flow_);
    return flow ? flow->homologous(temperature) : Pack{};
  }

 private:
  using Flow = std::variant<JohnsonCookFlow, TableFlow, LinearFlow>;
  static Flow flow_of(const JohnsonCook& constants, double three_shear) {
    return JohnsonCookFlow(constants, three_shear);
  }
  static Flow flow_of(const TableStrength& constants, double three_shear) { return TableFlow(constants, three_shear); }
  static Flow flow_of(const LinearStrength& constants, double three_shear) {
    return LinearFlow(constants, three_shear);
  }

  Flow flow_;
};

}  // namespace brunt::material
