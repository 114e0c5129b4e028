// SPDX-License-Identifier: Apache-2.0
#include "overlap_rows.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>

namespace brunt::depth {
namespace {

using geometry::Triangle;

constexpr double facing = 0.25;     // cosine: a normal may lean this much to the wrong side
constexpr double passed = 1e-3;     // cosine: the same of pairs that do not cross
constexpr double flat = 1e-3;       // sine: half the turn of the normal at an edge that belongs to a plane
constexpr double beside = 1e-3;     // sine: a normal may lie this much beside those of an edge
constexpr double parallel = 1e-7;   // sine: the product of parallel edges is undefined
constexpr double same_row = 1e-9;   // of A's radius, and of normals: equal conditions
constexpr double rounding = 1e-12;  // of A's radius: a vertex nearer to the surface has no direction to it

Vec3 normal_of(const Triangle& t) {
  return (t[1] - t[0]).cross(t[2] - t[0]).normalized();
}

/// The corners of what lies of a triangle over or under another one, along that one's normal: at most six.
struct Cut {
  std::array<Vec3, 6> corners;
  std::size_t count = 0;
  Cut() { corners.fill(Vec3::Zero()); }
  void add(const Vec3& x) {
    if (count < corners.size()) corners[count++] = x;
  }
};

/// A plane that parts two triangles, and their overlap along its normal.
struct Parting {
  enum class Of { none, face_b, face_a, edges } of = Of::none;
  Vec3 normal = Vec3::Zero();  ///< from b to a
  Vec3 at = Vec3::Zero();      ///< edges: point of a's edge nearest to b's
  double gap = -std::numeric_limits<double>::infinity();
  Cut cut;  ///< faces: what lies of the other triangle over this one
};

/// The point of the line through p along u nearest to the line through q along v, within the segment.
Vec3 nearest_on_edge(const Vec3& p, const Vec3& u, const Vec3& q, const Vec3& v) {
  const double uu = u.squaredNorm(), uv = u.dot(v), vv = v.squaredNorm();
  const double determinant = uu * vv - uv * uv;
  const double s = ((q - p).dot(u) * vv - (q - p).dot(v) * uv) / determinant;
  return p + std::clamp(s, 0.0, 1.0) * u;
}

/// A triangle with the normals of its features, in the axes of B.
struct Facet {
  Triangle corners;
  geometry::TriangleNormals normals;
};

Facet facet_of(const geometry::SlabTree& tree, LocalIndex t) {
  const auto i = static_cast<std::size_t>(t);
  return {tree.triangles[i], tree.normals[i]};
}

/// The corner that lies farthest along n.
std::size_t farthest(const Triangle& t, const Vec3& n) {
  const std::size_t k = n.dot(t[1]) > n.dot(t[0]) ? 1 : 0;
  return n.dot(t[2]) > n.dot(t[k]) ? 2 : k;
}

/// Whether the surface about the corner that is farthest along n faces along n.
bool reaches(const Facet& facet, const Vec3& n) {
  if (n.dot(facet.normals[0]) >= -facing) return true;
  return n.dot(facet.normals[4 + farthest(facet.corners, n)]) >= -facing;
}

/// Whether n is among the normals of edge i: between those of the two faces that meet there in a convex edge.
bool among(const Facet& facet, std::size_t i, const Vec3& n) {
  const Vec3 &face = facet.normals[0], &edge = facet.normals[1 + i];
  const Vec3 along = facet.corners[(i + 1) % 3] - facet.corners[i];
  if (!(along.cross(face).dot(edge) > flat * along.norm()) || !(n.dot(edge) > 0)) return false;
  // the sine of the angle by which n is farther from the middle of the edge's normals than the face's
  return n.cross(edge).norm() * face.dot(edge) - n.dot(edge) * face.cross(edge).norm() <= beside;
}

Cut cut_over(const Triangle& t, const Triangle& base, const Vec3& normal) {
  Cut cut;
  for (const Vec3& x : t) cut.add(x);
  for (std::size_t i = 0; i < 3; ++i) {
    const Vec3 side = (base[(i + 1) % 3] - base[i]).cross(normal);  // outward
    const Cut whole = cut;
    cut.count = 0;
    for (std::size_t k = 0; k < whole.count; ++k) {
      const Vec3 &x = whole.corners[k], &next = whole.corners[(k + 1) % whole.count];
      const double here = side.dot(x - base[i]), there = side.dot(next - base[i]);
      if (here <= 0) cut.add(x);
      if ((here < 0 && there > 0) || (here > 0 && there < 0)) cut.add(x + here / (here - there) * (next - x));
    }
  }
  return cut;
}

double least_height(const Cut& cut, const Vec3& from, const Vec3& n) {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < cut.count; ++k) least = std::min(least, n.dot(cut.corners[k] - from));
  return least;
}

Parting parting_of(const Facet& fa, const Facet& fb) {
  const Triangle &a = fa.corners, &b = fb.corners;
  const Vec3 na = normal_of(a), nb = normal_of(b);
  Parting best;
  const auto offer = [&](Parting::Of of, const Vec3& n, double gap) {
    if (gap > best.gap) best = {of, n, Vec3::Zero(), gap, {}};
  };
  if (reaches(fa, -nb)) {
    const Cut cut = cut_over(a, b, nb);
    offer(Parting::Of::face_b, nb, least_height(cut, b[0], nb));
    if (best.of == Parting::Of::face_b) best.cut = cut;
  }
  if (reaches(fb, -na)) {
    const Cut cut = cut_over(b, a, na);
    offer(Parting::Of::face_a, -na, least_height(cut, a[0], na));
    if (best.of == Parting::Of::face_a) best.cut = cut;
  }
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) {
      const Vec3 u = a[(i + 1) % 3] - a[i], v = b[(j + 1) % 3] - b[j], product = u.cross(v);
      if (!(product.norm() > parallel * u.norm() * v.norm())) continue;
      for (const double sign : {1.0, -1.0}) {
        const Vec3 n = sign * product.normalized();
        if (!among(fa, i, -n) || !among(fb, j, n)) continue;
        const double gap = n.dot(a[i] - b[j]);
        if (gap > best.gap) best = {Parting::Of::edges, n, nearest_on_edge(a[i], u, b[j], v), gap, {}};
      }
    }
  return best;
}

bool before(const Vec3& x, const Vec3& y) {
  return std::lexicographical_compare(x.data(), x.data() + 3, y.data(), y.data() + 3);
}

/// Corners of the triangles, each once.
std::vector<Vec3> corners_of(const geometry::SlabTree& tree, std::vector<LocalIndex> triangles) {
  std::vector<Vec3> corners;
  std::sort(triangles.begin(), triangles.end());
  triangles.erase(std::unique(triangles.begin(), triangles.end()), triangles.end());
  for (const LocalIndex t : triangles)
    for (const Vec3& x : nth(tree.triangles, t)) corners.push_back(x);
  std::sort(corners.begin(), corners.end(), before);
  corners.erase(std::unique(corners.begin(), corners.end()), corners.end());
  return corners;
}

}  // namespace

struct OverlapRows::Place {
  const Encounter& encounter;
  Placement now;
  Mat3 into;    // from B's axes to those of A at q_0
  Vec3 centre;  // of A, in B's coordinates
  double band, margin, most;
};

void OverlapRows::add(const Place& place, const Vec3& normal, const Vec3& at, double gap) {
  if (!(gap < place.band)) return;
  const double bound = place.margin - gap;
  conditions.push_back({place.into * normal, place.into * (at - place.centre), gap, bound, no_index, no_index});
  deepest = std::max(deepest, bound);
}

void OverlapRows::part(const Place& place, const geometry::NearPair& pair) {
  Triangle a = nth(place.encounter.a.tree.triangles, pair.a);
  for (Vec3& corner : a) corner = place.now(corner);
  const Triangle& b = nth(place.encounter.b.tree.triangles, pair.b);
  if (pair.distance > 0) {
    const Vec3 normal = (pair.on_a - pair.on_b) / pair.distance;
    if (normal.dot(normal_of(a)) <= passed && normal.dot(normal_of(b)) >= -passed)
      add(place, normal, pair.on_a, pair.distance);
    return;
  }
  crossing_a_.push_back(pair.a);
  crossing_b_.push_back(pair.b);
  Facet facet = facet_of(place.encounter.a.tree, pair.a);
  facet.corners = a;
  for (Vec3& normal : facet.normals) normal = place.now.rotation * normal;
  const Parting plane = parting_of(facet, facet_of(place.encounter.b.tree, pair.b));
  const bool skipped = plane.of == Parting::Of::none || -plane.gap > place.most;
  overlaps_.push_back(skipped ? 0 : std::max(0.0, -plane.gap));
  if (skipped) return;
  switch (plane.of) {
    case Parting::Of::none:
      break;
    case Parting::Of::face_b:
      for (std::size_t k = 0; k < plane.cut.count; ++k)
        add(place, plane.normal, plane.cut.corners[k], plane.normal.dot(plane.cut.corners[k] - b[0]));
      break;
    case Parting::Of::face_a:
      for (std::size_t k = 0; k < plane.cut.count; ++k)
        add(place, plane.normal, plane.cut.corners[k], plane.normal.dot(a[0] - plane.cut.corners[k]));
      break;
    case Parting::Of::edges:
      add(place, plane.normal, plane.at, plane.gap);
      break;
  }
}

void OverlapRows::free_vertex(const Place& place, const Vec3& x, bool of_a) {
  const Encounter& encounter = place.encounter;
  const geometry::SlabTree& other = of_a ? encounter.b.tree : encounter.a.tree;
  const Vec3 in_other = of_a ? place.now(x) : place.now.back(x);
  if (!geometry::contains(other.box, in_other)) return;
  const geometry::PointDepth here = geometry::point_depth(other, in_other, place.band);
  if (here.triangle == no_index || !(here.depth > rounding * encounter.a.shape.radius)) return;
  const Vec3 out = (here.nearest - in_other) / here.depth;
  add(place, of_a ? out : Vec3(-(place.now.rotation * out)), of_a ? in_other : x, -here.depth);
}

/// Of the triangles that cross, and some far from each other: for vertices whose triangles are inside as a whole.
void OverlapRows::free_vertices(const Place& place) {
  const Body &a = place.encounter.a, &b = place.encounter.b;
  for (const Vec3& x : corners_of(a.tree, crossing_a_)) free_vertex(place, x, true);
  for (const Vec3& x : corners_of(b.tree, crossing_b_)) free_vertex(place, x, false);
  for (const Vec3& x : a.outposts) free_vertex(place, x, true);
  for (const Vec3& x : b.outposts) free_vertex(place, x, false);
}

void OverlapRows::find(const Encounter& encounter, const RigidMotion& motion, double band, double margin, double most) {
  const Placement now = encounter.placement(motion);
  const Place place{encounter,
                    now,
                    encounter.start.rotation.transpose(),
                    now(encounter.a.shape.centroid),
                    encounter.apart + band,
                    encounter.apart + margin,
                    most};
  conditions.clear();
  crossing_a_.clear();
  crossing_b_.clear();
  overlaps_.clear();
  deepest = 0;
  geometry::near_pairs(encounter.a.tree, encounter.b.tree, now, place.band, pairs_);
  for (const geometry::NearPair& pair : pairs_) part(place, pair);
  free_vertices(place);
  merge(same_row * encounter.a.shape.radius);
}

/// Triangles around a common corner or edge give the same condition; the order is that of positions.
void OverlapRows::merge(double grid) {
  struct Key {
    std::array<double, 6> at;
    NearCondition condition;
  };
  std::vector<Key> keys;
  keys.reserve(conditions.size());
  for (const NearCondition& condition : conditions) {
    Key key{{}, condition};
    for (std::size_t c = 0; c < 3; ++c) {
      key.at[c] = std::round(condition.arm[static_cast<int>(c)] / grid);
      key.at[c + 3] = std::round(condition.normal[static_cast<int>(c)] / same_row);
    }
    keys.push_back(key);
  }
  std::sort(keys.begin(), keys.end(), [](const Key& x, const Key& y) {
    return x.at != y.at ? x.at < y.at : x.condition.bound > y.condition.bound;
  });
  conditions.clear();
  for (std::size_t i = 0; i < keys.size(); ++i)
    if (i == 0 || keys[i].at != keys[i - 1].at) conditions.push_back(keys[i].condition);
}

double OverlapRows::sum_of_regions() const {
  std::vector<std::size_t> region(
      overlaps_.size());  // a pair of the same region with a lower number, or the pair itself
  const auto root = [&](std::size_t i) {
    while (region[i] != i) i = region[i] = region[region[i]];
    return i;
  };
  std::map<LocalIndex, std::size_t> of_a, of_b;  // a pair with this triangle
  for (std::size_t i = 0; i < overlaps_.size(); ++i) {
    region[i] = i;
    for (const std::size_t other :
         {of_a.emplace(crossing_a_[i], i).first->second, of_b.emplace(crossing_b_[i], i).first->second}) {
      const std::size_t one = root(i), two = root(other);
      region[std::max(one, two)] = std::min(one, two);
    }
  }
  std::vector<double> most(overlaps_.size(), 0);
  for (std::size_t i = 0; i < overlaps_.size(); ++i) most[root(i)] = std::max(most[root(i)], overlaps_[i]);
  return std::accumulate(most.begin(), most.end(), 0.0);
}

}  // namespace brunt::depth
