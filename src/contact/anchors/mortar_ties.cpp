// SPDX-License-Identifier: Apache-2.0
#include "contact/anchors/mortar_ties.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

#include "contact/data/tolerances.hpp"
#include "core/cross_matrix.hpp"
#include "geometry/closest_point.hpp"

namespace brunt::contact {
namespace {

/// Terms and facets of one row.
struct KeptTie {
  const MortarTie& head;
  std::span<const LocalIndex> places;
  std::span<const double> weights;
  std::span<const TiedFacet> facets;
};

KeptTie kept_tie(const MortarTieScene& scene, std::size_t r) {
  const auto first = static_cast<std::size_t>(scene.ties.nodes.offsets[r]);
  const std::size_t count = static_cast<std::size_t>(scene.ties.nodes.offsets[r + 1]) - first;
  return {scene.ties.rows[r], scene.places.subspan(first, count), std::span(scene.ties.weights).subspan(first, count),
          scene.ties.facets.row(static_cast<LocalIndex>(r))};
}

/// The corners of a facet; place_of(term): where it is.
template <class PlaceOf>
struct FacetPlaces {
  std::array<Vec3, 4> x;
  std::size_t count;

  FacetPlaces(const TiedFacet& facet, const PlaceOf& place_of) : count(static_cast<std::size_t>(facet.corner_count)) {
    for (std::size_t i = 0; i < count; ++i) x[i] = place_of(static_cast<std::size_t>(facet.corner[i]));
  }
  [[nodiscard]] std::span<const Vec3> span() const { return {x.data(), count}; }
};

/// What the row keeps at zero, at places of its terms [length].
template <class PlaceOf>
Vec3 crept_at(const KeptTie& tie, const PlaceOf& place_of) {
  Vec3 sum = Vec3::Zero();
  for (std::size_t k = 0; k < static_cast<std::size_t>(tie.head.weighted); ++k) sum += tie.weights[k] * place_of(k);
  if (!tie.head.apart) return sum;
  for (const TiedFacet& facet : tie.facets)
    if (facet.height != 0)
      sum -= facet.height * geometry::area_vector(FacetPlaces(facet, place_of).span()).normalized();
  return sum;
}

/// Adds to the arms of its corners how the facet turns an offset. Its frame is the normal n and the direction t1 of a
/// diagonal (of a triangle an edge) d, with t2 = n x t1. With the area vector's rate dA = sum c_i x v_i,
/// c_i = (x_{i-1} - x_{i+1}) / 2, the frame turns by  w = n x dA / |A| + n (t2 . d') / |d|,  the offset o by w x o.
void add_turn(const TiedFacet& facet, std::span<const Vec3> x, const Vec3& offset, std::span<Arm> arms) {
  const Vec3 area = geometry::area_vector(x);
  const double size = area.norm();
  const Vec3 normal = area / size;
  const std::size_t far = x.size() == 4 ? 2 : 1;
  const Vec3 diagonal = x[far] - x[0];
  const Vec3 beside = normal.cross(diagonal) / diagonal.squaredNorm();  // t2 / |d|
  const Mat3 turned = cross_matrix(offset), tilt = turned * cross_matrix(normal) / size;
  const Vec3 turned_normal = turned * normal;
  for (std::size_t i = 0; i < x.size(); ++i) {
    const Vec3 along = 0.5 * (x[(i + x.size() - 1) % x.size()] - x[(i + 1) % x.size()]);
    Mat3 turn = tilt * cross_matrix(along);
    if (i == far) turn += turned_normal * beside.transpose();
    if (i == 0) turn -= turned_normal * beside.transpose();
    nth(arms, facet.corner[i]).turn += turn;
  }
}

/// The row's impulses have the moment of its whole offset about its points; the arms take it.
void lay_arms(const KeptTie& tie, std::span<const NodeMotion> motion, const Vec3& crept, std::span<Arm> arms) {
  std::ranges::fill(arms, Arm{});
  const auto place_of = [&](std::size_t term) -> const Vec3& { return nth(motion, tie.places[term]).position; };
  for (const TiedFacet& facet : tie.facets) {
    const FacetPlaces corners(facet, place_of);
    const Vec3 pin = facet.height * geometry::area_vector(corners.span()).normalized();
    add_turn(facet, corners.span(), pin + facet.share * crept, arms);
  }
  for (Arm& arm : arms) arm.size = arm.turn.norm();
}

Mat3 free_directions(const MortarTieScene& scene, LocalIndex point) {
  const Mobility& node = nth(scene.mobility, point);
  if (scene.carriers.of(point) != nullptr) return Mat3::Identity();
  return node.inverse_mass > 0 ? node.projector : Mat3(Mat3::Zero());
}

/// Projector onto the directions in which the node or the place below it can move.
Mat3 asked_directions(const KeptTie& tie, const MortarTieScene& scene) {
  Mat3 sum = free_directions(scene, tie.places[0]);
  if (sum.isIdentity(0) || tie.head.below == MortarTie{}.below) return Mat3::Identity();
  for (const std::int32_t term : tie.head.below)
    if (term >= 0) sum += free_directions(scene, nth(tie.places, term));
  Eigen::SelfAdjointEigenSolver<Mat3> directions;
  directions.computeDirect(sum);
  Mat3 asked = Mat3::Identity();
  for (int k = 0; k < 3; ++k)
    if (directions.eigenvalues()[k] <= Mobility::rounding)
      asked -= directions.eigenvectors().col(k) * directions.eigenvectors().col(k).transpose();
  return asked;
}

/// The row's rates in these directions only: G becomes P G.
void project(const Mat3& directions, std::span<const double> weights, std::span<Arm> arms) {
  for (std::size_t k = 0; k < arms.size(); ++k)
    arms[k].turn = directions * arms[k].turn + weights[k] * (directions - Mat3::Identity());
}

/// Out of the master: against the facets, by their shares.
Vec3 normal_of(const KeptTie& tie, std::span<const NodeMotion> motion) {
  const auto place_of = [&](std::size_t term) -> const Vec3& { return nth(motion, tie.places[term]).position; };
  Vec3 sum = Vec3::Zero();
  for (const TiedFacet& facet : tie.facets)
    sum -= facet.share * geometry::area_vector(FacetPlaces(facet, place_of).span()).normalized();
  return sum.normalized();
}

/// Bound of the rounding in the weighted sum of places [length]: each place is rounded when X + u is made, and so is
/// each partial sum, by half an epsilon of the largest coordinate or less, times weights of absolute sum `sum`.
double rounding_of_places(const KeptTie& tie, std::span<const NodeMotion> motion) {
  double largest = 0, sum = 0;
  for (std::size_t k = 0; k < static_cast<std::size_t>(tie.head.weighted); ++k) {
    largest = std::max(largest, nth(motion, tie.places[k]).position.cwiseAbs().maxCoeff());
    sum += std::abs(tie.weights[k]);
  }
  return (2 + tie.head.weighted) * 0.5 * sum * std::numeric_limits<double>::epsilon() * largest;
}

Row row_of(const KeptTie& tie) {
  Row row{.key = {.kind = RowKind::mortar_tie,
                  .slave = tie.head.slave,
                  .master = tie.head.body,
                  .master_second = tie.head.number},
          .node_count = 2,
          .slave_body = tie.head.slave_body,
          .master_body = tie.head.body,
          .master_block = tie.head.block,
          .cone = Cone::free,
          .holds = true};
  for (std::size_t i = 0; i < 2; ++i) {
    row.nodes[i] = tie.places[i];
    row.weights[i] = tie.weights[i];
  }
  return row;
}

/// See ties.cpp: what turning pins would lose within the step is asked back beforehand.
Vec3 lost_in_turning(const KeptTie& tie, const MortarTieScene& scene, const Vec3& crept, const Row& row) {
  const auto old_velocity = [&](LocalIndex node) -> const Vec3& { return nth(scene.motion, node).old_velocity; };
  const Vec3 after = crept_at(tie, [&](std::size_t term) -> Vec3 {
    const NodeMotion& node = nth(scene.motion, tie.places[term]);
    return node.position + scene.dt * node.old_velocity;
  });
  return after - crept - scene.dt * relative_velocity(row, old_velocity);
}

void append_row(const KeptTie& tie, const MortarTieScene& scene, std::span<Arm> arms, std::vector<Row>& rows) {
  Row row = row_of(tie);
  const Mat3 asked = asked_directions(tie, scene);
  const bool all = asked.isIdentity(Mobility::rounding);
  const Vec3 crept =
      crept_at(tie, [&](std::size_t term) -> const Vec3& { return nth(scene.motion, tie.places[term]).position; });
  const double noise = rounding_of_places(tie, scene.motion);
  const bool turns = tie.head.apart || crept.norm() > noise || !all;
  const std::size_t points = turns ? tie.places.size() : static_cast<std::size_t>(tie.head.weighted);
  row.wide_points = tie.places.first(points);
  row.wide_weights = tie.weights.first(points);
  row.normal = normal_of(tie, scene.motion);
  if (turns) {
    lay_arms(tie, scene.motion, crept, arms);
    if (!all) project(asked, tie.weights, arms);
    row.arms = arms;
  }
  row.gap = row.normal.dot(crept);
  Vec3 back = -scene.recovery / scene.dt * crept;
  if (tie.head.apart) back -= lost_in_turning(tie, scene, crept, row) / scene.dt;
  if (!all) back = asked * back;
  row.noise = (scene.recovery + (tie.head.apart ? 1 : 0)) / scene.dt * noise;
  row.required = row.normal.dot(back);
  row.drift = back - row.required * row.normal;
  rows.push_back(row);
}

}  // namespace

const MortarTie* find_mortar_tie(const MortarTies& ties, const RowKey& key) {
  const auto place = [](const MortarTie& row) {
    return std::tuple(row.slave, GlobalIndex{row.body}, GlobalIndex{row.number});
  };
  const std::tuple wanted(key.slave, key.master, key.master_second);
  const auto found = std::ranges::lower_bound(ties.rows, wanted, {}, place);
  return found != ties.rows.end() && place(*found) == wanted ? &*found : nullptr;
}

bool is_held(const MortarTies& ties, GlobalIndex node, std::int32_t body) {
  return std::ranges::binary_search(ties.held, TiedNode{node, body});
}

bool are_torn(const MortarTies& ties, std::span<const LocalIndex> places, std::span<const Vec3> positions) {
  for (std::size_t r = 0; r < ties.rows.size(); ++r) {
    const auto first = static_cast<std::size_t>(ties.nodes.offsets[r]);
    Vec3 sum = Vec3::Zero();
    for (std::size_t k = first; k < first + static_cast<std::size_t>(ties.rows[r].weighted); ++k)
      sum += ties.weights[k] * nth(positions, places[k]);
    double reach = ties.rows[r].size;
    for (const TiedFacet& facet : ties.facets.row(static_cast<LocalIndex>(r))) reach += std::abs(facet.height);
    if (!(sum.norm() <= reach)) return true;
  }
  return false;
}

void append_mortar_ties(const MortarTieScene& scene, std::span<Arm> arms, std::vector<Row>& rows) {
  for (std::size_t r = 0; r < scene.ties.rows.size(); ++r) {
    const KeptTie tie = kept_tie(scene, r);
    const auto first = static_cast<std::size_t>(scene.ties.nodes.offsets[r]);
    append_row(tie, scene, arms.subspan(first, tie.places.size()), rows);
  }
}

}  // namespace brunt::contact
