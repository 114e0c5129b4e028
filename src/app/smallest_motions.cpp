// SPDX-License-Identifier: Apache-2.0
#include "smallest_motions.hpp"

#include <fmt/format.h>

#include <map>
#include <numbers>
#include <optional>
#include <set>
#include <utility>

#include "brunt/core/error.hpp"
#include "brunt/depth/penetration_depth.hpp"
#include "brunt/scene/select.hpp"
#include "brunt/scene/units.hpp"
#include "brunt/setup/initial_gaps.hpp"
#include "prepare.hpp"
#include "scene_assembly.hpp"
#include "start_rules.hpp"

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

/// What is told of moving a out of b; both stand as the mesh has them.
std::string described(const depth::Body& a, const depth::Body& b, const std::string& name_a, const std::string& name_b,
                      const std::string& units) {
  const std::string head = fmt::format("parts '{}' and '{}' overlap: ", name_a, name_b);
  depth::Query query;
  query.metric = depth::Metric::translation;
  const depth::Answer straight = depth::penetration_depth(a, b, query);
  if (!straight.overlap) return fmt::format("parts '{}' and '{}' do not overlap as a whole", name_a, name_b);
  query.metric = depth::Metric::displacement;
  if (straight.found) query.tries.push_back(straight.placement);
  query.careful = true;
  const depth::Answer turned = depth::penetration_depth(a, b, query);
  if (!straight.found || !turned.found) return head + "no motion was found that separates them";
  const auto length = [&](double x) { return scene::with_length(x, units); };
  std::string line = head + fmt::format("moving '{}' by {} along {} separates them (translation)", name_a,
                                        length(straight.depth), vector(straight.motion.shift.normalized()));
  if (turned.depth < shorter * straight.depth) {
    const Vec3 turn = depth::rotation_vector(turned.motion.turn);
    line += fmt::format(", or by {} with a turn of {:.3g} degrees about {}", length(turned.depth),
                        turn.norm() * 180 / std::numbers::pi, vector(turn.normalized()));
  }
  return line + fmt::format("; no motion below {} does", length(turned.bound));
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
  std::map<std::size_t, depth::Body> bodies;
  for (const auto& [a, b] : overlapping_blocks(setup::initial_gaps(mesh, rules))) {
    if (member_of[a] == member_of[b]) continue;
    const std::string &name_a = input.parts[part_of[a]].name, &name_b = input.parts[part_of[b]].name;
    try {
      for (const std::size_t block : {a, b})
        if (!bodies.contains(block))
          bodies.emplace(block, body_of_block(mesh, block, "part '" + input.parts[part_of[block]].name + "'"));
    } catch (const InputError& error) {
      lines.push_back(fmt::format("parts '{}' and '{}' overlap: no smallest motion, {}", name_a, name_b,
                                  error.faults().empty() ? std::string() : error.faults().front()));
      continue;
    }
    const depth::Body &one = bodies.at(a), &other = bodies.at(b);
    const bool lighter = one.mass.mass * rules.density[a] <= other.mass.mass * rules.density[b];
    lines.push_back(lighter ? described(one, other, name_a, name_b, input.units)
                            : described(other, one, name_b, name_a, input.units));
  }
  return lines;
}

}  // namespace brunt::app
