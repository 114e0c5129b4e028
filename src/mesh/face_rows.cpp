// SPDX-License-Identifier: Apache-2.0
// A counting sort of all faces by their lowest node.
#include "mesh/face_rows.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

#include "core/cells.hpp"
#include "face_corners.hpp"

namespace brunt::mesh {
namespace {

/// Sorting network of four.
void sort_four(std::array<LocalIndex, 4>& n) {
  const auto order = [&](std::size_t a, std::size_t b) {
    if (n[b] < n[a]) std::swap(n[a], n[b]);
  };
  order(0, 1);
  order(2, 3);
  order(0, 2);
  order(1, 3);
  order(1, 2);
}

std::size_t lowest(const std::array<LocalIndex, 4>& nodes) {
  const LocalIndex of_three = std::min({nodes[0], nodes[1], nodes[2]});
  return static_cast<std::size_t>(nodes[3] == no_index ? of_three : std::min(of_three, nodes[3]));
}

/// Calls visit(nodes, code) for each face with at least three distinct nodes, by element and face.
template <class Visit>
void for_each_face(const Mesh& mesh, Visit visit) {
  std::uint32_t code = 0;
  for (const Block& block : mesh.blocks)
    for (LocalIndex e = 0; e < block.count(); ++e, code += cells::key_stride)
      for (int f = 0; f < faces_per_element(block.shape); ++f) {
        const auto nodes = corners_of_face(block.shape, block.element(e), f);
        if (nodes[0] != no_index) visit(nodes, code + static_cast<std::uint32_t>(f));
      }
}

}  // namespace

FaceRows::FaceRows(const Mesh& mesh) : mesh_(mesh), block_first_{0}, first_(mesh.coordinates.size() + 1, 0) {
  for (const Block& block : mesh.blocks) block_first_.push_back(block_first_.back() + block.count());
  // counted two places on, so that filling moves the starts where they belong
  first_.push_back(0);
  for_each_face(mesh, [&](const auto& nodes, std::uint32_t) { ++first_[lowest(nodes) + 2]; });
  std::partial_sum(first_.begin(), first_.end(), first_.begin());
  code_.resize(first_.back());
  for_each_face(mesh, [&](const auto& nodes, std::uint32_t code) { code_[first_[lowest(nodes) + 1]++] = code; });
  first_.pop_back();
}

std::size_t FaceRows::block_of(LocalIndex element) const {
  return static_cast<std::size_t>(std::ranges::upper_bound(block_first_, element) - block_first_.begin()) - 1;
}

KeyedFace FaceRows::face_of(std::uint32_t code) const {
  KeyedFace face{
      {}, static_cast<LocalIndex>(code / cells::key_stride), static_cast<std::int32_t>(code % cells::key_stride)};
  const std::size_t b = block_of(face.element);
  const Block& block = mesh_.blocks[b];
  face.key = corners_of_face(block.shape, block.element(face.element - block_first_[b]), face.face);
  sort_four(face.key);
  return face;
}

}  // namespace brunt::mesh
