// SPDX-License-Identifier: Apache-2.0
#include "place_parts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numbers>
#include <optional>

#include "placed_far.hpp"
#include "scene/build/build.hpp"
#include "scene/build/select.hpp"
#include "scene/text/units.hpp"
#include "scene_assembly.hpp"

namespace brunt::app {
namespace {

constexpr double worth_a_line = 1e-5;  // of the largest displacement: the accuracy of a walk (depth/assembly_walk.cpp)
constexpr double over_limit = 1e-6;    // of the limit: less comes from the gap that is left

struct Placer {
  const scene::Input& input;
  const mesh::Mesh& mesh;
  const SceneAssembly& scene;
  std::vector<std::size_t> part_of = scene::parts_of_blocks(input, mesh);

  [[nodiscard]] const std::string& part(std::size_t block) const { return input.parts[part_of[block]].name; }
  [[nodiscard]] std::string length(double value) const { return scene::with_length(value, input.units); }
  [[nodiscard]] std::size_t block_of(std::size_t member, std::size_t surface) const {
    return scene.blocks[member][surface];
  }
  [[nodiscard]] std::string name(std::size_t member) const {
    std::string text;
    for (const std::size_t b : scene.blocks[member])
      text += text.empty() ? fmt::format("part '{}'", part(b)) : fmt::format(" with '{}'", part(b));
    return text;
  }

  [[nodiscard]] std::string unparted(std::size_t pair) const {
    const depth::MemberPair& ends = scene.assembly.pairs[pair];
    const std::string &a = part(block_of(ends.a, ends.a_surface)), &b = part(block_of(ends.b, ends.b_surface));
    const bool held = !scene.assembly.members[ends.a].moves() && !scene.assembly.members[ends.b].moves();
    return fmt::format(
        "{}: invalid initial_overlap: place cannot separate parts '{}' and '{}'{}; expected free space, and at least "
        "one part that can move",
        input.at(scene::contact_key(input, a, b)), a, b, held ? ", which are both fixed" : "");
  }

  /// The least limit that holds for the member, and its entry of `contact`.
  struct Limit {
    double length;
    std::size_t entry;
  };
  [[nodiscard]] std::optional<Limit> limit_of(std::size_t member) const {
    std::optional<Limit> least;
    for (const std::size_t a : scene.blocks[member])
      for (std::size_t b = 0; b < mesh.blocks.size(); ++b) {
        const std::optional<std::size_t> entry = scene::deciding_entry(input, part(a), part(b));
        if (!entry || !input.contact[*entry].limit) continue;
        const double length = *input.contact[*entry].limit;
        if (!least || length < least->length) least = Limit{length, *entry};
      }
    return least;
  }

  /// The part that goes farthest beyond its limit.
  [[nodiscard]] std::optional<std::string> beyond_limit(const depth::AssemblyAnswer& answer) const {
    std::optional<std::string> fault;
    double worst = 1;
    for (std::size_t k = 0; k < answer.farthest.size(); ++k) {
      const std::optional<Limit> limit = limit_of(k);
      if (!limit || answer.farthest[k] <= worst * (1 + over_limit) * limit->length) continue;
      worst = answer.farthest[k] / limit->length;
      fault = fmt::format("{}: out of range: initial_overlap: place would move {} by {}; expected at most {}",
                          input.at(fmt::format("contact.{}.limit", limit->entry)), name(k), length(answer.farthest[k]),
                          length(limit->length));
    }
    return fault;
  }

  /// The part that moves farthest beyond its overlaps, of those with a limit or of those without.
  [[nodiscard]] std::optional<FarMotion> beyond_overlap(const setup::InitialGaps& gaps,
                                                        const depth::AssemblyAnswer& answer, bool limited) const {
    std::vector<char> judged(scene.blocks.size());
    for (std::size_t k = 0; k < judged.size(); ++k)
      judged[k] = answer.farthest[k] > 0 && limit_of(k).has_value() == limited;
    return placed_far(scene, gaps, answer, judged);
  }
  [[nodiscard]] std::string refused(const FarMotion& far) const {
    const std::string &one = part(far.block), &other = part(far.other_block);
    return fmt::format(
        "{}: out of range: initial_overlap: place would move part '{}' by {} relative to part '{}', which it overlaps "
        "by {}; expected at most {:g} times the overlap: correct the positions or sizes of the parts, or set limit to "
        "the largest displacement that is intended",
        input.at(scene::contact_key(input, one, other)), one, length(far.motion), other, length(far.overlap),
        scene::most_overlaps);
  }
  [[nodiscard]] std::string admitted(const FarMotion& far) const {
    return fmt::format(
        "initial_overlap: place moves part '{}' by {} relative to part '{}', which it overlaps by {}: a shorter motion "
        "may have been missed",
        part(far.block), length(far.motion), part(far.other_block), length(far.overlap));
  }

  [[nodiscard]] std::string moved_line(std::size_t k, const depth::AssemblyAnswer& answer) const {
    const Vec3& t = answer.motions[k].shift;
    const Vec3 turn = depth::rotation_vector(answer.motions[k].turn);
    const double degrees = turn.norm() * 180 / std::numbers::pi;
    const double shown = worth_a_line * answer.farthest[k];  // smaller components are rounding
    const auto component = [&](double x) { return std::abs(x) < shown ? 0.0 : x; };
    std::string line =
        fmt::format("placed           {}: moved by {} at most, translation ({:.6g}, {:.6g}, {:.6g})", name(k),
                    length(answer.farthest[k]), component(t[0]), component(t[1]), component(t[2]));
    if (degrees < 1e-4) return line + ", no turn";
    const Vec3 axis = turn.normalized();
    return line +
           fmt::format(", turned by {:.4g} degrees about ({:.4g}, {:.4g}, {:.4g})", degrees, axis[0], axis[1], axis[2]);
  }
};

}  // namespace

PlacedParts place_parts(const scene::Input& input, mesh::Mesh& mesh, const setup::StartRules& rules,
                        const setup::InitialGaps& gaps) {
  PlacedParts placed;
  const SceneAssembly scene = scene_assembly(input, mesh, rules);
  placed.faults = scene.faults;
  if (!placed.faults.empty()) return placed;
  const depth::AssemblyAnswer answer = depth::place_apart(scene.assembly);
  const Placer placer{input, mesh, scene};
  for (const std::size_t pair : answer.left) placed.faults.push_back(placer.unparted(pair));
  if (!answer.found) return placed;
  if (const std::optional<std::string> fault = placer.beyond_limit(answer)) placed.faults.push_back(*fault);
  if (placed.faults.empty())
    if (const std::optional<FarMotion> far = placer.beyond_overlap(gaps, answer, false))
      placed.faults.push_back(placer.refused(*far));
  if (!placed.faults.empty()) return placed;
  if (const std::optional<FarMotion> far = placer.beyond_overlap(gaps, answer, true))
    placed.warnings.push_back(placer.admitted(*far));

  const double largest = std::ranges::max(answer.farthest);
  std::size_t count = 0;
  std::vector<char> done(mesh.coordinates.size(), 0);
  for (std::size_t k = 0; k < scene.blocks.size(); ++k) {
    if (!(answer.farthest[k] > 0)) continue;
    if (answer.farthest[k] > worth_a_line * largest) {
      placed.notes.push_back(placer.moved_line(k, answer));
      count += scene.blocks[k].size();
    }
    const Placement to = depth::moved({}, answer.motions[k], scene.assembly.members[k].centroid);
    for (const std::size_t b : scene.blocks[k]) {
      const mesh::Block& block = mesh.blocks[b];
      for (LocalIndex e = 0; e < block.count(); ++e)
        for (int i = 0; i < mesh::nodes_per_element(block.shape); ++i) {
          const auto node = static_cast<std::size_t>(block.element(e)[i]);
          if (!done[node]) mesh.coordinates[node] = to(mesh.coordinates[node]);
          done[node] = 1;
        }
    }
  }
  placed.notes.insert(placed.notes.begin(), fmt::format("initial overlaps: {} part{} placed, moved by {} at most",
                                                        count, count == 1 ? "" : "s", placer.length(largest)));
  return placed;
}

}  // namespace brunt::app
