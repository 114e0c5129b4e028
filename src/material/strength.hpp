// SPDX-License-Identifier: Apache-2.0
// Yield stress as a function of plastic strain and temperature, and the plastic strain of a return to it.
#pragma once
#include <limits>
#include <optional>
#include <variant>

#include "material/exponential.hpp"
#include "material/law.hpp"
#include "material/yield_curve.hpp"

namespace brunt::material {

/// The state at the start of a return. `scale` multiplies the yield stress: rate and damage.
struct FlowStart {
  Pack equivalent;      ///< of the trial stress [stress]
  Pack plastic_strain;  ///< p
  Pack temperature;     ///< T
  Pack scale;
  Pack pressure;   ///< [stress]
  double warming;  ///< rise of temperature by plastic work, dT = warming Y dp
};

/// The yield stress at the start and its derivative by the plastic strain, without heating.
struct Yield {
  Pack value, slope;
  Pack hardened{}, lost{};  ///< intermediate values of Johnson-Cook's law: p^n and T*^m
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
        over_melt_(constants.melt > constants.room ? 1 / (constants.melt - constants.room) : 0),
        hardening_(constants.n),
        softening_(constants.m) {}

  [[nodiscard]] Pack homologous(Pack temperature) const {
    return pack_min(pack_max((temperature - c_.room) * over_melt_, Pack{}), broadcast(1.0));
  }

  [[nodiscard]] Yield yield(const FlowStart& at) const {
    Yield yield;
    yield.hardened = pack_power(at.plastic_strain, c_.n);
    yield.lost = over_melt_ > 0 ? pack_power(homologous(at.temperature), c_.m) : Pack{};
    set(at.plastic_strain, at.scale * (1.0 - yield.lost), yield);
    return yield;
  }

  /// Newton's method within a bracket: the left side minus q is negative at dp = 0, where the trial stress exceeds the
  /// yield stress, and positive at q / 3 G. The last step is taken when both sides agree to `near`, which brings the
  /// error to rounding; the yield stress is then that of the left side. Each lane ends independently of the others.
  [[nodiscard]] FlowEnd close(const FlowStart& start, const Yield& before) const {
    PackMask open = start.equivalent > before.value;
    const Pack heating = start.warming * before.value;
    Pack low{}, high = start.equivalent * (1 / three_shear_);
    Pack increment = select(open, (start.equivalent - before.value) / (three_shear_ + before.slope), Pack{});
    for (int iteration = 0; iteration < most_iterations && any(open); ++iteration) {
      const Yield at = at_end(start, before, heating, increment);
      const Pack excess = start.equivalent - three_shear_ * increment - at.value;
      low = select(excess > 0.0, increment, low);
      high = select(excess > 0.0, high, increment);
      Pack next = increment + excess / (three_shear_ + at.slope);
      next = select((next >= low) & (next <= high), next, 0.5 * (low + high));
      increment = select(open, next, increment);
      open &= pack_abs(excess) > near * start.equivalent;
    }
    const PackMask flows = start.equivalent > before.value;
    return {increment, select(flows, start.equivalent - three_shear_ * increment, before.value)};
  }

 private:
  static constexpr int most_iterations = 60;  ///< bisection alone reaches rounding within this number
  static constexpr double near = 1e-7;        ///< of the trial stress: the error after one more step is its square

  /// Value and slope from (A + B p^n) times a factor.
  void set(Pack p, Pack factor, Yield& yield) const {
    const Pack floor = broadcast(std::numeric_limits<double>::min());
    yield.value = factor * (c_.a + c_.b * yield.hardened);
    yield.slope = factor * (c_.b * c_.n * yield.hardened / pack_max(p, floor));
  }

  [[nodiscard]] Yield at_end(const FlowStart& start, const Yield& before, Pack heating, Pack increment) const {
    const Pack p = start.plastic_strain + increment;
    Yield yield;
    yield.hardened = hardening_(start.plastic_strain, before.hardened, p);
    if (over_melt_ == 0) {
      set(p, start.scale, yield);
      return yield;
    }
    const Pack floor = broadcast(std::numeric_limits<double>::min());
    const Pack hot = homologous(start.temperature + heating * increment);
    const Pack lost = softening_(homologous(start.temperature), before.lost, hot);
    const Pack softening = select((hot > 0.0) & (hot < 1.0), c_.m * lost / pack_max(hot, floor), Pack{});
    set(p, start.scale, yield);
    yield.slope = yield.slope * (1.0 - lost) - yield.value * softening * heating * over_melt_;
    yield.value *= 1.0 - lost;
    return yield;
  }

  JohnsonCook c_;
  double three_shear_, over_melt_;
  NearPower hardening_, softening_;
};

/// Yield stress by table, lane by lane where one yields.
class TableFlow {
 public:
  TableFlow(const TableStrength& constants, double three_shear)
      : curve_(constants.table, three_shear / 3), three_shear_(three_shear) {}

  [[nodiscard]] Yield yield(const FlowStart& at) const {
    Pack value;
    for (int lane = 0; lane < pack_width; ++lane) value[lane] = curve_.at(at.plastic_strain[lane]);
    return {at.scale * value, Pack{}};
  }

  [[nodiscard]] FlowEnd close(const FlowStart& start, const Yield& before) const {
    FlowEnd end{Pack{}, before.value};
    for (int lane = 0; lane < pack_width; ++lane) {
      const double excess = start.equivalent[lane] - end.yield[lane], scale = start.scale[lane];
      if (!(excess > 0)) continue;
      const double p = start.plastic_strain[lane];
      // scale -> 0, a point without strength: the complete trial stress is returned
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

  [[nodiscard]] Yield yield(const FlowStart& at) const {
    const Pack hard = c_.yield + c_.hardening * at.plastic_strain;
    return {at.scale * (hard + c_.pressure_yield * pack_max(at.pressure, Pack{})), at.scale * c_.hardening};
  }

  [[nodiscard]] FlowEnd close(const FlowStart& start, const Yield& before) const {
    if (three_shear_ == 0) return {Pack{}, before.value};  // a fluid
    const Pack increment = pack_max(start.equivalent - before.value, Pack{}) / (three_shear_ + before.slope);
    return {increment, before.value + before.slope * increment};
  }

 private:
  LinearStrength c_;
  double three_shear_;
};

/// The strength law of a material. The choice is made once for each pack, so the branch is always the same.
class Strength {
 public:
  Strength(const Metal& constants)
      : flow_(std::visit([&](const auto& strength) { return flow_of(strength, 3 * constants.shear); },
                         constants.strength)) {}

  [[nodiscard]] Yield yield(const FlowStart& at) const {
    return std::visit([&](const auto& flow) { return flow.yield(at); }, flow_);
  }
  [[nodiscard]] FlowEnd close(const FlowStart& start, const Yield& before) const {
    return std::visit([&](const auto& flow) { return flow.close(start, before); }, flow_);
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
