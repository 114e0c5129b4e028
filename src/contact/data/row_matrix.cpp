// SPDX-License-Identifier: Apache-2.0
#include "contact/data/row_matrix.hpp"

namespace brunt::contact {

void RowMatrix::clear() {
  offsets.assign(1, 0);
  points.clear();
  weights.clear();
  first_arm.clear();
  arms.clear();
  tilt_of.clear();
  laws.clear();
  figures.clear();
  on_bodies.clear();
}

void RowMatrix::reserve(std::size_t rows, std::size_t entries, std::size_t arms_of_rows, std::size_t tilts) {
  offsets.reserve(rows + 1);
  points.reserve(entries);
  weights.reserve(entries);
  first_arm.reserve(rows);
  arms.reserve(arms_of_rows);
  tilt_of.reserve(tilts);
  laws.reserve(rows);
  figures.reserve(rows);
}

void RowMatrix::close_row(const RowLaw& law, const RowFigures& of_row) {
  const std::size_t first = static_cast<std::size_t>(offsets.back()), count = points.size() - first;
  demand(count > 0, "a row of contact has a point");
  first_arm.push_back(law.turns   ? static_cast<LocalIndex>(arms.size() - count)
                      : law.tilts ? static_cast<LocalIndex>(tilt_of.size() - count)
                                  : 0);
  offsets.push_back(static_cast<LocalIndex>(points.size()));
  laws.push_back(law);
  figures.push_back(of_row);
}

void RowMatrix::append(const RowMatrix& other, std::size_t q) {
  for (std::size_t k = other.begin(q); k < other.end(q); ++k) {
    add(other.points[k], other.weights[k]);
    if (other.laws[q].turns) arms.push_back(other.arm(q, k));
    if (other.laws[q].tilts) tilt_of.push_back(other.tilt(q, k));
  }
  close_row(other.laws[q], other.figures[q]);
  if (!other.has_bodies()) return;
  const std::span<const BodyShare> bodies = other.bodies_of(q);
  on_bodies.values.insert(on_bodies.values.end(), bodies.begin(), bodies.end());
  on_bodies.close_row();
}

RowLaw law_of(const Row& row) {
  RowLaw law{.normal = row.normal,
             .required = row.required,
             .drift = row.drift,
             .lagging = row.lagging,
             .noise = row.noise,
             .softness = row.softness,
             .share = largest_share(row),
             .cone = row.cone,
             .turns = !row.arms.empty(),
             .tilts = !row.tilts.empty()};
  if (row.holds)
    law.across = Across::holds;
  else if (row.friction > 0)
    law.across = Across::rubs;
  if (law.across == Across::rubs) law.friction = row.friction;
  return law;
}

const RowMatrix& compress(std::span<const Row> rows, RowMatrix& matrix) {
  matrix.clear();
  for (const Row& row : rows) {
    for (std::size_t i = 0; i < row.points().size(); ++i) {
      matrix.add(row.points()[i], row.shares()[i]);
      if (!row.arms.empty()) matrix.arms.push_back(row.arms[i]);
      if (!row.tilts.empty()) matrix.tilt_of.push_back(row.tilts[i]);
    }
    matrix.close_row(law_of(row), {.gap = row.gap,
                                   .gap_share = row.gap_share,
                                   .drift_share = row.drift_share,
                                   .wall_rate = row.wall_rate,
                                   .slab = row.slab,
                                   .pass = row.pass});
  }
  return matrix;
}

}  // namespace brunt::contact
