// SPDX-License-Identifier: Apache-2.0
// `brunt search`: the contact search alone on a text scene of nodes and boxes, distributed over the ranks; within a
// rank by the method of `brunt run`, a method of the paper, or trees.
#include "contact/search/search.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <fstream>

#include "app/program/commands.hpp"
#include "app/program/failure.hpp"
#include "contact/lists/ghosting.hpp"
#include "contact/search/binary_sort.hpp"
#include "contact/search/bucket_sort.hpp"
#include "core/error.hpp"
#include "search_facets.hpp"

namespace brunt::app {
namespace {

struct TextFace {
  contact::PlainBox capture;
  std::array<GlobalIndex, 4> own{};  ///< nodes of the face: never its partners
};

/// A block of the scene's nodes and some of its faces.
struct TextScene {
  GlobalIndex first_node = 0;  ///< in the file
  std::vector<Vec3> nodes;
  std::vector<GlobalIndex> face_id;  ///< in the file
  std::vector<TextFace> faces;
  std::vector<geometry::Box> boxes;  ///< of the faces
};

TextScene read_text_scene(const std::string& path) {
  std::ifstream in(path);
  if (!in) throw InputError(path + ": cannot read the file; expected a text scene");
  std::string format, name;
  long long n = -1, m = -1;
  if (!(in >> format >> name >> n >> m) || format != "scene1" || n < 0 || m < 0 || n > 2000000000 || m > 2000000000)
    throw InputError(path + ":1: invalid search scene; expected scene1 NAME n m");
  TextScene scene;
  const auto fault = [&](long long line, const char* what) {
    return InputError(fmt::format("{}:{}: invalid line; expected {}", path, line, what));
  };
  for (long long i = 0; i < n; ++i) {
    Vec3 x;
    if (!(in >> x[0] >> x[1] >> x[2])) throw fault(i + 2, "three finite coordinates x y z");
    scene.nodes.push_back(x);
  }
  for (long long i = 0; i < m; ++i) {
    TextFace face;
    auto& [low, high] = face.capture;
    auto& own = face.own;
    if (!(in >> low[0] >> low[1] >> low[2] >> high[0] >> high[1] >> high[2] >> own[0] >> own[1] >> own[2] >> own[3]))
      throw fault(n + i + 2, "lox loy loz hix hiy hiz n0 n1 n2 n3");
    if (std::ranges::any_of(own, [&](GlobalIndex k) { return k < -1 || k >= n; }))
      throw fault(n + i + 2, "node ids from 0 to n - 1, or -1 for none");
    scene.faces.push_back(face);
    scene.face_id.push_back(i);
  }
  return scene;
}

TextScene deal_scene(const comm::Communicator& ranks, const TextScene& whole) {
  const auto total = [&](std::size_t count) { return ranks.max(static_cast<GlobalIndex>(count)); };
  const comm::BlockLayout nodes{total(whole.nodes.size()), ranks.size()};
  const comm::BlockLayout faces{total(whole.faces.size()), ranks.size()};
  std::vector<std::array<double, 3>> points;
  for (const Vec3& x : whole.nodes) points.push_back({x[0], x[1], x[2]});
  TextScene scene{.first_node = nodes.first(ranks.rank()), .nodes = {}, .face_id = {}, .faces = {}, .boxes = {}};
  for (const std::array<double, 3>& point : deal(ranks, points, nodes)) scene.nodes.emplace_back(point.data());
  scene.faces = deal(ranks, whole.faces, faces);
  for (std::size_t f = 0; f < scene.faces.size(); ++f)
    scene.face_id.push_back(faces.first(ranks.rank()) + static_cast<GlobalIndex>(f));
  for (const TextFace& face : scene.faces) scene.boxes.push_back(face.capture.box());
  return scene;
}

/// Adds the faces of other ranks that share a cell with a node of this one.
Traffic add_ghosts(const comm::Communicator& ranks, TextScene& scene) {
  struct Travelling {
    GlobalIndex id = 0;
    TextFace face;
  };
  std::vector<geometry::Box> wanted;
  for (const Vec3& node : scene.nodes) wanted.push_back({node, node});
  Traffic traffic;
  std::vector<std::vector<Travelling>> outgoing;
  const double finest = contact::finest_cell(ranks, scene.boxes);
  for (const std::vector<LocalIndex>& leaving : contact::meet_in_cells(ranks, scene.boxes, wanted, finest)) {
    outgoing.emplace_back();
    for (const LocalIndex f : leaving) outgoing.back().push_back({nth(scene.face_id, f), nth(scene.faces, f)});
    traffic.messages += leaving.empty() ? 0 : 1;
    traffic.bytes += static_cast<GlobalIndex>(leaving.size() * sizeof(Travelling));
  }
  for (const Travelling& ghost : comm::exchange(ranks, outgoing).values) {
    scene.face_id.push_back(ghost.id);
    scene.faces.push_back(ghost.face);
    scene.boxes.push_back(ghost.face.capture.box());
    ++traffic.ghosts;
  }
  return {ranks.max(traffic.ghosts), ranks.max(traffic.messages), ranks.max(traffic.bytes)};
}

/// In the file's numbers; a face is no partner of its own nodes.
std::vector<FoundPair> named_pairs(const TextScene& scene, const Ragged<LocalIndex>& pairs) {
  std::vector<FoundPair> named;
  for (LocalIndex n = 0; n < pairs.rows(); ++n) {
    const GlobalIndex node = scene.first_node + n;
    for (const LocalIndex f : pairs.row(n)) {
      const auto face = static_cast<std::size_t>(f);
      if (std::ranges::find(scene.faces[face].own, node) == scene.faces[face].own.end())
        named.push_back({scene.face_id[face], node});
    }
  }
  return named;
}

std::size_t bytes_of(std::initializer_list<const std::vector<LocalIndex>*> vectors) {
  std::size_t bytes = 0;
  for (const std::vector<LocalIndex>* vector : vectors) bytes += vector->capacity() * sizeof(LocalIndex);
  return bytes;
}

/// One search by one method; what it works in is kept for the next.
class Searcher {
 public:
  Searcher(const TextScene& scene, std::string method) : scene_(scene), method_(std::move(method)) {}

  Timing find(Ragged<LocalIndex>& pairs) {
    if (method_ == "bucket") return by_buckets(pairs);
    if (method_ == "binary") return by_bisection(pairs);
    if (method_ == "kdop") return search_boxes_by_trees(scene_.nodes, scene_.boxes, pairs);
    Timing timing = timed([&] { contact::prepare_search(scene_.boxes, scene_.nodes, scratch_); },
                          [&] { contact::find_prepared(scene_.boxes, scene_.nodes, scratch_, pairs); });
    timing.memory = scratch_.memory_bytes();
    return timing;
  }

 private:
  Timing by_buckets(Ragged<LocalIndex>& pairs) {
    Timing timing = timed(
        [&] {
          contact::sort_into_buckets(
              scene_.nodes,
              contact::bucket_grid(scene_.nodes, scene_.boxes, contact::most_buckets(scene_.nodes.size())), buckets_);
        },
        [&] { contact::find_pairs_in_buckets(buckets_, scene_.boxes, scene_.nodes, pairs); });
    timing.memory = bytes_of({&buckets_.lbox, &buckets_.nbox, &buckets_.npoint, &buckets_.ndsort});
    return timing;
  }

  Timing by_bisection(Ragged<LocalIndex>& pairs) {
    Timing timing = timed([&] { contact::sort_along_axes(scene_.nodes, sorted_); },
                          [&] { contact::find_pairs_by_bisection(sorted_, scene_.boxes, scene_.nodes, pairs); });
    for (std::size_t a = 0; a < 3; ++a) timing.memory += bytes_of({&sorted_.index[a], &sorted_.rank[a]});
    return timing;
  }

  const TextScene& scene_;
  const std::string method_;
  contact::SearchScratch scratch_;
  contact::BucketSort buckets_;
  contact::BinarySort sorted_;
};

SearchResult search_boxes(const comm::Communicator& ranks, const SearchOptions& options) {
  TextScene whole;
  on_root(ranks, [&] { whole = read_text_scene(options.file); });
  SearchResult result;
  result.nodes = ranks.max(static_cast<GlobalIndex>(whole.nodes.size()));
  result.faces = ranks.max(static_cast<GlobalIndex>(whole.faces.size()));
  const TextScene dealt = deal_scene(ranks, whole);
  Ragged<LocalIndex> pairs;
  for (int k = 0; k < options.repeat; ++k) {
    TextScene scene = dealt;
    const Clock::time_point start = Clock::now();
    result.traffic = add_ghosts(ranks, scene);
    const double meeting = Seconds(Clock::now() - start).count();
    Timing timing = Searcher(scene, options.method).find(pairs);
    timing.build = ranks.max(timing.build + meeting);
    timing.query = ranks.max(timing.query);
    if (k == 0 || timing.total() < result.best.total()) result.best = timing;
    if (k == 0) result.found = named_pairs(scene, pairs);
  }
  return result;
}

}  // namespace

int search(const comm::Communicator& ranks, const SearchOptions& options) {
  bool facets = false;
  on_root(ranks, [&] { facets = is_facet_scene(options.file); });
  const bool on_all = ranks.max(static_cast<GlobalIndex>(facets)) > 0;
  print_result(ranks, options, on_all ? search_facets(ranks, options) : search_boxes(ranks, options));
  return 0;
}

}  // namespace brunt::app
