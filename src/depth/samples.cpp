// SPDX-License-Identifier: Apache-2.0
#include "depth/samples.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <random>

#include "depth/walk.hpp"

namespace brunt::depth {
namespace {

constexpr int contact_bisections = 16;     // between a colliding and a free placement: to 1e-5 of the way
constexpr std::size_t most_draws = 10000;  // in a row without a collision: the bodies are then too thin to sample

/// Stages of the walks: the share of the walks that is continued, and the steps of each.
struct Stage {
  std::size_t share;
  int steps;
};
constexpr std::array<Stage, 3> stages{{{1, 3}, {3, 6}, {10, 40}}};

class Draws {
 public:
  Draws(const Body& a, const Body& b) : a_(a), b_(b) {}

  /// The centroid of A within reach of that of B, any rotation (Shoemake, Graphics Gems III, 1992).
  [[nodiscard]] Placement placement() {
    const double u = number(), v = 2 * std::numbers::pi * number(), w = 2 * std::numbers::pi * number();
    const double one = std::sqrt(1 - u), other = std::sqrt(u);
    Placement drawn;
    drawn.rotation = Eigen::Quaterniond(other * std::cos(w), one * std::sin(v), one * std::cos(v), other * std::sin(w))
                         .toRotationMatrix();
    const double z = 2 * number() - 1, angle = 2 * std::numbers::pi * number(), across = std::sqrt(1 - z * z);
    const double distance = number() * (a_.shape.radius + b_.shape.radius);
    const Vec3 centre = b_.shape.centroid + distance * Vec3(across * std::cos(angle), across * std::sin(angle), z);
    drawn.translation = centre - drawn.rotation * a_.shape.centroid;
    return drawn;
  }

 private:
  [[nodiscard]] double number() { return static_cast<double>(engine_() >> 11) * 0x1p-53; }  // in [0, 1)
  const Body &a_, &b_;
  std::mt19937_64 engine_{20071};
};

}  // namespace

std::vector<Placement> sample_contacts(const Body& a, const Body& b, std::size_t count) {
  std::vector<Placement> samples;
  Draws draws(a, b);
  for (std::size_t draw = 0; samples.size() < count && draw < most_draws; ++draw) {
    Encounter encounter{a, b, draws.placement()};
    if (!encounter.collides({})) continue;
    const RigidMotion way = motion_between(encounter.start, draws.placement(), a.shape.centroid);
    if (encounter.collides(way)) continue;
    double inside = 0, outside = 1;
    for (int i = 0; i < contact_bisections; ++i) {
      const double middle = 0.5 * (inside + outside);
      (encounter.collides(along_screw(way, middle)) ? inside : outside) = middle;
    }
    samples.push_back(encounter.placement(along_screw(way, outside)));
    draw = 0;
  }
  return samples;
}

std::vector<Start> nearest_samples(const Encounter& encounter, Metric metric, const std::vector<Placement>& samples,
                                   const SampleSearch& options) {
  const MetricShape& shape = encounter.a.shape;
  std::vector<Start> starts;
  starts.reserve(samples.size());
  for (const Placement& sample : samples) {
    const RigidMotion motion = motion_between(encounter.start, sample, shape.centroid);
    starts.push_back({motion, length_of(shape, metric, motion)});
  }
  std::ranges::stable_sort(starts, {}, &Start::length);
  std::vector<Start> chosen;
  for (const Start& start : starts) {
    if (chosen.size() >= options.nearest) break;
    const auto near = [&](const Start& other) {
      const RigidMotion between{(other.motion.turn * start.motion.turn.conjugate()).normalized(),
                                other.motion.shift - start.motion.shift};
      return length_of(shape, metric, between) < options.spacing * start.length;
    };
    if (std::ranges::none_of(chosen, near)) chosen.push_back(start);
  }
  return chosen;
}

std::optional<Placement> best_from_samples(Encounter& encounter, Metric metric, const std::vector<Placement>& samples,
                                           const SampleSearch& options) {
  if (metric == Metric::translation) return std::nullopt;
  WalkOptions walking;
  walking.metric = metric;
  Walker walker;
  std::vector<Walk> walks;
  for (const Start& start : nearest_samples(encounter, metric, samples, options))
    if (const Start free = freed(encounter, metric, start.motion); free.length > 0)
      walks.push_back(Walker::begin(encounter, free.motion, walking));
  if (walks.empty()) return std::nullopt;
  for (const Stage& stage : stages) {
    std::ranges::stable_sort(walks, {}, &Walk::length);
    for (std::size_t i = 0; i < (walks.size() + stage.share - 1) / stage.share; ++i)
      walker.advance(encounter, walks[i], walking, stage.steps);
  }
  return encounter.placement(std::ranges::min(walks, {}, &Walk::length).motion);
}

}  // namespace brunt::depth
