// SPDX-License-Identifier: Apache-2.0
#include "smallest_motions.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <numbers>
#include <optional>
#include <set>
#include <utility>

#include "app/whole/scene_assembly.hpp"
#include "app/whole/start_rules.hpp"
#include "app/whole/whole_scene.hpp"
#include "core/error.hpp"
#include "depth/encounter.hpp"
#include "depth/penetration_depth.hpp"
#include "scene/build/select.hpp"
#include "scene/text/units.hpp"
#include "setup/initial_gaps.hpp"

namespace brunt::app {
namespace {

constexpr double shorter = 0.999;  // of the translation: a turn that gains less is not told

std::string vector(const Vec3& x) {
  const auto shown = [](double c) { return std::abs(c) < 1e-6 ? 0.0 : c; };  // of unit vectors: rounding
  return fmt::format("({:.4g}, {:.4g}, {:.4g})", shown(x[0]), shown(x[1]), shown(x[2]));
}

std::set<std::pair<std::size_t, std::size_t>> overlapping_blocks(const setup::InitialGaps& gaps) {
  std::set<std::pair<std::size_t, std::size_t>> pairs;
  const auto add = [&](const auto& one) { pairs.insert(std::minmax({one.block, one.other_block})); };
  for (const auto& overlap : gaps.overlaps) add(overlap);
  for (const auto& piercing : gaps.piercings) add(piercing);
  for (const auto& shared : gaps.shared) add(shared);
  return pairs;
}

/// A part that overlaps another, both as the mesh has them.
struct Overlapping {
  const depth::Body& body;
  const std::string& name;
  const depth::Member& freedom;  ///< of its member
  double mass = 0;
};

struct MotionOut {
  double length = 0;  ///< [length]
  std::string line;
};

std::string bound_line(const depth::Answer& answer, const std::string& units) {
  if (!answer.proven) return "; no lower bound is proven, since the surface of a part crosses itself";
  return fmt::format("; no motion below {} separates them", scene::with_length(answer.bound, units));
}

/// What is reported of moving a out of b as far as the scene lets a move; none where no such motion was found.
std::optional<MotionOut> motion_out(const Overlapping& a, const Overlapping& b, const std::string& units) {
  const auto length = [&](double x) { return scene::with_length(x, units); };
  depth::Query query;
  query.metric = depth::Metric::translation;
  bool anywhere = true;
  for (int c = 0; c < 3; ++c)
    if (const Vec3 column = a.freedom.basis.col(c); column.isZero(0))
      anywhere = false;
    else
      query.along.push_back(column);
  if (query.along.empty()) return std::nullopt;
  if (anywhere) query.along.clear();
  const depth::Answer straight = depth::penetration_depth(a.body, b.body, query);
  if (!straight.found) return std::nullopt;
  std::string line = fmt::format("moving '{}' by {} along {} separates them (translation)", a.name,
                                 length(straight.depth), vector(straight.motion.shift.normalized()));
  if (!anywhere || !a.freedom.turns) return MotionOut{straight.depth, line + bound_line(straight, units)};
  query.metric = depth::Metric::displacement;
  query.tries.push_back(straight.placement);
  query.careful = true;
  const depth::Answer turned = depth::penetration_depth(a.body, b.body, query);
  if (turned.found && turned.depth < shorter * straight.depth) {
    const Vec3 turn = depth::rotation_vector(turned.motion.turn);
    line += fmt::format(", or by {} with a rotation of {:.3g} degrees about {}", length(turned.depth),
                        turn.norm() * 180 / std::numbers::pi, vector(turn.normalized()));
  }
  return MotionOut{turned.found ? std::min(straight.depth, turned.depth) : straight.depth,
                   line + bound_line(turned, units)};
}

/// The lighter one moves, or the one that needs less where the scene holds the lighter one in some way.
std::string described(const Overlapping& a, const Overlapping& b, const std::string& units) {
  if (!depth::Encounter{a.body, b.body, {}}.bodies_collide({}))
    return fmt::format("parts '{}' and '{}' do not overlap as a whole", a.name, b.name);
  const std::string head = fmt::format("parts '{}' and '{}' overlap: ", a.name, b.name);
  const bool a_first = a.mass <= b.mass;
  const Overlapping &first = a_first ? a : b, &second = a_first ? b : a;
  if (!a.freedom.moves() && !b.freedom.moves()) return head + "both are fixed, so neither can move out of the other";
  const std::optional<MotionOut> one = motion_out(first, second, units);
  if (one && first.freedom.turns) return head + one->line;
  const std::optional<MotionOut> other = motion_out(second, first, units);
  if (one && (!other || one->length <= other->length)) return head + one->line;
  if (other) return head + other->line;
  return head + "no admissible motion was found that separates them";
}

}  // namespace

std::vector<std::string> smallest_motions(const scene::Input& input) {
  std::vector<std::string> warnings;
  const mesh::CanonicalMesh whole = whole_mesh(input, warnings);
  const mesh::Mesh& mesh = whole.mesh;
  const setup::StartRules rules = start_rules(input, mesh);
  std::vector<std::string> lines;
  const std::vector<std::size_t> part_of = scene::parts_of_blocks(input, mesh);
  const std::vector<std::size_t> member_of = members_of_blocks(input, mesh, rules);
  const std::vector<depth::Member> freedoms = freedoms_of_members(input, mesh, member_of);
  std::map<std::size_t, depth::Body> bodies;
  for (const auto& [a, b] : overlapping_blocks(setup::initial_gaps(mesh, rules))) {
    if (member_of[a] == member_of[b]) continue;
    const std::string &name_a = input.parts[part_of[a]].name, &name_b = input.parts[part_of[b]].name;
    try {
      for (const std::size_t block : {a, b})
        if (!bodies.contains(block))
          bodies.emplace(block, body_of_block(mesh, block, "part '" + input.parts[part_of[block]].name + "'"));
    } catch (const InputError& error) {
      lines.push_back(fmt::format("parts '{}' and '{}' overlap: no smallest motion: {}", name_a, name_b,
                                  error.faults().empty() ? std::string() : error.faults().front()));
      continue;
    }
    const auto overlapping = [&](std::size_t block, const std::string& name) {
      const depth::Body& body = bodies.at(block);
      return Overlapping{body, name, freedoms[member_of[block]], body.mass.mass * rules.density[block]};
    };
    lines.push_back(described(overlapping(a, name_a), overlapping(b, name_b), input.units));
  }
  return lines;
}

}  // namespace brunt::app
