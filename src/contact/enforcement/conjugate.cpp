// SPDX-License-Identifier: Apache-2.0
#include "contact/enforcement/conjugate.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "chosen_rows.hpp"
#include "contact/enforcement/rate_constraint.hpp"
#include "core/fixed_sum.hpp"

namespace brunt::contact {
namespace {

/// What one reduction tells of an iterate p, the same on every rank. z: the step of length 1 on the chosen rows; d: the
/// last direction; A = G W G^T.
struct Look {
  double residual = 0;                                 ///< max H |sweep of length 1| beyond a row's noise [velocity]
  double impulse = 0, step = 0, direction = 0;         ///< largest |p|; of z and of the sweep; |d| [momentum]
  double along = 0, astray = 0;                        ///< z.Hz; |sweep of length 1 - z|^2 in the same metric [energy]
  double drop = 0, change = 0, overlap = 0, size = 0;  ///< z.Az, Az.H^-1 Az, Az.H^-1 Ad, d.Hd [energy]
};

/// Sums of which a bound of all their terms together is known.
FixedUnit unit_of_sum(double bound) {
  constexpr int digits = 50;
  return FixedUnit(bound, digits);
}

double squared(double x) {
  return x * x;
}

template <class Kind>
class Conjugate {
 public:
  using Amount = typename Kind::Amount;

  Conjugate(const System& system, const Setting& setting, Exchange& exchange, std::span<Vec3> impulses,
            std::span<Vec3> velocity, EnforcementScratch& scratch);

  /// coupled: in, of this rank's rows, out, of any rank's; speed: largest component of a slave's velocity.
  Look look_at_start(bool& coupled, double& speed);
  /// One product: every row, then rows are chosen anew.
  Look sweep(double length);
  /// One product with z.
  Look look_along();
  /// To the iterate that leaves least on the chosen rows, or less far (see the header). Returns the share of z that is
  /// left: 1 if a sweep is due.
  double advance(const Look& now);
  /// A last sweep of length 1, unseen.
  void finish() { move_all(1); }
  [[nodiscard]] bool has_direction() const { return known_.size > 0; }

 private:
  /// The maxima and sums that any look has.
  struct Seen {
    FixedUnit along, astray;
    std::array<double, 4> largest{};
    std::array<std::int64_t, 6> sums{};
  };
  void see(std::size_t q, Seen& seen) const {
    const Amount sweep = swept(q, 1) - push_[q];
    const double step = Kind::size(sweep), h = scratch_.diagonal[q];
    const Amount astray = sweep - over_.with_friction(q, step_[q]);
    keep_max(seen.largest[0], h * step - law(q).noise);
    keep_max(seen.largest[1], Kind::size(push_[q]));
    keep_max(seen.largest[2], std::max(step, Kind::size(step_[q])));
    seen.sums[0] += seen.along.of(over_.energy(q, step_[q]));
    seen.sums[1] += seen.astray.of(h * Kind::product(astray, astray));
  }
  Amount asked(std::size_t q, double length) const {
    Amount missing = missing_[q];
    if constexpr (Kind::rubs) missing += over_.given(q, push_[q]);
    return push_[q] + length * scratch_.inverse[q] * missing;
  }
  Amount swept(std::size_t q, double length) const { return Kind::admitted(law(q), asked(q, length)); }
  [[nodiscard]] const RowLaw& law(std::size_t q) const { return system_.rows.laws[q]; }
  Vec3 relative(std::size_t q) const {
    return relative_velocity(system_.rows, q, [&](LocalIndex node) -> const Vec3& { return nth(velocity_, node); });
  }
  /// What p leaves to be asked for in this row.
  Amount left(std::size_t q) const {
    const Amount rigid = Kind::missing(law(q), relative(q));
    if (law(q).softness == 0) return rigid;
    return rigid + Kind::held(law(q), scratch_.borne[q]) - scratch_.compliance[q] * push_[q];
  }
  bool can_move(std::size_t q) const { return scratch_.inverse[q] > 0; }
  void move_all(double length);
  /// Takes back of the last step what lies beyond the first row that begins to pull.
  void retreat();
  /// known_, once a step of this length has been taken from from_ along d.
  void bound_after(double length);
  /// What to go over of this row, of which move_all has left in step_ what it asked for.
  void choose(std::size_t q);

  const System& system_;
  const Setting& setting_;
  Exchange& exchange_;
  std::span<Vec3> impulses_, velocity_;
  EnforcementScratch& scratch_;
  ChosenRows<Kind> over_;
  std::span<Amount> push_;                ///< p, a row each like all of these
  std::span<Amount> missing_, step_;      ///< what p leaves to be asked for (less what springs of `over_` take), z
  std::span<Amount> step_change_;         ///< A z
  std::span<Amount> direction_, change_;  ///< d, A d
  Look known_;                            ///< bounds of what the next look will see, from what all ranks know
  Look from_;                             ///< before the last step, but for d, which is of the step
  double slope_ = 1;             ///< an impulse with its friction, in itself; and of changes of what is admitted
  double spread_ = 1;            ///< bound of H^-1 A, from largest number to largest number
  double rows_ = 0;              ///< of all ranks
  double direction_change_ = 0;  ///< Ad.H^-1 Ad [energy]
  double length_ = 0;            ///< of the last step, in d; 0 after a sweep
};

template <class Kind>
Conjugate<Kind>::Conjugate(const System& system, const Setting& setting, Exchange& exchange, std::span<Vec3> impulses,
                           std::span<Vec3> velocity, EnforcementScratch& scratch)
    : system_(system),
      setting_(setting),
      exchange_(exchange),
      impulses_(impulses),
      velocity_(velocity),
      scratch_(scratch),
      over_(system.rows, scratch),
      slope_(Kind::rubs ? 1 + setting.friction : 1.0),
      spread_(system.carriers.bodies.empty() ? 1.0 : scratch.carried.spread) {
  const std::size_t rows = impulses.size();
  for (std::vector<Vec3>* of_rows :
       {&scratch.previous, &scratch.missing, &scratch.step, &scratch.step_change, &scratch.direction, &scratch.change})
    of_rows->resize(rows);
  push_ = Kind::view(scratch.previous);
  missing_ = Kind::view(scratch.missing);
  step_ = Kind::view(scratch.step);
  step_change_ = Kind::view(scratch.step_change);
  direction_ = Kind::view(scratch.direction);
  change_ = Kind::view(scratch.change);
  scratch.inverse.resize(rows);
  for (std::size_t q = 0; q < rows; ++q) {
    const double h = scratch.diagonal[q];
    scratch.inverse[q] = h > 0 ? 1 / h : 0.0;
    push_[q] = h > 0 ? Amount(Kind::taken(law(q), impulses[q])) : Kind::zero();
  }
}

template <class Kind>
Look Conjugate<Kind>::look_at_start(bool& coupled, double& speed) {
  std::array<double, 6> largest{0, 0, 0, 0, coupled ? 1.0 : 0.0, 0};
  std::array<std::int64_t, 1> rows{static_cast<std::int64_t>(system_.rows.size())};
  for (std::size_t q = 0; q < system_.rows.size(); ++q) {
    missing_[q] = left(q);
    const double h = scratch_.diagonal[q];
    if (!(h > 0)) continue;
    const double step = Kind::size(swept(q, 1) - push_[q]);
    keep_max(largest[0], h * step - law(q).noise);
    keep_max(largest[1], Kind::size(push_[q]));
    keep_max(largest[2], step);
    keep_max(largest[3], h * step * step);
    keep_max(largest[5], velocity_[system_.rows.leader(q)].cwiseAbs().maxCoeff());
  }
  exchange_.reduce(largest, rows);
  demand_finite(largest[0] + largest[1]);
  coupled = largest[4] > 0;
  speed = largest[5];
  known_ = {.residual = largest[0], .impulse = largest[1], .step = largest[2]};
  rows_ = static_cast<double>(rows[0]);
  known_.astray = largest[3] * rows_;
  return known_;
}

template <class Kind>
void Conjugate<Kind>::move_all(double length) {
  for (std::size_t q = 0; q < system_.rows.size(); ++q) {
    const Amount next = asked(q, length);
    step_[q] = next;
    push_[q] = Kind::admitted(law(q), next);
    impulses_[q] = Kind::given(law(q), push_[q]);
  }
  // a row moves by 1.5 (|sweep of length 1| + |z|) at most
  known_.impulse = slope_ * (known_.impulse + 3 * known_.step) + setting_.lagging;
  apply_impulses(system_, impulses_, setting_.share * known_.impulse, exchange_, velocity_, scratch_);
}

template <class Kind>
void Conjugate<Kind>::choose(std::size_t q) {
  if (can_move(q)) missing_[q] = left(q);
  const bool chosen = can_move(q) && (law(q).cone != Cone::compression || Kind::pushes(law(q), push_[q]));
  if (chosen)
    over_.choose(q, step_[q], push_[q], missing_[q]);
  else
    over_.leave(q);
  step_[q] = chosen ? over_.scaled(q, missing_[q]) : Kind::zero();
  direction_[q] = change_[q] = Kind::zero();
}

template <class Kind>
Look Conjugate<Kind>::sweep(double length) {
  move_all(length);
  length_ = 0;
  // H bounds A, so that no step is changed by more than the move, in the norm of H
  double bound = 64 * squared(slope_) * (known_.along + known_.astray);
  if (bound == 0) bound = 64 * rows_ * known_.residual * known_.step;  // rounded to nothing under too wide a bound
  Seen seen{unit_of_sum(bound), unit_of_sum(bound)};
  for (std::size_t q = 0; q < system_.rows.size(); ++q) {
    choose(q);
    if (can_move(q)) see(q, seen);
  }
  exchange_.reduce(std::span(seen.largest).first(3), std::span(seen.sums).first(2));
  demand_finite(seen.largest[0] + seen.largest[1]);
  known_ = {.residual = seen.largest[0],
            .impulse = seen.largest[1],
            .step = seen.largest[2],
            .along = seen.along.value(seen.sums[0]),
            .astray = seen.astray.value(seen.sums[1])};
  return known_;
}

template <class Kind>
Look Conjugate<Kind>::look_along() {
  for (std::size_t q = 0; q < system_.rows.size(); ++q)
    impulses_[q] = Kind::given(law(q), over_.with_friction(q, step_[q]));
  velocities_of_impulses(system_, impulses_, setting_.share * slope_ * known_.step, exchange_, velocity_, scratch_);
  const double along = squared(slope_) * known_.along;
  const FixedUnit size = unit_of_sum(known_.size), overlap = unit_of_sum(slope_ * std::sqrt(along * known_.size));
  Seen seen{unit_of_sum(along), unit_of_sum(known_.astray)};
  for (std::size_t q = 0; q < system_.rows.size(); ++q) {
    if (!can_move(q)) continue;
    see(q, seen);
    Amount change = Kind::held(law(q), relative(q));
    if (law(q).softness > 0) change += scratch_.compliance[q] * over_.with_friction(q, step_[q]);
    if constexpr (Kind::rubs) change += over_.given(q, step_[q]);
    step_change_[q] = change;
    if (!over_.has(q)) continue;
    seen.sums[2] += seen.along.of(Kind::product(step_[q], change));
    seen.sums[3] += seen.along.of(over_.product(q, change, change));
    seen.sums[4] += overlap.of(over_.product(q, change, change_[q]));
    seen.sums[5] += size.of(over_.energy(q, direction_[q]));
    keep_max(seen.largest[3], Kind::size(direction_[q]));
  }
  exchange_.reduce(seen.largest, seen.sums);
  demand_finite(seen.largest[0] + seen.largest[1]);
  return {.residual = seen.largest[0],
          .impulse = seen.largest[1],
          .step = seen.largest[2],
          .direction = seen.largest[3],
          .along = seen.along.value(seen.sums[0]),
          .astray = seen.astray.value(seen.sums[1]),
          .drop = seen.along.value(seen.sums[2]),
          .change = seen.along.value(seen.sums[3]),
          .overlap = overlap.value(seen.sums[4]),
          .size = size.value(seen.sums[5])};
}

template <class Kind>
double Conjugate<Kind>::advance(const Look& now) {
  constexpr double wild = 100, far = 100;  // 10 to 1000 take as many iterations
  if (length_ > 0 && now.astray > wild * now.along) {
    retreat();
    return 1;
  }
  const double back = has_direction() ? now.overlap / direction_change_ : 0.0;
  const double change = now.change - back * now.overlap, length = now.drop / change;
  if (!(now.drop > 0) || !(change > 0) || !std::isfinite(length)) return 1;
  direction_change_ = change;
  length_ = length;
  for (std::size_t q = 0; q < system_.rows.size(); ++q) {
    if (!can_move(q)) continue;
    direction_[q] = step_[q] - back * direction_[q];
    change_[q] = step_change_[q] - back * change_[q];
    push_[q] += length * over_.with_friction(q, direction_[q]);
    missing_[q] -= length * change_[q];
    if (over_.has(q)) step_[q] = over_.scaled(q, missing_[q]);
  }
  from_ = now;
  from_.direction = now.step + std::abs(back) * now.direction;
  from_.size = squared(std::sqrt(now.along) + std::abs(back) * std::sqrt(now.size));
  bound_after(length);
  if (length > far) {
    retreat();
    return 1;
  }
  return std::sqrt(std::max(0.0, 1 - length * now.drop / now.along));
}

template <class Kind>
void Conjugate<Kind>::bound_after(double length) {
  constexpr double fold = Kind::rubs ? 4 : 2;  // what admits impulses of friction is no projection
  const double moved = slope_ * length * from_.direction;
  known_ = {.impulse = from_.impulse + moved,
            .step = from_.step + fold * slope_ * spread_ * moved,
            .direction = from_.direction,
            .along = from_.along,  // it shrinks
            .astray = squared(std::sqrt(from_.astray) + fold * squared(slope_) * length * std::sqrt(from_.size)),
            .size = from_.size};
}

template <class Kind>
void Conjugate<Kind>::retreat() {
  double beyond = 0;
  for (std::size_t q = 0; q < system_.rows.size(); ++q) {
    if (!over_.has(q) || law(q).cone != Cone::compression) continue;
    const double now = Kind::along(law(q), push_[q]), before = Kind::along(law(q), push_[q] - length_ * direction_[q]);
    if (now < 0 && now < before) beyond = std::max(beyond, before > 0 ? now / (now - before) : 1.0);
  }
  exchange_.max({&beyond, 1});
  for (std::size_t q = 0; q < system_.rows.size(); ++q) {
    if (!can_move(q)) continue;
    push_[q] -= beyond * length_ * over_.with_friction(q, direction_[q]);
    missing_[q] += beyond * length_ * change_[q];
  }
  bound_after((1 - beyond) * length_);
}

template <class Kind>
EnforcementResult run(const System& system, const EnforcementSettings& settings, const Setting& setting, bool coupled,
                      Exchange& exchange, std::span<Vec3> impulses, std::span<Vec3> velocity,
                      EnforcementScratch& scratch) {
  constexpr double over = 1.5;           // 1 to 1.8 take as many iterations
  constexpr double disagreement = 0.25;  // 0.04 to 1 take as many
  constexpr double nearly = 0.7;         // of what is to be reached: the next sweep is likely to be the last
  Stall stall(60);                       // the largest residual does not descend in each step
  Conjugate<Kind> iteration(system, setting, exchange, impulses, velocity, scratch);
  double speed = 0;
  Look now = iteration.look_at_start(coupled, speed);
  EnforcementResult result{.violation = setting.violation, .residual = now.residual / setting.violation};
  if (!coupled && settings.max_iterations > 0) {
    iteration.finish();
    return {setting.violation, 0.0, 1, true};
  }
  const bool rounding = now.residual <= rounding_share * speed;
  const double enough =
      std::max(residual_to_reach(system, settings, result.residual), rounding_share * speed / setting.violation);
  int sweeps = 1;        // that come next
  bool last = true;      // the next of them may be the last, which is one of length 1
  bool settled = false;  // what is now ends with such a sweep
  while (result.residual > enough && result.iterations < settings.max_iterations) {
    ++result.iterations;
    if (sweeps > 0) {
      now = iteration.sweep(last ? 1.0 : over);
      settled = last;
      last = false;
      sweeps = std::max(sweeps - 1, now.astray > disagreement * now.along ? 1 : 0);
      result.residual = now.residual / setting.violation;
    } else {
      const bool seen = !iteration.has_direction();  // after the sweep
      now = iteration.look_along();
      settled = false;
      result.residual = now.residual / setting.violation;
      if (result.residual <= enough) break;
      const double left = iteration.advance(now);
      last = result.residual * left <= nearly * enough;
      if (last || left >= 1 || (!seen && now.astray > disagreement * now.along)) sweeps = 1;
    }
    if (const int due = stall.sweeps_due(result.iterations, result.residual); due > 0) sweeps = due;
  }
  const bool finish = result.iterations == 0 ? !rounding : !settled;
  if (finish) iteration.finish();
  result.acted = finish || now.impulse > 0;
  return result;
}

}  // namespace

EnforcementResult iterate_conjugate(const System& system, const EnforcementSettings& settings, const Setting& setting,
                                    bool coupled, Exchange& exchange, std::span<Vec3> impulses,
                                    std::span<Vec3> velocity, EnforcementScratch& scratch) {
  const auto solve = setting.rubs ? run<Rubbing> : setting.holds ? run<Whole> : run<Normal>;
  return solve(system, settings, setting, coupled, exchange, impulses, velocity, scratch);
}

}  // namespace brunt::contact
