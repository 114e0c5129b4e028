// SPDX-License-Identifier: Apache-2.0
// The search over ranks, ghosting and then pairs, against testing every node with every face: a thousand random scenes,
// each also moved away from the origin and with its nodes in another order.
#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <random>
#include <utility>

#include "contact/lists/ghosting.hpp"
#include "contact/search/box_overlaps.hpp"
#include "contact/search/search.hpp"

using namespace brunt;
using geometry::Box;

namespace {

/// Known whole to every rank, which holds its part of it.
struct Scene {
  std::vector<Vec3> nodes;
  std::vector<Box> faces;  ///< capture boxes
  std::vector<Rank> node_on, face_on;
};

/// What travels: as much of a face as the search needs.
struct Ghost {
  GlobalIndex id = 0;
  contact::PlainBox capture;
  friend bool operator<(const Ghost& a, const Ghost& b) { return a.id < b.id; }
};

/// Scenes of all kinds mixed by chance, the same on any number of ranks.
class Maker {
 public:
  Maker(unsigned seed, int ranks) : random_(seed), dealing_(seed + 1), last_(ranks - 1) {}

  Scene make() {
    Scene scene;
    const bool snapped = chance(2), planar = chance(5), crowded = chance(5), outliers = chance(5);
    const double grading = chance(3) ? 3 * unit() : 0, size = std::pow(10.0, -2 * unit());
    scene.nodes.resize(count(chance(10) ? 600 : 120));
    const auto axis = static_cast<int>(count(2));
    const Vec3 crowd = place(snapped);
    for (Vec3& node : scene.nodes) {
      node = place(snapped);
      if (planar) node[axis] = 0.25;
      if (crowded && chance(2)) node = crowd;
      if (outliers && chance(30)) node *= std::pow(10.0, 9 * unit());
    }
    scene.faces.resize(count(chance(10) ? 300 : 80));
    for (Box& face : scene.faces) face = box(scene.nodes, snapped, size * std::pow(10.0, -grading * unit()));
    deal_out(scene);
    return scene;
  }

  /// Nodes in another order on other ranks, faces as they were.
  void shuffle(Scene& scene) {
    std::shuffle(scene.nodes.begin(), scene.nodes.end(), random_);
    std::shuffle(scene.node_on.begin(), scene.node_on.end(), random_);
  }

  /// Edge of the smallest cells: as `brunt search` takes it, as Contact takes it, or one that fits badly.
  double finest(const comm::Communicator& ranks, std::span<const Box> own) {
    const double smallest = contact::finest_cell(ranks, own);
    const std::array edges{smallest, 0.05, 10.0, std::max(1e-3 * smallest, 1e-12)};
    return edges[dealing_() % edges.size()];
  }

 private:
  double unit() { return std::uniform_real_distribution<double>(0, 1)(random_); }
  std::size_t count(std::size_t most) { return std::uniform_int_distribution<std::size_t>(0, most)(random_); }
  bool chance(std::size_t one_in) { return count(one_in - 1) == 0; }

  /// In the unit cube; snapped, many coordinates are equal and nodes lie on borders of boxes and cells.
  Vec3 place(bool snapped) {
    Vec3 x;
    for (double& c : x) c = snapped ? std::floor(8 * unit()) / 8 : unit();
    return x;
  }

  /// A box in general position, a rod, a plane or a point; some start at a node.
  Box box(std::span<const Vec3> nodes, bool snapped, double size) {
    const Vec3 low = !nodes.empty() && chance(3) ? nodes[count(nodes.size() - 1)] : place(snapped);
    Vec3 extent = size * place(snapped);
    for (double& e : extent)
      if (chance(6)) e = 0;
    return chance(2) ? Box{low, low + extent} : Box{low - extent, low};
  }

  Rank any_rank(Rank first) { return std::uniform_int_distribution<Rank>(first, last_)(dealing_); }

  void deal_out(Scene& scene) {
    enum Deal { in_blocks, faces_apart, none_on_first, by_place, by_chance };
    const auto deal = static_cast<Deal>(dealing_() % 5);
    const auto rank_of = [&](std::size_t i, std::size_t all, double x, bool is_face) {
      if (deal == in_blocks) return static_cast<Rank>(i * static_cast<std::size_t>(last_ + 1) / all);
      if (deal == faces_apart) return is_face ? last_ : 0;
      if (deal == none_on_first) return any_rank(std::min(1, last_));
      if (deal == by_place) return x < 0.5 ? 0 : last_;
      return any_rank(0);
    };
    scene.node_on.resize(scene.nodes.size());
    scene.face_on.resize(scene.faces.size());
    for (std::size_t n = 0; n < scene.nodes.size(); ++n)
      scene.node_on[n] = rank_of(n, scene.nodes.size(), scene.nodes[n].x(), false);
    for (std::size_t f = 0; f < scene.faces.size(); ++f)
      scene.face_on[f] = rank_of(f, scene.faces.size(), scene.faces[f].low.x(), true);
  }

  std::mt19937 random_, dealing_;
  Rank last_;
};

Scene moved(Scene scene, double by) {
  for (Vec3& node : scene.nodes) node.array() += by;
  for (Box& face : scene.faces) face = {face.low.array() + by, face.high.array() + by};
  return scene;
}

using Pair = std::array<GlobalIndex, 2>;  ///< node, face

/// Nodes of this rank by id, and its faces followed by what the others send.
struct Part {
  std::vector<GlobalIndex> node_id;
  std::vector<Vec3> nodes;
  std::vector<Ghost> faces;
  std::vector<Box> boxes;  ///< of the faces
};

Part part_of(const comm::Communicator& ranks, const Scene& scene, Maker& maker) {
  Part part;
  std::vector<Box> wanted;
  for (std::size_t n = 0; n < scene.nodes.size(); ++n) {
    if (scene.node_on[n] != ranks.rank()) continue;
    part.node_id.push_back(static_cast<GlobalIndex>(n));
    part.nodes.push_back(scene.nodes[n]);
    wanted.push_back({scene.nodes[n], scene.nodes[n]});
  }
  for (std::size_t f = 0; f < scene.faces.size(); ++f) {
    if (scene.face_on[f] != ranks.rank()) continue;
    part.faces.push_back({static_cast<GlobalIndex>(f), contact::PlainBox(scene.faces[f])});
    part.boxes.push_back(scene.faces[f]);
  }
  const std::vector<Ghost> ghosts =
      contact::ghost(ranks, std::span<const Ghost>(part.faces), wanted, maker.finest(ranks, part.boxes));
  for (const Ghost& ghost : ghosts) {
    part.faces.push_back(ghost);
    part.boxes.push_back(ghost.capture.box());
  }
  return part;
}

std::vector<Pair> brute_force(const Scene& scene, Rank rank) {
  std::vector<Pair> pairs;
  for (std::size_t n = 0; n < scene.nodes.size(); ++n)
    for (std::size_t f = 0; scene.node_on[n] == rank && f < scene.faces.size(); ++f)
      if (geometry::contains(scene.faces[f], scene.nodes[n]))
        pairs.push_back({static_cast<GlobalIndex>(n), static_cast<GlobalIndex>(f)});
  return pairs;
}

/// Of all ranks.
struct Score {
  GlobalIndex pairs = 0, misses = 0, extras = 0, ghosts = 0;

  void add(std::vector<Pair> found, const std::vector<Pair>& expected) {  // a pair found twice is an extra
    std::ranges::sort(found);
    std::vector<Pair> difference;
    std::ranges::set_difference(expected, found, std::back_inserter(difference));
    misses += static_cast<GlobalIndex>(difference.size());
    difference.clear();
    std::ranges::set_difference(found, expected, std::back_inserter(difference));
    extras += static_cast<GlobalIndex>(difference.size());
    pairs += static_cast<GlobalIndex>(expected.size());
  }
  [[nodiscard]] Score of_all(const comm::Communicator& ranks) const {
    return {ranks.sum(pairs), ranks.sum(misses), ranks.sum(extras), ranks.sum(ghosts)};
  }
};

void search(const comm::Communicator& ranks, const Scene& scene, Maker& maker, contact::SearchScratch& scratch,
            Score& score) {
  const Part part = part_of(ranks, scene, maker);
  Ragged<LocalIndex> pairs;
  contact::find_pairs(part.boxes, part.nodes, scratch, pairs);
  std::vector<Pair> found;
  for (LocalIndex n = 0; n < pairs.rows(); ++n)
    for (const LocalIndex f : std::as_const(pairs).row(n))
      found.push_back({part.node_id[static_cast<std::size_t>(n)], part.faces[static_cast<std::size_t>(f)].id});
  score.add(std::move(found), brute_force(scene, ranks.rank()));
  score.ghosts += std::ranges::count_if(
      part.faces, [&](const Ghost& face) { return scene.face_on[static_cast<std::size_t>(face.id)] != ranks.rank(); });
}

}  // namespace

TEST_CASE("a thousand random scenes over the ranks: no pair is missed, none is found that is none") {
  const comm::Communicator ranks = comm::Communicator::world();
  Maker maker(2027, ranks.size());
  contact::SearchScratch scratch;
  Score score;
  for (int k = 0; k < 1000; ++k) {
    Scene scene = maker.make();
    search(ranks, scene, maker, scratch, score);
    search(ranks, moved(scene, 1.0 / 3), maker, scratch, score);
    search(ranks, moved(scene, 1e6), maker, scratch, score);
    maker.shuffle(scene);
    search(ranks, scene, maker, scratch, score);
  }
  const Score all = score.of_all(ranks);
  CHECK(all.misses == 0);
  CHECK(all.extras == 0);
  CHECK(all.pairs > 400000);  // scenes in which nothing is found would prove nothing
  CHECK((all.ghosts > 50000) == (ranks.size() > 1));
}

// The path of edges: boxes with boxes.
TEST_CASE("boxes that overlap over the ranks: none missed, none twice") {
  const comm::Communicator ranks = comm::Communicator::world();
  Maker maker(2028, ranks.size());
  Score score;
  contact::OverlapScratch scratch;
  for (int k = 0; k < 400; ++k) {
    const Scene scene = moved(maker.make(), std::array{0.0, 1.0 / 3, 1e6}[static_cast<std::size_t>(k % 3)]);
    std::vector<Ghost> own;
    std::vector<Box> wanted;
    for (std::size_t f = 0; f < scene.faces.size(); ++f) {
      if (scene.face_on[f] != ranks.rank()) continue;
      own.push_back({static_cast<GlobalIndex>(f), contact::PlainBox(scene.faces[f])});
      wanted.push_back(scene.faces[f]);
    }
    std::vector<Ghost> all = own;
    const double finest = maker.finest(ranks, wanted);
    for (const Ghost& ghost : contact::ghost(ranks, std::span<const Ghost>(own), wanted, finest)) all.push_back(ghost);
    std::vector<Box> boxes;
    for (const Ghost& candidate : all) boxes.push_back(candidate.capture.box());
    std::vector<Pair> found, expected;
    contact::for_each_overlap(wanted, boxes, scratch, [&](LocalIndex i, LocalIndex j) {
      found.push_back({own[static_cast<std::size_t>(i)].id, all[static_cast<std::size_t>(j)].id});
    });
    for (const Ghost& candidate : own)
      for (std::size_t f = 0; f < scene.faces.size(); ++f)
        if (geometry::overlaps(candidate.capture.box(), scene.faces[f]))
          expected.push_back({candidate.id, static_cast<GlobalIndex>(f)});
    score.add(std::move(found), expected);
  }
  const Score all = score.of_all(ranks);
  CHECK(all.misses == 0);
  CHECK(all.extras == 0);
  CHECK(all.pairs > 50000);
}
