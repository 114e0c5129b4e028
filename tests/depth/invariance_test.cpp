// SPDX-License-Identifier: Apache-2.0
// The same question asked otherwise (section E of the reference): moved file coordinates, another order of points and
// triangles, refined surfaces, bodies exchanged.
#include <fmt/core.h>

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <map>

#include "brunt/depth/penetration_depth.hpp"
#include "tests/support/depth_bodies.hpp"
#include "tests/support/random_motion.hpp"

using namespace brunt;

namespace {

constexpr std::array<depth::Metric, 3> metrics{depth::Metric::translation, depth::Metric::displacement,
                                               depth::Metric::object_norm};
constexpr std::array<const char*, 3> names{"PDt", "DISP", "rms"};

struct Question {
  TriangleSurface a, b;
  Placement pose;
};

TriangleSurface placed(TriangleSurface surface, const Placement& placement) {
  for (Vec3& x : surface.points) x = placement(x);
  return surface;
}

Question with_moved_a(const Question& q, const Placement& file) {
  Placement pose;
  pose.rotation = q.pose.rotation * file.rotation.transpose();
  pose.translation = q.pose.translation - pose.rotation * file.translation;
  return {placed(q.a, file), q.b, pose};
}

Question with_moved_b(const Question& q, const Placement& file) {
  return {q.a, placed(q.b, file), {file.rotation * q.pose.rotation, file(q.pose.translation)}};
}

Question exchanged(const Question& q) {
  const Mat3 back = q.pose.rotation.transpose();
  return {q.b, q.a, {back, -(back * q.pose.translation)}};
}

/// Other numbers of points, another order of triangles, another first corner of each.
TriangleSurface shuffled(const TriangleSurface& surface, std::mt19937_64& random) {
  std::vector<LocalIndex> place(surface.points.size());
  for (std::size_t i = 0; i < place.size(); ++i) place[i] = static_cast<LocalIndex>(i);
  std::shuffle(place.begin(), place.end(), random);
  TriangleSurface other = surface;
  for (std::size_t i = 0; i < place.size(); ++i) other.points[static_cast<std::size_t>(place[i])] = surface.points[i];
  for (auto& triangle : other.triangles) {
    for (LocalIndex& corner : triangle) corner = place[static_cast<std::size_t>(corner)];
    std::rotate(triangle.begin(), triangle.begin() + static_cast<std::ptrdiff_t>(random() % 3), triangle.end());
  }
  std::shuffle(other.triangles.begin(), other.triangles.end(), random);
  return other;
}

/// Each triangle cut in four at the middles of its edges.
TriangleSurface refined(const TriangleSurface& surface) {
  TriangleSurface fine{surface.points, {}};
  std::map<std::pair<LocalIndex, LocalIndex>, LocalIndex> middles;
  const auto middle = [&](LocalIndex i, LocalIndex j) {
    const auto [at, fresh] = middles.emplace(std::minmax(i, j), static_cast<LocalIndex>(fine.points.size()));
    if (fresh)
      fine.points.push_back(
          0.5 * (surface.points[static_cast<std::size_t>(i)] + surface.points[static_cast<std::size_t>(j)]));
    return at->second;
  };
  for (const auto& t : surface.triangles) {
    const LocalIndex m01 = middle(t[0], t[1]), m12 = middle(t[1], t[2]), m20 = middle(t[2], t[0]);
    fine.triangles.push_back({t[0], m01, m20});
    fine.triangles.push_back({m01, t[1], m12});
    fine.triangles.push_back({m20, m12, t[2]});
    fine.triangles.push_back({m01, m12, m20});
  }
  return fine;
}

/// Two answers to the same question, metric by metric.
struct Differences {
  std::array<double, 3> most{};                        ///< relative, of the depths that are the same minimum
  std::array<int, 3> other{};                          ///< another local minimum: the depths differ by more than `same`
  double bound = 0;                                    ///< the greatest relative one of the bounds
  int poses = 0, apart = 0;                            ///< apart: one's bound lies above the other's depth
  static constexpr std::array same{1e-6, 1e-6, 1e-6};  ///< twice the accuracy of the fast mode's contact
};

depth::Answer answer_of(const depth::Body& a, const depth::Body& b, const Placement& pose, depth::Metric metric,
                        bool careful) {
  depth::Query query;
  query.a_in_b = pose;
  query.metric = metric;
  query.careful = careful;
  return depth::penetration_depth(a, b, query);
}

void compare(const Question& one, const Question& other, bool careful, std::size_t metric_count, Differences& sum) {
  const depth::Body a = depth::make_body(one.a), b = depth::make_body(one.b);
  const depth::Body other_a = depth::make_body(other.a), other_b = depth::make_body(other.b);
  ++sum.poses;
  for (std::size_t m = 0; m < metric_count; ++m) {
    const depth::Answer first = answer_of(a, b, one.pose, metrics[m], careful);
    const depth::Answer second = answer_of(other_a, other_b, other.pose, metrics[m], careful);
    const double change = std::abs(second.depth / first.depth - 1);
    if (change > Differences::same[m])
      ++sum.other[m];
    else
      sum.most[m] = std::max(sum.most[m], change);
    if (std::getenv("SHOW")) fmt::print("  {} {:.9f} {:.9f} {:.2g}\n", names[m], first.depth, second.depth, change);
    sum.bound = std::max(sum.bound, std::abs(second.bound / first.bound - 1));
    const double slack = 1 + 1e-6;  // both answers keep a clearance
    sum.apart += first.bound > second.depth * slack || second.bound > first.depth * slack ? 1 : 0;
  }
}

void print(const char* what, bool careful, const Differences& d) {
  fmt::print("{:22} {:7} {} poses: ", what, careful ? "careful" : "fast", d.poses);
  for (std::size_t m = 0; m < 3; ++m) fmt::print("{} {:.1e} ({} others), ", names[m], d.most[m], d.other[m]);
  fmt::print("bounds {:.1e}, brackets apart {}\n", d.bound, d.apart);
}

/// Random overlapping poses of the three pairs.
std::vector<Question> questions(int a_pair, std::uint64_t seed) {
  const TriangleSurface as[] = {test::l_shape(), test::pawn(), test::mallet()};
  const TriangleSurface bs[] = {test::knot(), test::hub(), test::bumpy_sphere()};
  std::vector<Question> all;
  for (std::size_t pair = 0; pair < 3; ++pair) {
    const auto a = geometry::build_slab_tree(as[pair]), b = geometry::build_slab_tree(bs[pair]);
    std::mt19937_64 random(seed);
    for (int found = 0; found < a_pair;) {
      const Placement pose = test::random_placement(as[pair], bs[pair], random, 0.8);
      if (!geometry::surfaces_cross(a, b, pose)) continue;
      all.push_back({as[pair], bs[pair], pose});
      ++found;
    }
  }
  return all;
}

using Change = Question (*)(const Question&, std::mt19937_64&);

Placement random_file(std::mt19937_64& random) {
  const Mat3 turn = test::uniform_rotation(random);
  return {turn, test::uniform_rotation(random) * Vec3(2, 0, 0)};
}
Question moved_a(const Question& q, std::mt19937_64& random) {
  return with_moved_a(q, random_file(random));
}
Question moved_b(const Question& q, std::mt19937_64& random) {
  return with_moved_b(q, random_file(random));
}
Question other_order(const Question& q, std::mt19937_64& random) {
  return {shuffled(q.a, random), shuffled(q.b, random), q.pose};
}
Question finer(const Question& q, std::mt19937_64& /*random*/) {
  return {refined(q.a), refined(q.b), q.pose};
}
Question other_way(const Question& q, std::mt19937_64& /*random*/) {
  return exchanged(q);
}

Differences differences(const char* what, Change change, const std::vector<Question>& all, bool careful,
                        std::size_t metric_count = 3) {
  Differences sum;
  std::mt19937_64 random(3);
  for (const Question& question : all) compare(question, change(question, random), careful, metric_count, sum);
  print(what, careful, sum);
  return sum;
}

}  // namespace

TEST_CASE("table of invariances", "[.][table]") {
  const int poses = std::getenv("POSES") ? std::atoi(std::getenv("POSES")) : 4;
  const std::vector<Question> all = questions(poses, 5);
  for (const bool careful : {false, true}) {
    differences("A's file moved", moved_a, all, careful);
    differences("B's file moved", moved_b, all, careful);
    differences("order", other_order, all, careful);
    differences("refined", finer, all, careful);
    differences("exchanged", other_way, all, careful, 1);
  }
}
