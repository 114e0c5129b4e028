// SPDX-License-Identifier: Apache-2.0
#include "search_scenes.hpp"

#include <algorithm>
#include <cmath>
#include <random>
#include <span>
#include <stdexcept>

namespace brunt::bench {
namespace {

constexpr std::array<LocalIndex, 4> no_nodes{-1, -1, -1, -1};

/// A rotation in general position: 0.3 about x, 0.5 about y, 0.7 about z.
Vec3 turn(const Vec3& v) {
  const double c1 = std::cos(.3), s1 = std::sin(.3), c2 = std::cos(.5), s2 = std::sin(.5);
  const double c3 = std::cos(.7), s3 = std::sin(.7);
  const Vec3 a(v[0], c1 * v[1] - s1 * v[2], s1 * v[1] + c1 * v[2]);
  const Vec3 b(c2 * a[0] + s2 * a[2], a[1], -s2 * a[0] + c2 * a[2]);
  return {c3 * b[0] - s3 * b[1], s3 * b[0] + c3 * b[1], b[2]};
}

SearchScene named(const std::string& name) {
  SearchScene scene;
  scene.name = name;
  return scene;
}

double to_float(double x) {
  return static_cast<double>(static_cast<float>(x));
}

geometry::Box rounded(const geometry::Box& box) {
  return {box.low.unaryExpr(&to_float), box.high.unaryExpr(&to_float)};
}

void add_face(SearchScene& scene, const std::array<Vec3, 4>& corners, double capture,
              const std::array<LocalIndex, 4>& own = no_nodes) {
  scene.boxes.push_back(rounded(geometry::grown(geometry::bounding_box(corners), capture)));
  scene.own.push_back(own);
}

SearchScene finished(SearchScene scene) {
  for (Vec3& node : scene.nodes) node = node.unaryExpr(&to_float);
  return scene;
}

using Random = std::mt19937_64;

Vec3 random_place(Random& random) {
  std::uniform_real_distribution<double> unit(0, 1);
  Vec3 x;
  for (double& c : x) c = unit(random);
  return x;
}

/// Point on the outline of a square of side `width`, t in laps.
std::array<double, 2> on_square(double t, double width) {
  const double q = 4 * (t - std::floor(t)), r = q - std::floor(q) - 0.5, half = width / 2;
  switch (static_cast<int>(q)) {
    case 0:
      return {2 * half * r, -half};
    case 1:
      return {half, 2 * half * r};
    case 2:
      return {-2 * half * r, half};
    default:
      return {-half, -2 * half * r};
  }
}

/// Nodes on a lattice of a square, lines at the given coordinates.
void add_lattice(SearchScene& scene, std::span<const double> lines, bool turned) {
  for (const double y : lines)
    for (const double x : lines) scene.nodes.push_back(turned ? turn({x, y, 0}) : Vec3(x, y, 0));
}

/// Faces between such lines at height z.
void add_faces(SearchScene& scene, std::span<const double> lines, double z, double capture, bool turned) {
  const auto place = [&](double x, double y) { return turned ? turn({x, y, z}) : Vec3(x, y, z); };
  for (std::size_t j = 0; j + 1 < lines.size(); ++j)
    for (std::size_t i = 0; i + 1 < lines.size(); ++i)
      add_face(scene,
               {place(lines[i], lines[j]), place(lines[i + 1], lines[j]), place(lines[i + 1], lines[j + 1]),
                place(lines[i], lines[j + 1])},
               capture);
}

std::vector<double> even_lines(std::size_t intervals) {
  std::vector<double> lines(intervals + 1);
  for (std::size_t i = 0; i <= intervals; ++i)
    lines[i] = static_cast<double>(i) * (1.0 / static_cast<double>(intervals));
  return lines;
}

std::size_t lattice_side(std::size_t node_count) {
  return static_cast<std::size_t>(std::lround(std::sqrt(static_cast<double>(node_count))));
}

}  // namespace

SearchScene plates(std::size_t node_count, bool turned) {
  SearchScene scene = named(turned ? "plates turned" : "plates");
  const std::size_t side = lattice_side(node_count);
  const double h = 1.0 / static_cast<double>(side - 1);
  add_lattice(scene, even_lines(side - 1), turned);
  add_faces(scene, even_lines(static_cast<std::size_t>(std::lround(0.93 * static_cast<double>(side)))), 0.05 * h,
            0.1 * h, turned);
  return finished(std::move(scene));
}

SearchScene crumple(std::size_t node_count) {
  SearchScene scene = named("crumple");
  const std::size_t side = lattice_side(node_count);
  constexpr int layers = 40;
  const double h = 1.0 / static_cast<double>(side - 1), period = 1.0 / layers;
  Random random(12345);
  for (std::size_t j = 0; j < side; ++j)
    for (std::size_t i = 0; i < side; ++i) {
      const double u = static_cast<double>(i) * h, v = static_cast<double>(j) * h;
      const int layer = std::min(layers - 1, static_cast<int>(u / period));
      const double t = u - layer * period, height = layer % 2 == 1 ? period - t : t;
      const double bent = height * (1 + 0.15 * std::sin(9 * v + 0.4 * layer));
      const double x = 0.6 * h * (layer + t / period) + (0.08 * std::sin(7 * v) + 0.05 * std::sin(60 * bent));
      const double z = bent + 0.03 * std::sin(11 * v);
      constexpr double radius = 0.4;
      const double angle = v / radius * 0.9;
      const Vec3 place = turn({(radius + x) * std::cos(angle), (radius + x) * std::sin(angle), z});
      scene.nodes.push_back(place + 0.1 * h * (random_place(random).array() - 0.5).matrix());
    }
  for (std::size_t j = 0; j + 1 < side; ++j)
    for (std::size_t i = 0; i + 1 < side; ++i) {
      const std::array<std::size_t, 4> n{j * side + i, j * side + i + 1, (j + 1) * side + i + 1, (j + 1) * side + i};
      std::array<LocalIndex, 4> own{};
      std::array<Vec3, 4> corners;
      for (std::size_t c = 0; c < 4; ++c) {
        own[c] = static_cast<LocalIndex>(n[c]);
        corners[c] = scene.nodes[n[c]];
      }
      add_face(scene, corners, 0.3 * h, own);
    }
  return finished(std::move(scene));
}

SearchScene random_volume(std::size_t node_count) {
  SearchScene scene = named("random");
  Random random(12345);
  const double h = std::cbrt(1.0 / static_cast<double>(node_count));
  for (std::size_t i = 0; i < node_count; ++i) scene.nodes.push_back(random_place(random));
  for (std::size_t i = 0; i < node_count; ++i) {
    const Vec3 centre = random_place(random), half = h / 2 * (random_place(random).array() + 0.5);
    scene.boxes.push_back(rounded({centre - half, centre + half}));
  }
  scene.own.assign(node_count, no_nodes);
  return finished(std::move(scene));
}

SearchScene rod(std::size_t node_count) {
  SearchScene scene = named("rod");
  constexpr double width = 1e-3;
  const auto around =
      static_cast<std::size_t>(std::max(4L, 4 * std::lround(std::sqrt(width * static_cast<double>(node_count) / 4))));
  const double h = 4 * width / static_cast<double>(around);
  const std::size_t along = std::max<std::size_t>(2, (node_count - 24) / around);
  const double spacing = 1.0 / static_cast<double>(along - 1);
  for (std::size_t i = 0; i < along; ++i)
    for (std::size_t c = 0; c < around; ++c) {
      const auto q = on_square((static_cast<double>(c) + .5) / static_cast<double>(around), width);
      scene.nodes.push_back(turn({static_cast<double>(i) * spacing, q[0], q[1]}));
    }
  const double capture = 0.1 * std::max(h, spacing), sleeve = width + 0.1 * h;
  const auto faces_along = static_cast<std::size_t>(0.93 * static_cast<double>(along - 1));
  const double length = 1.0 / static_cast<double>(faces_along);
  for (std::size_t i = 0; i < faces_along; ++i)
    for (std::size_t c = 0; c < around; ++c) {
      const auto q = on_square(static_cast<double>(c) / static_cast<double>(around), sleeve);
      const auto r = on_square((static_cast<double>(c) + 1.0) / static_cast<double>(around) - 1e-9, sleeve);
      const double x = static_cast<double>(i) * length, y = static_cast<double>(i + 1) * length;
      add_face(scene, {turn({x, q[0], q[1]}), turn({y, q[0], q[1]}), turn({y, r[0], r[1]}), turn({x, r[0], r[1]})},
               capture);
    }
  Random random(12345);
  for (int i = 0; i < 24; ++i) {
    const Vec3 far = 1000 * (2 * random_place(random).array() - 1);
    scene.nodes.push_back(far);
    add_face(scene, {far, far + Vec3(h, h, 0), far, far}, capture);
  }
  return finished(std::move(scene));
}

SearchScene graded(std::size_t node_count) {
  SearchScene scene = named("graded");
  const auto lines_of = [](std::size_t intervals) {
    std::vector<double> lines(intervals + 1);
    for (std::size_t i = 0; i <= intervals; ++i)
      lines[i] = (std::pow(1000.0, static_cast<double>(i) / static_cast<double>(intervals)) - 1) / 999;
    return lines;
  };
  const std::size_t side = lattice_side(node_count);
  add_lattice(scene, lines_of(side - 1), true);
  add_faces(scene, lines_of(static_cast<std::size_t>(std::lround(0.93 * static_cast<double>(side)))), 0,
            1e-4 / static_cast<double>(side), true);
  return finished(std::move(scene));
}

SearchScene flat(std::size_t node_count) {
  SearchScene scene = named("flat");
  const std::size_t side = lattice_side(node_count);
  add_lattice(scene, even_lines(side - 1), true);
  add_faces(scene, even_lines(side - 1), 0, 0, true);
  return finished(std::move(scene));
}

SearchScene one_place(std::size_t node_count) {
  SearchScene scene = random_volume(node_count);
  scene.name = "one place";
  const Vec3 place = Vec3(0.5, 0.25, 0.75);
  for (std::size_t i = 0; i < node_count; i += 3) scene.nodes[i] = place;
  for (std::size_t b = 0; b < scene.boxes.size(); ++b)
    if (b > 0 && geometry::contains(scene.boxes[b], place)) scene.boxes[b] = {Vec3::Zero(), Vec3::Zero()};
  scene.boxes[0] = {place.array() - 0.0078125, place.array() + 0.0078125};
  return scene;
}

SearchScene clusters(std::size_t node_count) {
  SearchScene scene = random_volume(node_count);
  scene.name = "clusters";
  const Vec3 far(1e6, -1e6, 1e6);
  Random random(7);
  const auto moved = [&](std::size_t i, const Vec3& x) { return i % 2 == 0 ? Vec3(x + far) : Vec3(1e-3 * x - far); };
  for (std::size_t i = 0; i < node_count; ++i) {
    scene.nodes[i] = moved(i, scene.nodes[i]);
    scene.boxes[i] = {moved(i, scene.boxes[i].low), moved(i, scene.boxes[i].high)};
  }
  for (std::size_t i = 0; i < 100; ++i) {
    const Vec3 x = 1e6 * (2 * random_place(random).array() - 1);
    scene.nodes.push_back(x);
    scene.boxes.push_back({x.array() - 1, x.array() + 1});
    scene.own.push_back(no_nodes);
  }
  return scene;
}

SearchScene moved(SearchScene scene, double by) {
  double edge = 0;
  for (const geometry::Box& box : scene.boxes) edge += (box.high - box.low).maxCoeff();
  edge /= static_cast<double>(std::max<std::size_t>(1, scene.boxes.size()));
  Random random(99);
  const auto motion = [&](const Vec3& x) {  // smooth for the most part
    const Vec3 wave(std::sin(7 * x.y() + 1), std::sin(5 * x.z() + 2), std::sin(6 * x.x()));
    return Vec3(by * edge * (0.5 * wave.array() + 0.2 * (random_place(random).array() - 0.5)));
  };
  for (Vec3& node : scene.nodes) node += motion(node);
  for (geometry::Box& box : scene.boxes) {
    const Vec3 u = motion(0.5 * (box.low + box.high));
    box = {box.low + u, box.high + u};
  }
  return scene;
}

SearchScene scene_by_name(const std::string& name, std::size_t node_count) {
  if (name == "plates") return plates(node_count, false);
  if (name == "turned") return plates(node_count, true);
  if (name == "crumple") return crumple(node_count);
  if (name == "random") return random_volume(node_count);
  if (name == "rod") return rod(node_count);
  if (name == "graded") return graded(node_count);
  if (name == "flat") return flat(node_count);
  if (name == "place") return one_place(node_count);
  if (name == "clusters") return clusters(node_count);
  throw std::invalid_argument("no scene " + name);
}

}  // namespace brunt::bench
