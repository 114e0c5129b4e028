// SPDX-License-Identifier: Apache-2.0
#include "search_facets.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <fstream>
#include <sstream>

#include "app/program/failure.hpp"
#include "contact/lists/ghosting.hpp"
#include "contact/search/facet_tree.hpp"
#include "core/error.hpp"

namespace brunt::app {
namespace {

using contact::FacetNodes;
using contact::KdopTree;

/// A facet that travels with its corners.
struct TextFacet {
  GlobalIndex id = 0;  ///< in the file
  contact::PlainBox capture;
  std::array<std::array<double, 3>, 4> corners{};  ///< of a triangle the third twice
  friend bool operator<(const TextFacet& a, const TextFacet& b) { return a.id < b.id; }
};

struct FacetScene {
  GlobalIndex nodes = 0;
  double distance = 0;
  std::array<std::vector<TextFacet>, 2> sides;  ///< slave, master
};

TextFacet facet_of(GlobalIndex id, const std::array<GlobalIndex, 4>& corners, const std::vector<Vec3>& nodes,
                   double distance) {
  TextFacet facet{.id = id, .capture = {}, .corners = {}};
  geometry::Box box;
  for (std::size_t i = 0; i < 4; ++i) {
    const GlobalIndex corner = corners[i] < 0 ? corners[2] : corners[i];
    const Vec3& x = nth(nodes, corner);
    extend(box, x);
    facet.corners[i] = {x[0], x[1], x[2]};
  }
  const Vec3 margin = Vec3::Constant(distance);
  facet.capture = contact::PlainBox({box.low - margin, box.high + margin});
  return facet;
}

FacetScene read_facet_scene(const std::string& path) {
  std::ifstream in(path);
  std::string first_line, format, name;
  std::getline(in, first_line);
  std::istringstream header(first_line);
  long long n = -1, m = -1;
  FacetScene scene;
  constexpr long long most = 2000000000;
  if (!(header >> format >> name >> n >> m >> scene.distance) || n < 0 || m < 0 || n > most || m > most ||
      scene.distance < 0)
    throw InputError(path + ":1: invalid scene of facets; expected facets1 NAME n m d, with a distance d >= 0");
  const auto fault = [&](long long line, const char* expected) {
    return InputError(fmt::format("{}:{}: invalid line; expected {}", path, line, expected));
  };
  scene.nodes = n;
  std::vector<Vec3> nodes;
  for (long long i = 0; i < n; ++i) {
    Vec3& x = nodes.emplace_back();
    if (!(in >> x[0] >> x[1] >> x[2])) throw fault(i + 2, "three finite coordinates x y z");
  }
  for (long long i = 0; i < m; ++i) {
    long long side = -1;
    std::array<GlobalIndex, 4> corners{};
    if (!(in >> side >> corners[0] >> corners[1] >> corners[2] >> corners[3]) || side < 0 || side > 1)
      throw fault(n + i + 2, "side n0 n1 n2 n3, with the side 0 (slave) or 1 (master)");
    for (std::size_t k = 0; k < 4; ++k)
      if (corners[k] >= n || corners[k] < (k == 3 ? -1 : 0))
        throw fault(n + i + 2, "node ids from 0 to n - 1, with -1 as the last one of a triangle");
    nth(scene.sides, side).push_back(facet_of(i, corners, nodes, scene.distance));
  }
  return scene;
}

/// Each side in blocks over the ranks.
FacetScene deal_scene(const comm::Communicator& ranks, const FacetScene& whole) {
  FacetScene scene{.nodes = ranks.max(whole.nodes), .distance = ranks.max(whole.distance), .sides = {}};
  for (const std::size_t side : {0, 1}) {
    const auto count = ranks.max(static_cast<GlobalIndex>(whole.sides[side].size()));
    scene.sides[side] = deal(ranks, whole.sides[side], comm::BlockLayout{count, ranks.size()});
  }
  return scene;
}

std::vector<geometry::Box> boxes_of(const std::vector<TextFacet>& facets) {
  std::vector<geometry::Box> boxes;
  for (const TextFacet& facet : facets) boxes.push_back(facet.capture.box());
  return boxes;
}

/// Adds the master facets of other ranks that share a cell with a slave facet of this one; in the order of the file.
Traffic add_ghosts(const comm::Communicator& ranks, FacetScene& scene) {
  auto& [slaves, masters] = scene.sides;
  const std::vector<geometry::Box> offered = boxes_of(masters), wanted = boxes_of(slaves);
  const double finest = contact::finest_cell(ranks, offered);
  Traffic traffic;
  std::vector<std::vector<TextFacet>> outgoing;
  for (const std::vector<LocalIndex>& leaving : contact::meet_in_cells(ranks, offered, wanted, finest)) {
    outgoing.emplace_back();
    for (const LocalIndex i : leaving) outgoing.back().push_back(nth(masters, i));
    traffic.messages += leaving.empty() ? 0 : 1;
    traffic.bytes += static_cast<GlobalIndex>(leaving.size() * sizeof(TextFacet));
  }
  const std::vector<TextFacet> ghosts = comm::exchange(ranks, outgoing).values;
  masters.insert(masters.end(), ghosts.begin(), ghosts.end());
  std::sort(masters.begin(), masters.end());
  return {ranks.max(static_cast<GlobalIndex>(ghosts.size())), ranks.max(traffic.messages), ranks.max(traffic.bytes)};
}

/// Facets that have four positions each of their own.
struct LooseFacets {
  std::vector<FacetNodes> facets;
  std::vector<Vec3> positions;

  void add(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
    const auto first = static_cast<LocalIndex>(positions.size());
    facets.push_back({first, first + 1, first + 2, first + 3});
    positions.insert(positions.end(), {a, b, c, d});
  }
};

LooseFacets loose(const std::vector<TextFacet>& facets) {
  LooseFacets all;
  for (const TextFacet& facet : facets) {
    const auto at = [&](std::size_t i) { return Vec3(facet.corners[i].data()); };
    all.add(at(0), at(1), at(2), at(3));
  }
  return all;
}

struct Sides {
  LooseFacets slave, master;
};

Timing find_by_trees(const Sides& sides, const contact::Enlargement& by, std::vector<contact::FacetPair>& pairs) {
  KdopTree slave, master;
  contact::TraversalScratch scratch;
  std::int64_t tests = 0;
  Timing timing = timed(
      [&] {
        contact::build<9>(slave, sides.slave.facets, sides.slave.positions);
        contact::build<9>(master, sides.master.facets, sides.master.positions);
      },
      [&] {
        contact::refit<9>(slave, sides.slave.positions, by);
        contact::refit<9>(master, sides.master.positions, by);
        tests = contact::find_pairs(slave, master, scratch, pairs).tests;
      });
  timing.memory = slave.memory_bytes() + master.memory_bytes();
  timing.tests = tests;
  return timing;
}

}  // namespace

bool is_facet_scene(const std::string& path) {
  std::string format;
  std::ifstream in(path);
  return in >> format && format == "facets1";
}

SearchResult search_facets(const comm::Communicator& ranks, const SearchOptions& options) {
  FacetScene whole;
  on_root(ranks, [&] {
    if (options.method != "kdop")
      throw InputError(
          fmt::format("{}:1: invalid --method {} for facets; expected --method kdop", options.file, options.method));
    whole = read_facet_scene(options.file);
  });
  const FacetScene dealt = deal_scene(ranks, whole);
  const auto facets = static_cast<GlobalIndex>(whole.sides[0].size() + whole.sides[1].size());
  SearchResult result{.nodes = dealt.nodes, .faces = ranks.max(facets), .found = {}, .best = {}, .traffic = {}};
  std::vector<contact::FacetPair> pairs;
  for (int k = 0; k < options.repeat; ++k) {
    FacetScene scene = dealt;
    const Clock::time_point start = Clock::now();
    result.traffic = add_ghosts(ranks, scene);
    const double meeting = Seconds(Clock::now() - start).count();
    const auto& [slaves, masters] = scene.sides;
    Timing timing = find_by_trees({loose(slaves), loose(masters)}, contact::by_distance(scene.distance), pairs);
    timing.build = ranks.max(timing.build + meeting);
    timing.query = ranks.max(timing.query);
    if (k == 0 || timing.total() < result.best.total()) result.best = timing;
    if (k > 0) continue;
    for (const auto& [slave, master] : pairs) result.found.push_back({nth(slaves, slave).id, nth(masters, master).id});
  }
  return result;
}

Timing search_boxes_by_trees(std::span<const Vec3> points, std::span<const geometry::Box> boxes,
                             Ragged<LocalIndex>& pairs) {
  Sides sides;
  for (const Vec3& x : points) sides.slave.add(x, x, x, x);
  std::vector<LocalIndex> box_of;
  for (std::size_t b = 0; b < boxes.size(); ++b) {
    const auto& [low, high] = boxes[b];
    if (!(low.array() <= high.array()).all()) continue;  // it holds nothing
    // these four corners have the greatest and the least projection of all eight along each slab
    sides.master.add(low, {low[0], high[1], high[2]}, {high[0], low[1], high[2]}, {high[0], high[1], low[2]});
    box_of.push_back(static_cast<LocalIndex>(b));
  }
  std::vector<contact::FacetPair> found;
  Timing timing = find_by_trees(sides, {}, found);
  pairs.clear();
  auto pair = found.begin();
  for (LocalIndex p = 0; p < static_cast<LocalIndex>(points.size()); ++p) {
    for (; pair != found.end() && pair->slave == p; ++pair) pairs.values.push_back(nth(box_of, pair->master));
    pairs.close_row();
  }
  return timing;
}

}  // namespace brunt::app
