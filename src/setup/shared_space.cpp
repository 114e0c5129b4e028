// SPDX-License-Identifier: Apache-2.0
#include "setup/shared_space.hpp"

#include <utility>

#include "contact/search/search.hpp"

namespace brunt::setup {
namespace {

Vec3 middle_of(const mesh::Mesh& mesh, const mesh::Block& block, LocalIndex e) {
  const int count = mesh::nodes_per_element(block.shape);
  Vec3 sum = Vec3::Zero();
  for (int c = 0; c < count; ++c) sum += nth(mesh.coordinates, block.element(e)[c]);
  return sum / count;
}

}  // namespace

ElementsInside elements_inside(const mesh::Mesh& mesh, const mesh::Block& one, const mesh::Block& other,
                               const contact::Tolerances& tolerances) {
  std::vector<geometry::Box> boxes;
  geometry::Box around;
  for (LocalIndex e = 0; e < other.count(); ++e) {
    boxes.push_back(box_of_element(mesh, other, e));
    geometry::extend(around, boxes.back().low);
    geometry::extend(around, boxes.back().high);
  }
  std::vector<LocalIndex> elements;
  std::vector<Vec3> middles;
  for (LocalIndex e = 0; e < one.count(); ++e)
    if (const Vec3 middle = middle_of(mesh, one, e); geometry::contains(around, middle)) {
      elements.push_back(e);
      middles.push_back(middle);
    }
  ElementsInside inside;
  contact::SearchScratch scratch;
  Ragged<LocalIndex> pairs;
  contact::find_pairs(boxes, middles, scratch, pairs);
  for (std::size_t i = 0; i < middles.size(); ++i)
    for (const LocalIndex e : std::as_const(pairs).row(static_cast<LocalIndex>(i))) {
      if (!in_element(middles[i], mesh, other, e, tolerances)) continue;
      if (inside.count++ == 0) inside.first = elements[i];
      break;
    }
  return inside;
}

}  // namespace brunt::setup
