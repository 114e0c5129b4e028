// SPDX-License-Identifier: Apache-2.0
#include "implicit/data/stiffness.hpp"

#include <algorithm>
#include <numeric>

#include "comm/rendezvous.hpp"
#include "core/cells.hpp"
#include "core/sorted.hpp"
#include "force/pressure_tangent.hpp"
#include "force/tangent.hpp"
#include "model/curve.hpp"

namespace brunt::implicit {
namespace {

constexpr LocalIndex elements_at_once = 64;  // their matrices fit into the second-level cache

/// Calls visit(key of the first corner, nodes) for all elements and then for all faces under pressure, in the order of
/// their keys.
template <class Visit>
void for_each_patch(const model::Model& model, const Visit& visit) {
  std::array<LocalIndex, cells::most_corners> nodes{};
  for (const model::ElementBlock& block : model.blocks)
    for (LocalIndex e = 0; e < block.count && !material::is_rigid(block.law); ++e) {
      for (int c = 0; c < block.corners(); ++c) nth(nodes, c) = block.corner_node(e, c);
      visit(cells::key_of(nth(block.gid, e), 0),
            std::span<const LocalIndex>(nodes.data(), static_cast<std::size_t>(block.corners())));
    }
  GlobalIndex load_number = 1;
  for (const model::PressureLoad& load : model.loads.pressure) {
    for (const mesh::ExteriorFace& face : load.faces)
      visit((load_number << 56) + cells::key_of_face_corner(face.key, 0),
            std::span<const LocalIndex>(face.nodes.data(), face.nodes[3] == no_index ? 3U : 4U));
    ++load_number;
  }
}

}  // namespace

Stiffness::Stiffness(const comm::Communicator& ranks, const model::Model& model, const Unknowns& unknowns) {
  std::vector<std::vector<Slot>> to_rank(static_cast<std::size_t>(ranks.size()));
  number_corners(model, unknowns, to_rank);
  const Ragged<Slot> received = comm::exchange(ranks, to_rank);
  std::vector<comm::RemoteSlot> source;
  for (LocalIndex r = 0; r < received.rows(); ++r)
    for (const Slot& slot : received.row(r)) source.push_back({r, slot.slot});
  leaf_ = received.values;
  leaves_.resize(leaf_.size() * slot_width);
  border_ = comm::Halo(ranks, static_cast<LocalIndex>(slots_.size() / slot_width), source);
  lay_pattern(model, unknowns, received);
}

void Stiffness::number_corners(const model::Model& model, const Unknowns& unknowns,
                               std::vector<std::vector<Slot>>& to_rank) {
  const mesh::LocalMesh& mesh = model.mesh;
  std::vector<LocalIndex> row_of(mesh.node_gid.size(), no_index);
  for (std::size_t r = 0; r < unknowns.node.size(); ++r) nth(row_of, unknowns.node[r]) = static_cast<LocalIndex>(r);
  for (const LocalIndex node : mesh.shared) nth(row_of, node) = no_index;
  LocalIndex slots = 0;
  for_each_patch(model, [&](GlobalIndex key, std::span<const LocalIndex> nodes) {
    Slot slot{.nodes = static_cast<std::int32_t>(nodes.size())};
    for (std::size_t c = 0; c < nodes.size(); ++c) slot.column[c] = nth(mesh.node_gid, nodes[c]);
    for (std::size_t c = 0; c < nodes.size(); ++c) {
      const auto node = static_cast<std::size_t>(nodes[c]);
      if (row_of[node] != no_index) {
        target_.push_back(row_of[node]);
        continue;
      }
      slot.key = key + static_cast<GlobalIndex>(c);
      slot.row = mesh.node_gid[node];
      slot.slot = slots++;
      nth(to_rank, mesh.owner[node]).push_back(slot);
      target_.push_back(-1 - slot.slot);
    }
  });
  slots_.resize(static_cast<std::size_t>(slots) * slot_width);
}

void Stiffness::lay_pattern(const model::Model& model, const Unknowns& unknowns, const Ragged<Slot>& received) {
  const mesh::LocalMesh& mesh = model.mesh;
  std::vector<std::vector<GlobalIndex>> columns(unknowns.node.size());
  for (std::size_t r = 0; r < unknowns.node.size(); ++r)  // a node without an element has only its mass
    columns[r].push_back(nth(mesh.node_gid, unknowns.node[r]));
  std::size_t next = 0;
  for_each_patch(model, [&](GlobalIndex, std::span<const LocalIndex> nodes) {
    for (std::size_t c = 0; c < nodes.size(); ++c) {
      const LocalIndex target = target_[next++];
      if (target < 0) continue;
      for (const LocalIndex node : nodes) nth(columns, target).push_back(nth(mesh.node_gid, node));
    }
  });
  std::vector<std::vector<LocalIndex>> terms(unknowns.node.size());
  for (std::size_t leaf = 0; leaf < received.values.size(); ++leaf) {
    const Slot& slot = received.values[leaf];
    const auto row = std::ranges::lower_bound(unknowns.node, slot.row, {},
                                              [&](LocalIndex node) { return nth(mesh.node_gid, node); }) -
                     unknowns.node.begin();
    auto& own = nth(columns, row);
    own.insert(own.end(), slot.column.begin(), slot.column.begin() + slot.nodes);
    nth(terms, row).push_back(static_cast<LocalIndex>(leaf));
  }
  rows_.begin.assign(1, 0);
  for (std::size_t r = 0; r < columns.size(); ++r) {
    sort_unique(columns[r]);
    const GlobalIndex own = nth(mesh.node_gid, unknowns.node[r]);
    rows_.diagonal.push_back(rows_.begin.back() + (std::ranges::lower_bound(columns[r], own) - columns[r].begin()));
    rows_.column.insert(rows_.column.end(), columns[r].begin(), columns[r].end());
    rows_.begin.push_back(static_cast<std::int64_t>(rows_.column.size()));
    std::ranges::sort(terms[r], {}, [&](LocalIndex leaf) { return nth(leaf_, leaf).key; });
    terms_.values.insert(terms_.values.end(), terms[r].begin(), terms[r].end());
    terms_.close_row();
  }
  rows_.value.resize(9 * rows_.column.size());
}

void Stiffness::assemble(const model::Model& model, const model::State& state, const force::Motion& motion,
                         const force::History& committed) {
  std::ranges::fill(rows_.value, 0.0);
  next_target_ = 0;
  add_elements(model, motion, committed);
  add_pressures(model, state);
  add_border();
}

void Stiffness::add_elements(const model::Model& model, const force::Motion& motion, const force::History& committed) {
  for (std::size_t b = 0; b < model.blocks.size(); ++b) {
    const model::ElementBlock& block = model.blocks[b];
    if (material::is_rigid(block.law)) continue;
    const auto size = static_cast<std::size_t>(9 * block.corners() * block.corners());
    std::vector<LocalIndex> elements;
    std::array<LocalIndex, cells::most_corners> nodes{};
    for (LocalIndex first = 0; first < block.count; first += elements_at_once) {
      elements.resize(static_cast<std::size_t>(std::min(elements_at_once, block.count - first)));
      std::iota(elements.begin(), elements.end(), first);
      matrices_.resize(elements.size() * size);
      force::element_tangents(model, static_cast<LocalIndex>(b), elements, motion, committed, matrices_);
      for (std::size_t k = 0; k < elements.size(); ++k) {
        for (int c = 0; c < block.corners(); ++c) nth(nodes, c) = block.corner_node(elements[k], c);
        add(model, {nodes.data(), static_cast<std::size_t>(block.corners())}, {matrices_.data() + k * size, size});
      }
    }
  }
}

void Stiffness::add_pressures(const model::Model& model, const model::State& state) {
  for (const model::PressureLoad& load : model.loads.pressure) {
    const double pressure = load.value * model::value_at(load.curve, state.time);
    for (const mesh::ExteriorFace& face : load.faces) {
      const std::size_t n = cells::corner_count(face.nodes);
      std::array<Vec3, 4> corner;
      for (std::size_t k = 0; k < n; ++k) corner[k] = Eigen::Map<const Vec3>(nth(state.nodes, face.nodes[k]).x);
      const std::array<Mat3, 4> slope = force::pressure_tangent(pressure, {corner.data(), n});
      std::array<double, 144> matrix{};
      for (std::size_t row = 0; row < 3 * n; ++row)
        for (std::size_t column = 0; column < 3 * n; ++column)
          matrix[row * 3 * n + column] =
              -slope[column / 3](static_cast<Eigen::Index>(row % 3), static_cast<Eigen::Index>(column % 3));
      add(model, {face.nodes.data(), n}, {matrix.data(), 9 * n * n});
    }
  }
}

void Stiffness::add(const model::Model& model, std::span<const LocalIndex> nodes, std::span<const double> matrix) {
  const std::size_t n = nodes.size(), width = 3 * n;
  for (std::size_t a = 0; a < n; ++a) {
    const LocalIndex target = target_[next_target_++];
    for (std::size_t b = 0; b < n; ++b) {
      std::array<double, 9> block;
      for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t j = 0; j < 3; ++j) block[3 * i + j] = matrix[(3 * a + i) * width + 3 * b + j];
      if (target >= 0)
        add_block(target, nth(model.mesh.node_gid, nodes[b]), block.data());
      else
        std::ranges::copy(block, slots_.data() + static_cast<std::ptrdiff_t>(-1 - target) * slot_width + 9 * b);
    }
  }
}

void Stiffness::add_block(LocalIndex row, GlobalIndex column, const double* block) {
  const auto first = rows_.column.begin() + nth(rows_.begin, row);
  const auto last = rows_.column.begin() + rows_.begin[static_cast<std::size_t>(row) + 1];
  double* to = rows_.value.data() + 9 * (std::lower_bound(first, last, column) - rows_.column.begin());
  for (int k = 0; k < 9; ++k) to[k] += block[k];
}

void Stiffness::add_border() {
  border_.forward(slots_, leaves_, slot_width);
  for (LocalIndex row = 0; row < terms_.rows(); ++row)
    for (const LocalIndex leaf : terms_.row(row)) {
      const Slot& slot = nth(leaf_, leaf);
      for (int b = 0; b < slot.nodes; ++b)
        add_block(row, nth(slot.column, b),
                  leaves_.data() + static_cast<std::size_t>(leaf) * slot_width + 9 * static_cast<std::size_t>(b));
    }
}

}  // namespace brunt::implicit
