// SPDX-License-Identifier: Apache-2.0
#include "contact/mortar/interface.hpp"

#include "contact/mortar/normals.hpp"
#include "core/error.hpp"
#include "scratch.hpp"

namespace brunt::contact {

namespace {

/// Entries in the order of slave facets, sorted by row; those of one node are added in that order.
template <class Block>
void gather(const std::vector<Entry<Block>>& entries, std::size_t rows, MortarScratch& scratch,
            NodeBlocks<Block>& out) {
  std::vector<LocalIndex>&first = scratch.first_of_row, &order = scratch.order, &place = scratch.place_of_node;
  first.assign(rows + 1, 0);
  for (const Entry<Block>& entry : entries) ++first[static_cast<std::size_t>(entry.row) + 1];
  for (std::size_t row = 0; row < rows; ++row) first[row + 1] += first[row];
  order.resize(entries.size());
  std::vector<LocalIndex>& next = scratch.next_of_row;
  next.assign(first.begin(), first.end() - 1);
  for (std::size_t e = 0; e < entries.size(); ++e) nth(order, nth(next, entries[e].row)++) = static_cast<LocalIndex>(e);
  out.clear();
  for (std::size_t row = 0; row < rows; ++row) {
    for (LocalIndex k = first[row]; k < first[row + 1]; ++k) {
      const Entry<Block>& entry = nth(entries, nth(order, k));
      LocalIndex& at = nth(place, entry.node);
      if (at < out.nodes.offsets.back()) {  // not yet in this row
        at = static_cast<LocalIndex>(out.blocks.size());
        out.nodes.values.push_back(entry.node);
        out.blocks.push_back(entry.block);
      } else {
        nth(out.blocks, at) += entry.block;
      }
    }
    out.nodes.close_row();
  }
  for (const LocalIndex node : out.nodes.values) nth(place, node) = no_index;
}

/// Entries of one facet's rows; weights, and derivatives of gap vectors on request.
void take_facet(const FacetRows& facet, const FacetNodes& row_of_corner, MortarScratch& scratch, MortarRows& rows,
                std::span<const Vec3> fixed, bool with_slopes) {
  for (std::size_t j = 0; j < facet.corners(); ++j) {
    const LocalIndex row = row_of_corner[j];
    if (row == no_index || static_cast<std::size_t>(row) >= rows.covered.size()) continue;
    nth(rows.covered, row) += facet.share(j);
    nth(rows.gap_vectors, row) += facet.gap_vector(j);
    if (with_slopes) facet.gap_slopes(j, scratch.gap_slopes);
    if (!fixed.empty()) facet.fixed_slopes(j, fixed, scratch.fixed_slopes);
    for (std::size_t k = 0; k < facet.nodes().size(); ++k) {
      scratch.weights.push_back({row, facet.nodes()[k], facet.weight(j, k)});
      if (with_slopes) {
        scratch.gaps.push_back({row, facet.nodes()[k], scratch.gap_slopes[k]});
        scratch.covered.push_back({row, facet.nodes()[k], facet.share_slope(j, k)});
      }
      if (!fixed.empty()) scratch.of_fixed.push_back({row, facet.nodes()[k], scratch.fixed_slopes[k]});
    }
  }
}

void take_coverage(const FacetRows& facet, bool with_slopes, FacetCoverage& coverage) {
  coverage.area.back() = facet.covered_area();
  for (std::size_t k = 0; with_slopes && k < facet.nodes().size(); ++k) {
    coverage.slopes.nodes.values.push_back(facet.nodes()[k]);
    coverage.slopes.blocks.push_back(facet.covered_area_slope(k));
  }
}

struct CornerTractions {
  std::array<Vec3, 4> of{Vec3::Zero(), Vec3::Zero(), Vec3::Zero(), Vec3::Zero()};
  bool loaded = false;

  CornerTractions(const FacetNodes& row_of_corner, std::size_t corners, std::span<const Vec3> tractions) {
    for (std::size_t j = 0; j < corners && !tractions.empty(); ++j) {
      const LocalIndex row = row_of_corner[j];
      if (row != no_index) of[j] = nth(tractions, row);
      loaded = loaded || !of[j].isZero(0);
    }
  }
};

/// The patch of one facet, unless its tractions are zero.
void take_patch(const FacetRows& facet, std::size_t index, const FacetNodes& row_of_corner,
                std::span<const Vec3> tractions, std::span<const Vec3> transposed, MortarScratch& scratch,
                Patches& patches) {
  const CornerTractions of_corner(row_of_corner, facet.corners(), tractions);
  if (!of_corner.loaded) return;
  Patch& patch = patches.next(static_cast<LocalIndex>(index));
  patch.rows.assign(facet.nodes().begin(), facet.nodes().end());
  patch.columns = patch.rows;
  facet.traction_patch(of_corner.of, patch.values);
  const CornerTractions also(row_of_corner, facet.corners(), transposed);
  if (!also.loaded) return;
  facet.traction_patch(also.of, scratch.transposed);
  const std::size_t size = 3 * patch.rows.size();
  for (std::size_t r = 0; r < size; ++r)
    for (std::size_t c = 0; c < size; ++c) patch.values[r * size + c] += scratch.transposed[c * size + r];
}

void evaluate(const MortarSurfaces& surfaces, const MortarTopology& topology, const Ragged<LocalIndex>& candidates,
              std::span<const Vec3> x, std::span<const Vec3> tractions, MortarScratch& scratch, MortarRows& rows,
              MortarSlopes* slopes, std::span<const Vec3> fixed, std::span<const Vec3> transposed) {
  const std::size_t row_count = surfaces.rows.size();
  demand(static_cast<std::size_t>(candidates.rows()) == surfaces.slave.size(), "mortar: a row of candidates a facet");
  demand(tractions.empty() || tractions.size() == row_count + surfaces.rows_elsewhere.size(),
         "mortar: a traction a row");
  rows.covered.assign(row_count, 0);
  rows.gap_vectors.assign(row_count, Vec3::Zero());
  rows.segments = 0;
  scratch.place_of_node.assign(x.size(), no_index);
  scratch.weights.clear();
  scratch.gaps.clear();
  scratch.of_fixed.clear();
  scratch.covered.clear();
  if (slopes != nullptr) slopes->weights.clear();
  scratch.coverage.clear();
  for (std::size_t facet = 0; facet < surfaces.slave.size(); ++facet) {
    if (facet > 0 && slopes != nullptr) scratch.coverage.slopes.nodes.close_row();
    scratch.coverage.area.push_back(0);
    if (!scratch.facet.evaluate(surfaces, facet, candidates.row(static_cast<LocalIndex>(facet)), x, slopes != nullptr))
      continue;
    const bool ours = surfaces.is_ours(facet);
    rows.segments += ours ? scratch.facet.segments() : 0;
    take_coverage(scratch.facet, slopes != nullptr, scratch.coverage);
    take_facet(scratch.facet, topology.row_of_corner[facet], scratch, rows, fixed, slopes != nullptr);
    if (slopes != nullptr && ours)
      take_patch(scratch.facet, facet, topology.row_of_corner[facet], tractions, transposed, scratch, slopes->weights);
  }
  if (slopes != nullptr) scratch.coverage.slopes.nodes.close_row();
  gather(scratch.weights, row_count, scratch, rows.weights);
  if (slopes != nullptr) {
    gather(scratch.gaps, row_count, scratch, slopes->gap_vectors);
    gather(scratch.covered, row_count, scratch, slopes->covered);
    gather(scratch.of_fixed, row_count, scratch, slopes->of_fixed);
  }
  nodal_normals(surfaces, topology, x, rows.normals, slopes != nullptr ? &slopes->normals : nullptr, &scratch.coverage);
  rows.gaps.resize(row_count);
  for (std::size_t row = 0; row < row_count; ++row) rows.gaps[row] = rows.normals[row].dot(rows.gap_vectors[row]);
}

}  // namespace

void MortarScratchDeleter::operator()(MortarScratch* scratch) const {
  delete scratch;
}

MortarScratchPointer make_mortar_scratch() {
  return MortarScratchPointer(new MortarScratch);
}

Patch& Patches::next(LocalIndex from) {
  if (count == patch.size()) patch.emplace_back();
  source.resize(count);
  source.push_back(from);
  return patch[count++];
}

void mortar_rows(const MortarSurfaces& surfaces, const MortarTopology& topology, const Ragged<LocalIndex>& candidates,
                 std::span<const Vec3> x, MortarScratch& scratch, MortarRows& rows) {
  evaluate(surfaces, topology, candidates, x, {}, scratch, rows, nullptr, {}, {});
}

void mortar_rows_and_slopes(const MortarSurfaces& surfaces, const MortarTopology& topology,
                            const Ragged<LocalIndex>& candidates, std::span<const Vec3> x,
                            std::span<const Vec3> tractions, MortarScratch& scratch, MortarRows& rows,
                            MortarSlopes& slopes, std::span<const Vec3> fixed, std::span<const Vec3> transposed) {
  evaluate(surfaces, topology, candidates, x, tractions, scratch, rows, &slopes, fixed, transposed);
}

}  // namespace brunt::contact
