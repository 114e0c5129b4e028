// SPDX-License-Identifier: Apache-2.0
// `brunt search`: the rank-local search on a text scene of nodes and boxes, by the method in use or one of the paper.
#include "brunt/contact/search/search.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <fstream>
#include <nlohmann/json.hpp>

#include "brunt/contact/search/binary_sort.hpp"
#include "brunt/contact/search/bucket_sort.hpp"
#include "brunt/core/error.hpp"
#include "commands.hpp"
#include "failure.hpp"

namespace brunt::app {
namespace {

struct TextScene {
  std::vector<Vec3> nodes;
  std::vector<geometry::Box> boxes;
  std::vector<std::array<LocalIndex, 4>> own;  ///< nodes of each face: never its partners
};

TextScene read_text_scene(const std::string& path) {
  std::ifstream in(path);
  if (!in) throw InputError(path + ": cannot be read");
  std::string format, name;
  long long n = -1, m = -1;
  if (!(in >> format >> name >> n >> m) || format != "scene1" || n < 0 || m < 0 || n > 2000000000 || m > 2000000000)
    throw InputError(path + ":1: not a search scene; accepted: scene1 NAME n m");
  TextScene scene;
  const auto fault = [&](long long line, const char* what) {
    return InputError(fmt::format("{}:{}: accepted: {}", path, line, what));
  };
  for (long long i = 0; i < n; ++i) {
    Vec3 x;
    if (!(in >> x[0] >> x[1] >> x[2])) throw fault(i + 2, "three finite coordinates x y z");
    scene.nodes.push_back(x);
  }
  for (long long i = 0; i < m; ++i) {
    geometry::Box box;
    std::array<LocalIndex, 4> own{};
    if (!(in >> box.low[0] >> box.low[1] >> box.low[2] >> box.high[0] >> box.high[1] >> box.high[2] >> own[0] >>
          own[1] >> own[2] >> own[3]))
      throw fault(n + i + 2, "lox loy loz hix hiy hiz n0 n1 n2 n3");
    if (std::ranges::any_of(own, [&](LocalIndex k) { return k < -1 || k >= n; }))
      throw fault(n + i + 2, "node ids from 0 to n - 1, or -1 for none");
    scene.boxes.push_back(box);
    scene.own.push_back(own);
  }
  return scene;
}

std::uint64_t pair_hash(std::uint64_t face, std::uint64_t node) {
  std::uint64_t z = (face * (std::uint64_t{1} << 32) + node) * 0x9E3779B97F4A7C15ULL;
  z ^= z >> 29;
  z *= 0xBF58476D1CE4E5B9ULL;
  return z ^ (z >> 32);
}

void drop_own_nodes(const TextScene& scene, Ragged<LocalIndex>& pairs) {
  Ragged<LocalIndex> kept;
  for (LocalIndex node = 0; node < pairs.rows(); ++node) {
    for (const LocalIndex face : pairs.row(node))
      if (const auto& own = scene.own[static_cast<std::size_t>(face)]; std::ranges::find(own, node) == own.end())
        kept.values.push_back(face);
    kept.close_row();
  }
  pairs = std::move(kept);
}

using Clock = std::chrono::steady_clock;
using Seconds = std::chrono::duration<double>;

struct Timing {
  double build = 0, query = 0;  ///< [s]
  std::size_t memory = 0;       ///< [bytes] beside nodes, boxes and pairs

  [[nodiscard]] double total() const { return build + query; }
};

template <class Build, class Query>
Timing timed(const Build& build, const Query& query) {
  const Clock::time_point start = Clock::now();
  build();
  const Clock::time_point built = Clock::now();
  query();
  return {Seconds(built - start).count(), Seconds(Clock::now() - built).count()};
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
              scene_.nodes, contact::bucket_grid(scene_.nodes, scene_.boxes, 8 * scene_.nodes.size() + 64), buckets_);
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

void search_on_root(const SearchOptions& options, int ranks) {
  const TextScene scene = read_text_scene(options.file);
  Searcher searcher(scene, options.method);
  Ragged<LocalIndex> pairs;
  Timing best = searcher.find(pairs);
  for (int k = 1; k < options.repeat; ++k)
    if (const Timing again = searcher.find(pairs); again.total() < best.total()) best = again;
  drop_own_nodes(scene, pairs);
  Ragged<LocalIndex> by_face;
  transpose(pairs, scene.boxes.size(), by_face);
  std::uint64_t hash = 0;
  for (LocalIndex face = 0; face < by_face.rows(); ++face)
    for (const LocalIndex node : std::as_const(by_face).row(face)) {
      hash += pair_hash(static_cast<std::uint64_t>(face), static_cast<std::uint64_t>(node));
      if (options.list) fmt::print("{} {}\n", face, node);
    }
  const nlohmann::ordered_json result{{"method", options.method},
                                      {"nodes", scene.nodes.size()},
                                      {"faces", scene.boxes.size()},
                                      {"pairs", pairs.values.size()},
                                      {"pairs_hash", fmt::format("{:016x}", hash)},
                                      {"build_s", best.build},
                                      {"query_s", best.query},
                                      {"memory_bytes", best.memory},
                                      {"ranks", ranks}};
  fmt::print("{}\n", result.dump());
}

}  // namespace

int search(const comm::Communicator& ranks, const SearchOptions& options) {
  on_root(ranks, [&] { search_on_root(options, ranks.size()); });
  return 0;
}

}  // namespace brunt::app
