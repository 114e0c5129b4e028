// SPDX-License-Identifier: Apache-2.0
#include "overlap_report.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include "scene/build/build.hpp"
#include "scene/build/select.hpp"
#include "scene/text/units.hpp"

namespace brunt::app {
namespace {

using setup::InitialGaps;
using setup::InitialOverlap;
using setup::OverlapRule;
using setup::Piercing;
using setup::SharedSpace;

struct Reporter {
  const scene::Input& input;
  const mesh::Mesh& mesh;
  std::vector<std::size_t> part_of = scene::parts_of_blocks(input, mesh);

  [[nodiscard]] const std::string& part(std::size_t block) const { return input.parts[part_of[block]].name; }
  [[nodiscard]] GlobalIndex node(LocalIndex index) const { return nth(mesh.node_id, index); }

  [[nodiscard]] std::string length(double value) const { return scene::with_length(value, input.units); }
  [[nodiscard]] std::string place(LocalIndex index) const {
    const Vec3& x = nth(mesh.coordinates, index);
    return fmt::format("at [{:.6g}, {:.6g}, {:.6g}]", x.x(), x.y(), x.z());
  }

  /// The two parts of an overlap, whichever is inside the other.
  [[nodiscard]] std::pair<std::size_t, std::size_t> parts(const InitialOverlap& overlap) const {
    return std::minmax({part_of[overlap.block], part_of[overlap.other_block]});
  }
  /// The entry of `contact` that holds for the two.
  [[nodiscard]] std::string where(std::size_t block, std::size_t other) const {
    return input.at(scene::contact_key(input, part(block), part(other)));
  }

  [[nodiscard]] std::string describe(const InitialOverlap& deepest, std::size_t nodes, std::size_t too_deep) const {
    std::string line = fmt::format("{}: initial overlap: node {} of part '{}' lies {} inside part '{}'",
                                   where(deepest.block, deepest.other_block), node(deepest.node), part(deepest.block),
                                   length(deepest.penetration), part(deepest.other_block));
    if (deepest.is_within_itself()) line += " (one body, which overlaps itself)";
    if (nodes > 1)
      line += fmt::format(
          ", the deepest of {} overlapping nodes of the two parts (brunt check lists the deepest, with --all every "
          "one)",
          nodes);
    if (too_deep > 0)
      line +=
          fmt::format("; {} of them are too deep for contact to detect, or are detected from the wrong side", too_deep);
    return line + fmt::format("; node {} is {}", node(deepest.node), place(deepest.node));
  }

  [[nodiscard]] std::string describe(const Piercing& piercing) const {
    return fmt::format(
        "{}: initial overlap: part '{}' intersects part '{}' ({} edge{}; first: nodes {}-{} through face {}) without a "
        "node inside, and contact would detect the edges from the wrong side",
        where(piercing.block, piercing.other_block), part(piercing.block), part(piercing.other_block), piercing.edges,
        piercing.edges == 1 ? "" : "s", node(piercing.edge[0]), node(piercing.edge[1]),
        name_of_face(mesh, piercing.face));
  }

  [[nodiscard]] std::string describe(const SharedSpace& shared) const {
    return fmt::format(
        "{}: initial overlap: part '{}' coincides with part '{}' ({} of its elements are inside; first: element {}): "
        "all surface nodes of each part lie on faces of the other, and contact would detect nothing",
        where(shared.block, shared.other_block), part(shared.block), part(shared.other_block), shared.elements,
        shared.first);
  }
};

/// The overlaps of two parts.
struct Pair {
  const InitialOverlap* deepest;
  std::size_t nodes = 0, too_deep = 0;
  bool itself = false;  ///< some of them lie in their own body
};

std::vector<Pair> pairs_of(const Reporter& reporter, const InitialGaps& gaps) {
  std::vector<Pair> pairs;
  for (const InitialOverlap& overlap : gaps.overlaps) {
    auto known = std::ranges::find_if(
        pairs, [&](const Pair& pair) { return reporter.parts(*pair.deepest) == reporter.parts(overlap); });
    if (known == pairs.end()) known = pairs.insert(pairs.end(), Pair{&overlap});
    ++known->nodes;
    known->too_deep += overlap.too_deep ? 1 : 0;
    known->itself = known->itself || overlap.is_within_itself();
  }
  return pairs;
}

const char* word_of_rule(OverlapRule rule) {
  switch (rule) {
    case OverlapRule::error:
      return "error";
    case OverlapRule::warn:
      return "warn";
    case OverlapRule::move:
      return "move";
    case OverlapRule::place:
      return "place";
    case OverlapRule::offset:
      break;
  }
  return "offset";
}

/// Whether the scene says anywhere what happens to overlaps.
bool is_given(const scene::Input& input) {
  for (std::size_t k = 0; k < input.contact.size(); ++k)
    if (input.places.has(fmt::format("contact.{}.initial_overlap", k))) return true;
  return false;
}

std::string listed(const Reporter& reporter, const InitialOverlap& overlap) {
  return fmt::format(
      "node {:>8} of {:<16} {} inside {}{}{}, {}", reporter.node(overlap.node), reporter.part(overlap.block),
      reporter.length(overlap.penetration), reporter.part(overlap.other_block),
      overlap.face[0] == no_index ? "" : fmt::format(", behind its face {}", name_of_face(reporter.mesh, overlap.face)),
      overlap.too_deep ? ", too deep for contact" : "", reporter.place(overlap.node));
}

std::string listed(const Reporter& reporter, const Piercing& piercing) {
  return fmt::format("{} edges of {} through {}, first {}-{} through face {}", piercing.edges,
                     reporter.part(piercing.block), reporter.part(piercing.other_block),
                     reporter.node(piercing.edge[0]), reporter.node(piercing.edge[1]),
                     name_of_face(reporter.mesh, piercing.face));
}

std::string listed(const Reporter& reporter, const SharedSpace& shared) {
  return fmt::format("{} elements of {} inside {}, first {}", shared.elements, reporter.part(shared.block),
                     reporter.part(shared.other_block), shared.first);
}

/// Overlaps come deepest first.
void list_overlaps(const Reporter& reporter, const InitialGaps& gaps, OverlapReport& report) {
  constexpr std::size_t most = 10;
  std::map<std::pair<std::size_t, std::size_t>, std::size_t> nodes;  // of a pair of parts
  for (const InitialOverlap& overlap : gaps.overlaps) {
    report.list.push_back(listed(reporter, overlap));
    if (++nodes[reporter.parts(overlap)] <= most) report.deepest.push_back(report.list.back());
  }
  for (const auto& [pair, count] : nodes)
    if (count > most)
      report.deepest.push_back(
          fmt::format("... and {} more nodes of {} and {}, none deeper; brunt check --all lists them", count - most,
                      reporter.input.parts[pair.first].name, reporter.input.parts[pair.second].name));
  const auto list_all = [&](const auto& of_one_kind) {
    for (const auto& one : of_one_kind) {
      report.list.push_back(listed(reporter, one));
      report.deepest.push_back(report.list.back());
    }
  };
  list_all(gaps.piercings);
  list_all(gaps.shared);
}

}  // namespace

std::string name_of_face(const mesh::Mesh& mesh, const setup::FaceNodes& face) {
  std::string name;
  for (const LocalIndex node : face)
    if (node != no_index) name += fmt::format("{}{}", name.empty() ? "" : "-", nth(mesh.node_id, node));
  return name;
}

OverlapReport report_overlaps(const scene::Input& input, const mesh::Mesh& mesh, const InitialGaps& gaps) {
  OverlapReport report;
  if (gaps.overlaps.empty() && gaps.piercings.empty() && gaps.shared.empty()) return report;
  const Reporter reporter{input, mesh};
  list_overlaps(reporter, gaps, report);
  bool refused = false, untreatable = false;     // without a rule of the scene: nodes that rules can, and cannot treat
  std::set<std::string> insufficient, unsuited;  // rules of the scene that do not treat an overlap; a body in itself
  const auto judge = [&](OverlapRule rule, bool treatable, std::string line) {
    if (rule == OverlapRule::place) return;
    if (rule == OverlapRule::warn) return report.warnings.push_back(std::move(line));
    if (rule != OverlapRule::error && treatable) return;
    if (rule == OverlapRule::error)
      (treatable ? refused : untreatable) = true;
    else
      insufficient.insert(word_of_rule(rule));
    report.faults.push_back(std::move(line));
  };
  for (const Pair& pair : pairs_of(reporter, gaps)) {
    std::string line = reporter.describe(*pair.deepest, pair.nodes, pair.too_deep);
    const OverlapRule rule = pair.deepest->rule;
    if (pair.itself && (rule == OverlapRule::move || rule == OverlapRule::place)) {
      unsuited.insert(word_of_rule(rule));
      report.faults.push_back(std::move(line));
    } else {
      judge(pair.deepest->rule, pair.too_deep == 0, std::move(line));
    }
  }
  for (const Piercing& piercing : gaps.piercings) judge(piercing.rule, false, reporter.describe(piercing));
  for (const SharedSpace& shared : gaps.shared) judge(shared.rule, false, reporter.describe(shared));
  if (refused && !untreatable)
    report.faults.push_back(fmt::format(
        "{}: invalid initial overlap; expected parts that do not overlap, or initial_overlap: {}, place (parts moved "
        "apart before the run){}",
        input.at("contact"), input.implicit ? "warn (kept or closed, by the scheme)" : "warn (recovered slowly)",
        input.implicit ? " or move (nodes moved out)" : ", move (nodes moved out) or offset (kept as zero gap)"));
  if (untreatable)
    report.faults.push_back(input.at("contact") +
                            ": invalid initial overlap; expected parts that do not overlap, or initial_overlap: place "
                            "(parts moved apart before the run); these overlaps are too deep for other treatments");
  for (const std::string& rule : insufficient)
    report.faults.push_back(
        fmt::format("{}: invalid initial_overlap: {}{} treats nodes less than a quarter of a face's edge and half an "
                    "element inside; expected parts farther apart, or initial_overlap: place",
                    input.at("contact"), rule, is_given(input) ? "" : ", the default of ties,"));
  for (const std::string& rule : unsuited)
    report.faults.push_back(fmt::format(
        "{}: invalid initial_overlap: {} does not separate a body from itself; expected a corrected mesh, or warn "
        "(recovered slowly) or offset (kept as zero gap)",
        input.at("contact"), rule));
  return report;
}

}  // namespace brunt::app
