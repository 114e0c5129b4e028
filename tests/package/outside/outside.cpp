// SPDX-License-Identifier: Apache-2.0
// What another program may do with Brunt: search, penetration depth, a step of contact, a scene. Prints figures with
// names; package_test.py judges them.
#include <algorithm>
#include <array>
#include <brunt/contact_step.hpp>
#include <brunt/penetration_depth.hpp>
#include <brunt/run.hpp>
#include <brunt/search.hpp>
#include <brunt/session.hpp>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <limits>
#include <span>
#include <stdexcept>
#include <vector>

namespace {

using namespace brunt;

int rank_of_this() {
  int rank = 0;
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  return rank;
}
int count_of_ranks() {
  int count = 1;
  MPI_Comm_size(MPI_COMM_WORLD, &count);
  return count;
}

void tell(const char* name, double value) {
  if (rank_of_this() == 0) std::printf("%s %.17g\n", name, value);
}

/// Points 0.5, 1.5, ... of this rank's tenth on a line, boxes [k, k + 1] of all; so point k + 1/2 lies in box k.
void search() {
  const int per_rank = 10, rank = rank_of_this(), count = count_of_ranks();
  std::vector<double> points, boxes;
  for (int k = 0; k < per_rank; ++k) {
    const double place = k * count + rank;  // dealt out by turns, boxes in rows
    points.insert(points.end(), {place + 0.5, 0, 0});
    const double low = rank * per_rank + k;
    boxes.insert(boxes.end(), {low, -1, -1, low + 1, 1, 1});
  }
  for (const api::SearchMethod method :
       {api::SearchMethod::blocks, api::SearchMethod::binary, api::SearchMethod::bucket}) {
    const api::PointsInBoxes found = api::find_points_in_boxes(MPI_COMM_WORLD, points, boxes, method);
    int right = found.first.size() == per_rank + 1 ? 0 : -1000;
    for (int k = 0; k < per_rank; ++k) right += found.first[k + 1] == k + 1 && found.box[k] == k * count + rank ? 1 : 0;
    int all = 0;
    MPI_Allreduce(&right, &all, 1, MPI_INT, MPI_SUM, MPI_COMM_WORLD);
    tell("search_right", static_cast<double>(all) / (per_rank * count));
  }
  // one endless box of the last rank, an empty one and one of no number; a point of no number, one far away, one in the
  // middle
  const double none = std::numeric_limits<double>::quiet_NaN(), endless = std::numeric_limits<double>::infinity();
  const std::vector<double> odd{-endless, -endless, -endless, endless, endless, endless, 1,       1,
                                1,        0,        0,        0,       none,    0,       0,       1,
                                1,        1,        -endless, endless, 0,       endless, endless, 1};
  const api::PointsInBoxes found =
      api::find_points_in_boxes(MPI_COMM_WORLD, std::vector<double>{none, 0, 0, 1e200, 0, 0, 0.5, 0.5, 0.5},
                                rank == count - 1 ? odd : std::vector<double>{});
  const bool right =
      found.first == std::vector<std::int64_t>{0, 0, 1, 2} && found.box == std::vector<std::int64_t>{0, 0};
  int everywhere = 0;
  const int here = right ? 1 : 0;
  MPI_Allreduce(&here, &everywhere, 1, MPI_INT, MPI_MIN, MPI_COMM_WORLD);
  tell("search_odd", everywhere);
}

/// Two unit cubes, one 0.9 above the other: 0.1 apart after the motion.
void depth() {
  std::vector<double> points;
  for (int k = 0; k < 8; ++k) points.insert(points.end(), {double(k % 2), double(k / 2 % 2), double(k / 4)});
  const std::vector<std::int32_t> triangles{0, 2, 1, 1, 2, 3, 4, 5, 6, 5, 7, 6, 0, 1, 4, 1, 5, 4,
                                            2, 6, 3, 3, 6, 7, 0, 4, 2, 2, 4, 6, 1, 3, 5, 3, 7, 5};
  const api::DepthBody cube(points, triangles);
  api::Placement above;
  above.translation = {0.01, 0.02, 0.9};
  const api::DepthAnswer answer = api::penetration_depth(cube, cube, above, api::Metric::translation);
  tell("depth", answer.depth);
  tell("depth_bound", answer.bound);
  tell("depth_moved", answer.placement.translation[2]);
  bool refused = false;
  try {
    const api::DepthBody open(points, std::span(triangles).first(33));
  } catch (const std::invalid_argument&) {
    refused = true;
  }
  tell("depth_refused", refused ? 1 : 0);
}

/// Two cubes of eight mass points each, the upper one at speed -1 on the lower one at rest: they meet in the first step
/// and go on together at half of the speed. The upper cube is on the last rank, the lower one on the first.
void contact() {
  const int rank = rank_of_this(), last = count_of_ranks() - 1;
  api::ContactMesh mesh;
  const auto add_cube = [&](std::int64_t number, double low) {
    const std::array<std::array<double, 3>, 8> corner{
        {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}}};
    for (std::int64_t c = 7; c >= 0; --c) {  // in any order
      mesh.node_number.push_back(100 + 8 * number + c);
      mesh.position.insert(mesh.position.end(), {corner[c][0], corner[c][1], low + corner[c][2]});
      mesh.mass.push_back(0.25);
    }
    const auto first = static_cast<std::int32_t>(mesh.node_number.size()) - 8;
    for (std::int32_t c = 0; c < 8; ++c) mesh.corner.push_back(first + 7 - c);
    mesh.element_number.push_back(number);
    mesh.part.push_back(static_cast<std::int32_t>(number));
  };
  if (rank == 0) add_cube(0, 0);
  if (rank == last) add_cube(1, 1.005);
  api::ContactStep step(MPI_COMM_WORLD, mesh);
  std::vector<double> position = mesh.position, before(position.size()), velocity, impulse(position.size());
  for (std::size_t n = 0; n < mesh.node_number.size(); ++n)
    if (mesh.node_number[n] >= 108) before[3 * n + 2] = -1;
  const double dt = 0.01;
  std::array<double, 3> sums{}, all{};  // momentum, impulse on the upper cube, impulse on both
  std::int64_t active = 0;
  for (int k = 0; k < 3; ++k) {
    velocity = before;
    active = std::max(active, step.correct(position, before, velocity, dt, impulse).active);
    for (std::size_t n = 0; n < mesh.node_number.size(); ++n) {
      sums[1] += mesh.node_number[n] >= 108 ? impulse[3 * n + 2] : 0;
      sums[2] += impulse[3 * n + 2];
    }
    for (std::size_t i = 0; i < position.size(); ++i) position[i] += dt * velocity[i];
    before = velocity;
  }
  double slowest = 1, fastest = -1;
  for (std::size_t n = 0; n < mesh.node_number.size(); ++n) sums[0] += mesh.mass[n] * velocity[3 * n + 2];
  // of the four nodes on each side of the seam
  for (std::size_t n = 0; n < mesh.node_number.size(); ++n) {
    const std::int64_t c = (mesh.node_number[n] - 100) % 8;
    if ((mesh.node_number[n] >= 108) == (c >= 4)) continue;
    slowest = std::min(slowest, velocity[3 * n + 2]);
    fastest = std::max(fastest, velocity[3 * n + 2]);
  }
  MPI_Allreduce(sums.data(), all.data(), 3, MPI_DOUBLE, MPI_SUM, MPI_COMM_WORLD);
  std::array<double, 2> range{-slowest, fastest}, most{};
  MPI_Allreduce(range.data(), most.data(), 2, MPI_DOUBLE, MPI_MAX, MPI_COMM_WORLD);
  tell("contact_momentum", all[0]);
  tell("contact_impulse", all[1]);
  tell("contact_impulses", all[2]);
  tell("contact_slowest", -most[0]);
  tell("contact_fastest", most[1]);
  tell("contact_active", static_cast<double>(active));
  bool refused = false;
  try {
    mesh.mass.push_back(1);
    const api::ContactStep wrong(MPI_COMM_WORLD, mesh);
  } catch (const std::invalid_argument&) {
    refused = true;
  }
  tell("contact_refused", refused ? 1 : 0);
}

}  // namespace

int main(int argc, char** argv) {
  const api::Session session(argc, argv);
  search();
  depth();
  contact();
  if (argc > 2)
    tell("run", api::run_scene(MPI_COMM_WORLD, {.scene = argv[1], .out = argv[2], .force = true, .quiet = true}));
  if (argc > 2)
    tell("run_wrong", api::run_scene(MPI_COMM_WORLD, {.scene = "none.yaml", .out = argv[2], .quiet = true}));
  return 0;
}
