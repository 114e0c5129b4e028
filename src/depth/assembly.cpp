// SPDX-License-Identifier: Apache-2.0
#include "depth/assembly.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "assembly_start.hpp"
#include "assembly_walk.hpp"

namespace brunt::depth {
namespace {

constexpr double coarse_margin = 1e-5;  // of the radius: kept in the first walk, where rotations are curved
constexpr double first_trust = 0.25;    // of the largest displacement
constexpr double last_trust = 1e-2;     // of the largest displacement, in the walk that closes the margin

double largest(const Standing& standing, const Pose& pose) {
  double most = 0;
  for (std::size_t k = 0; k < pose.motions.size(); ++k) most = std::max(most, standing.farthest(pose, k));
  return most;
}

/// Moves back along all screws to within `gap` of an overlapping pose, and outwards again by this gap.
Pose drawn_back(const Standing& standing, const Pose& pose, double gap) {
  const double end = gap / largest(standing, pose);
  double free = 1, overlaps = 0, step = end;
  while (free - overlaps > end) {
    const double s = overlaps > 0 ? 0.5 * (free + overlaps) : std::max(0.0, free - step);
    if (s > 0 && standing.free(along_screws(pose, s))) {
      free = s;
      step *= 4;
    } else {
      overlaps = s;
      if (s <= 0) break;
    }
  }
  for (const double s : {free + end, free})
    if (s < 1)
      if (Pose back = along_screws(pose, s); standing.free(back)) return back;
  return pose;
}

void report(const Standing& standing, const Pose& pose, AssemblyAnswer& answer) {
  answer.found = true;
  answer.motions = pose.motions;
  answer.length = standing.length(pose);
  for (std::size_t k = 0; k < pose.motions.size(); ++k) answer.farthest.push_back(standing.farthest(pose, k));
}

/// Pairs of two fixed members.
std::vector<std::size_t> hopeless(const Standing& standing, const std::vector<std::size_t>& pairs) {
  std::vector<std::size_t> found;
  for (const std::size_t i : pairs) {
    const MemberPair& pair = standing.assembly().pairs[i];
    if (!standing.member(pair.a).moves() && !standing.member(pair.b).moves()) found.push_back(i);
  }
  return found;
}

}  // namespace

Member make_member(std::span<const Body* const> surfaces, std::span<const double> densities) {
  Member member;
  member.surfaces.assign(surfaces.begin(), surfaces.end());
  rigid::MassMoments moments;
  for (std::size_t s = 0; s < surfaces.size(); ++s) {
    rigid::MassProperties own = surfaces[s]->mass;
    own.mass *= densities[s];
    own.inertia *= densities[s];
    moments = moments + rigid::moments_of(own);
  }
  const rigid::MassProperties whole = surfaces.size() == 1 ? surfaces[0]->mass : rigid::properties_of(moments);
  member.mass = moments.mass;
  member.centroid = whole.centre;
  member.gyration = whole.inertia / whole.mass;
  return member;
}

AssemblyAnswer place_apart(const Assembly& assembly, const AssemblyOptions& options) {
  for (const MemberPair& pair : assembly.pairs)
    if (pair.a == pair.b) throw std::invalid_argument("a pair of surfaces of one member");
  AssemblyAnswer answer;
  const Standing standing(assembly);
  const std::vector<std::size_t> overlapping = standing.overlapping(standing.start());
  answer.left = hopeless(standing, overlapping);
  if (!answer.left.empty()) return answer;
  if (overlapping.empty()) {
    report(standing, standing.start(), answer);
    return answer;
  }
  const double coarse = std::max(coarse_margin, options.clearance) * standing.radius(),
               fine = options.clearance * standing.radius();
  std::vector<Pose> starts;
  std::vector<std::size_t> stuck;
  if (std::optional<Pose> pose = start_by_planes(standing, coarse, stuck)) starts.push_back(std::move(*pose));
  if (std::optional<Pose> pose = start_by_pairs(standing, coarse)) starts.push_back(std::move(*pose));
  if (starts.empty())
    if (std::optional<Pose> pose = start_by_expansion(standing)) starts.push_back(std::move(*pose));
  if (starts.empty()) {
    answer.left = stuck.empty() ? overlapping : stuck;
    return answer;
  }
  AssemblyWalker walker(standing);
  Pose best;
  double shortest = std::numeric_limits<double>::infinity();
  for (const Pose& start : starts) {
    const Pose pose = walker.walk(start, {coarse, first_trust * largest(standing, start), options.most_steps});
    ++answer.walks;
    if (const double length = standing.length(pose); length < shortest) {
      shortest = length;
      best = pose;
    }
  }
  best = walker.walk(best, {fine, last_trust * largest(standing, best), options.most_steps});
  best = drawn_back(standing, best, fine);
  answer.steps = walker.steps();
  report(standing, best, answer);
  return answer;
}

}  // namespace brunt::depth
