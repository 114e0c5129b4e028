// SPDX-License-Identifier: Apache-2.0
// Faults of a mesh, found before anything is computed on it.
#include "mesh/check.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/excerpt.hpp"
#include "element_shape.hpp"
#include "mesh/duplicate_elements.hpp"
#include "mesh/mixed_normals.hpp"
#include "mesh/topology.hpp"

namespace brunt::mesh {
namespace {

/// Lines of one kind, the first ten in full.
class Lines {
 public:
  explicit Lines(std::vector<std::string>& target) : target_(target) {}
  ~Lines() {
    if (count_ > most) target_.push_back(fmt::format("... and {} more lines like the one above", count_ - most));
  }
  Lines(const Lines&) = delete;
  Lines& operator=(const Lines&) = delete;
  void add(const std::string& line) {
    if (count_++ < most) target_.push_back(line);
  }

 private:
  static constexpr int most = 10;
  std::vector<std::string>& target_;
  int count_ = 0;
};

std::string shown(const Block& block) {
  return block.name.empty() ? fmt::format("block {}", block.id) : "block " + excerpt(block.name);
}

template <class Visit>
void for_each_element(const Mesh& mesh, Visit visit) {
  for (const Block& block : mesh.blocks)
    for (LocalIndex e = 0; e < block.count(); ++e) visit(block, block.element(e), nth(block.element_id, e));
}

void check_blocks(const Mesh& mesh, std::vector<std::string>& faults) {
  if (mesh.blocks.empty()) faults.emplace_back("missing element blocks; expected at least one");
  Lines lines(faults);
  for (const Block& block : mesh.blocks)
    if (block.count() == 0)
      lines.add(fmt::format("invalid {}: it has no elements; expected at least one", shown(block)));
}

void check_coordinates(const Mesh& mesh, std::vector<std::string>& faults) {
  Lines lines(faults);
  for (std::size_t n = 0; n < mesh.coordinates.size(); ++n) {
    const Vec3& x = mesh.coordinates[n];
    if (!x.allFinite())
      lines.add(fmt::format("invalid node {}: coordinates ({}, {}, {}); expected finite numbers", mesh.node_id[n], x[0],
                            x[1], x[2]));
  }
}

void check_indices(const Mesh& mesh, std::vector<std::string>& faults) {
  Lines lines(faults);
  const auto nodes = static_cast<LocalIndex>(mesh.coordinates.size());
  const auto outside = [nodes](LocalIndex n) { return n < 0 || n >= nodes; };
  for_each_element(mesh, [&](const Block& block, const LocalIndex* element, GlobalIndex id) {
    for (int k = 0; k < nodes_per_element(block.shape); ++k)
      if (outside(element[k]))
        lines.add(fmt::format("invalid element {} ({}): corner {} refers to node position {}; expected 1 to {}", id,
                              shown(block), k + 1, std::int64_t{element[k]} + 1, nodes));
  });
  for (const auto& [name, set] : mesh.node_sets)
    for (const LocalIndex n : set)
      if (outside(n))
        lines.add(fmt::format("invalid node set {}: it refers to node position {}; expected 1 to {}", excerpt(name),
                              std::int64_t{n} + 1, nodes));
  for (const auto& [name, sides] : mesh.side_sets)
    for (const Side& s : sides) {
      const bool known = s.block >= 0 && s.block < static_cast<LocalIndex>(mesh.blocks.size());
      const Block* block = known ? &nth(mesh.blocks, s.block) : nullptr;
      if (!block || s.element < 0 || s.element >= block->count() || s.face < 0 ||
          s.face >= sides_per_element(block->shape))
        lines.add(fmt::format(
            "invalid side set {}: unknown side {} of element position {}; expected sides of existing elements",
            excerpt(name), std::int64_t{s.face} + 1, std::int64_t{s.element} + 1));
    }
}

void check_repeats(const Mesh& mesh, std::vector<std::string>& faults) {
  Lines lines(faults);
  for_each_element(mesh, [&](const Block& block, const LocalIndex* element, GlobalIndex id) {
    if (!corners_are_legal(block.shape, element))
      lines.add(fmt::format("invalid element {} ({}): repeated nodes; expected {}", id, shown(block),
                            block.shape == Shape::hex8    ? "those of a wedge, pyramid or tetrahedron"
                            : block.shape == Shape::quad4 ? "four different nodes (a triangle is a shell3 element)"
                                                          : "different nodes"));
  });
}

void check_jacobians(const Mesh& mesh, std::vector<std::string>& faults) {
  Lines lines(faults);
  for_each_element(mesh, [&](const Block& block, const LocalIndex* element, GlobalIndex id) {
    if (!corners_are_legal(block.shape, element)) return;
    const WorstJacobian worst = worst_jacobian(block.shape, element, mesh.coordinates);
    if (worst.scaled > 1e-12) return;
    const std::string where =
        worst.corner < 0 ? "its centre" : fmt::format("node {}", nth(mesh.node_id, element[worst.corner]));
    lines.add(
        fmt::format("invalid element {} ({}): the Jacobian at {} is not positive ({:.3g} of the product of its edges); "
                    "expected a positive Jacobian",
                    id, shown(block), where, worst.scaled));
  });
}

void check_duplicate_elements(const Mesh& mesh, std::vector<std::string>& faults) {
  Lines lines(faults);
  for (const std::string& line : duplicate_elements(mesh)) lines.add(line);
}

void warn_unused(const Mesh& mesh, std::vector<std::string>& warnings) {
  std::vector<bool> used(mesh.coordinates.size(), false);
  for (const Block& block : mesh.blocks)
    for (const LocalIndex n : block.nodes) nth(used, n) = true;
  const auto count = std::count(used.begin(), used.end(), false);
  if (count == 0) return;
  const auto first = static_cast<std::size_t>(std::find(used.begin(), used.end(), false) - used.begin());
  std::string sets;
  for (const auto& [name, nodes] : mesh.node_sets) {
    const auto lost = std::ranges::count_if(nodes, [&](LocalIndex n) { return !nth(used, n); });
    if (lost > 0) sets += fmt::format("; node set {} loses {} of its {} nodes", excerpt(name), lost, nodes.size());
  }
  warnings.push_back(fmt::format("{} belong{} to no element and {} excluded (the first is node {}){}",
                                 count == 1 ? "1 node" : fmt::format("{} nodes", count), count == 1 ? "s" : "",
                                 count == 1 ? "is" : "are", mesh.node_id[first], sets));
}

void warn_normals(const Mesh& mesh, std::vector<std::string>& warnings) {
  for (const Block& block : mesh.blocks) {
    const MixedNormals mixed = mixed_normals(block);
    if (mixed.count == 0) continue;
    warnings.push_back(fmt::format(
        "{}: the normals of its shells are mixed: {} edge{} lie{} between two elements of opposite sides (the first: "
        "elements {} and {}), where top and bottom and the sign of a pressure change",
        shown(block), mixed.count, mixed.count == 1 ? "" : "s", mixed.count == 1 ? "s" : "",
        nth(block.element_id, mixed.first), nth(block.element_id, mixed.second)));
  }
}

void warn_coincident(const Mesh& mesh, std::vector<std::string>& warnings) {
  Vec3 low = Vec3::Constant(std::numeric_limits<double>::infinity()), high = -low;
  for (const Vec3& x : mesh.coordinates) {
    low = low.cwiseMin(x);
    high = high.cwiseMax(x);
  }
  const double step = std::max(1e-9 * (high - low).maxCoeff(), std::numeric_limits<double>::min());
  struct Place {
    std::int32_t body;
    std::array<double, 3> cell;
    LocalIndex node;
    auto operator<=>(const Place&) const = default;
  };
  std::vector<std::int32_t> body_of(mesh.coordinates.size(), -1);
  const auto body = bodies(mesh);
  std::size_t position = 0;
  for_each_element(mesh, [&](const Block& block, const LocalIndex* element, GlobalIndex) {
    for (int k = 0; k < nodes_per_element(block.shape); ++k) nth(body_of, element[k]) = body[position];
    ++position;
  });
  std::vector<Place> places;
  for (std::size_t n = 0; n < mesh.coordinates.size(); ++n) {
    if (body_of[n] < 0) continue;
    const Vec3 cell = ((mesh.coordinates[n] - low) / step).array().round();
    places.push_back({body_of[n], {cell[0], cell[1], cell[2]}, static_cast<LocalIndex>(n)});
  }
  std::sort(places.begin(), places.end());
  std::int64_t count = 0;
  std::size_t first = 0;
  for (std::size_t i = 1; i < places.size(); ++i)
    if (places[i].body == places[i - 1].body && places[i].cell == places[i - 1].cell && count++ == 0) first = i;
  if (count == 0) return;
  const auto id = [&](std::size_t i) { return nth(mesh.node_id, places[i].node); };
  warnings.push_back(fmt::format(
      "{} nodes coincide with another node of the same body (for example nodes {} and {}): the mesh has a crack there",
      count, id(first - 1), id(first)));
}

}  // namespace

CheckReport check(const Mesh& mesh, MeshSource source) {
  CheckReport report;
  check_blocks(mesh, report.faults);
  check_coordinates(mesh, report.faults);
  check_indices(mesh, report.faults);
  if (!report.faults.empty()) return report;  // what follows reads coordinates through the indices
  check_repeats(mesh, report.faults);
  check_jacobians(mesh, report.faults);
  warn_unused(mesh, report.warnings);
  warn_normals(mesh, report.warnings);
  if (source == MeshSource::generated) return report;
  check_duplicate_elements(mesh, report.faults);
  warn_coincident(mesh, report.warnings);
  return report;
}

}  // namespace brunt::mesh
