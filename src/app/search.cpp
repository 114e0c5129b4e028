// SPDX-License-Identifier: Apache-2.0
// `brunt search`: contact search alone on a text scene of nodes and boxes, dealt out over the ranks; within a rank by
// the method in use or one of the paper.
#include "brunt/contact/search/search.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <bit>
#include <chrono>
#include <cstring>
#include <fstream>
#include <nlohmann/json.hpp>

#include "brunt/comm/rendezvous.hpp"
#include "brunt/contact/ghosting.hpp"
#include "brunt/contact/search/binary_sort.hpp"
#include "brunt/contact/search/bucket_sort.hpp"
#include "brunt/core/error.hpp"
#include "commands.hpp"
#include "failure.hpp"

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

/// What the ranks told each other of their faces.
struct Traffic {
  GlobalIndex ghosts = 0, messages = 0, bytes = 0;  ///< received, sent, sent: the most of a rank
};

/// Entities 0..total-1 of the root in equal blocks.
template <class T>
std::vector<T> deal(const comm::Communicator& ranks, const std::vector<T>& whole, const comm::BlockLayout& layout) {
  std::vector<std::vector<T>> outgoing(static_cast<std::size_t>(ranks.size()));
  for (Rank r = 0; ranks.is_root() && r < ranks.size(); ++r) {
    const auto first = whole.begin() + layout.first(r);
    outgoing[static_cast<std::size_t>(r)].assign(first, first + layout.count(r));
  }
  return comm::exchange(ranks, outgoing).values;
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
    for (const LocalIndex f : leaving)
      outgoing.back().push_back({scene.face_id[static_cast<std::size_t>(f)], scene.faces[static_cast<std::size_t>(f)]});
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

std::uint64_t pair_hash(std::uint64_t face, std::uint64_t node) {
  std::uint64_t z = (face * (std::uint64_t{1} << 32) + node) * 0x9E3779B97F4A7C15ULL;
  z ^= z >> 29;
  z *= 0xBF58476D1CE4E5B9ULL;
  return z ^ (z >> 32);
}

struct FoundPair {
  GlobalIndex face = 0, node = 0;
  friend auto operator<=>(const FoundPair&, const FoundPair&) = default;
};

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

void print_pairs(const comm::Communicator& ranks, const std::vector<FoundPair>& here) {
  std::vector<FoundPair> all;
  for (const std::vector<std::byte>& bytes : ranks.gather(std::as_bytes(std::span(here)))) {
    const std::size_t before = all.size();
    all.resize(before + bytes.size() / sizeof(FoundPair));
    if (!bytes.empty()) std::memcpy(&all[before], bytes.data(), bytes.size());
  }
  std::ranges::sort(all);
  for (const FoundPair& pair : all) fmt::print("{} {}\n", pair.face, pair.node);
}

}  // namespace

int search(const comm::Communicator& ranks, const SearchOptions& options) {
  TextScene whole;
  on_root(ranks, [&] { whole = read_text_scene(options.file); });
  const GlobalIndex nodes = ranks.max(static_cast<GlobalIndex>(whole.nodes.size()));
  const GlobalIndex faces = ranks.max(static_cast<GlobalIndex>(whole.faces.size()));
  const TextScene dealt = deal_scene(ranks, whole);
  Ragged<LocalIndex> pairs;
  Timing best;
  Traffic traffic;
  std::vector<FoundPair> found;
  for (int k = 0; k < options.repeat; ++k) {
    TextScene scene = dealt;
    const Clock::time_point start = Clock::now();
    traffic = add_ghosts(ranks, scene);
    const double meeting = Seconds(Clock::now() - start).count();
    Timing timing = Searcher(scene, options.method).find(pairs);
    timing.build = ranks.max(timing.build + meeting);
    timing.query = ranks.max(timing.query);
    if (k == 0 || timing.total() < best.total()) best = timing;
    if (k == 0) found = named_pairs(scene, pairs);
  }
  std::array<GlobalIndex, 3> sums{static_cast<GlobalIndex>(found.size()), 0, static_cast<GlobalIndex>(best.memory)};
  std::uint64_t hash = 0;
  for (const FoundPair& pair : found)
    hash += pair_hash(static_cast<std::uint64_t>(pair.face), static_cast<std::uint64_t>(pair.node));
  sums[1] = std::bit_cast<GlobalIndex>(hash);
  ranks.sum(sums);
  if (options.list) print_pairs(ranks, found);
  if (!ranks.is_root()) return 0;
  const nlohmann::ordered_json result{{"method", options.method},
                                      {"nodes", nodes},
                                      {"faces", faces},
                                      {"pairs", sums[0]},
                                      {"pairs_hash", fmt::format("{:016x}", std::bit_cast<std::uint64_t>(sums[1]))},
                                      {"build_s", best.build},
                                      {"query_s", best.query},
                                      {"memory_bytes", sums[2]},
                                      {"ranks", ranks.size()},
                                      {"most_ghosts", traffic.ghosts},
                                      {"most_messages", traffic.messages},
                                      {"most_bytes_sent", traffic.bytes}};
  fmt::print("{}\n", result.dump());
  return 0;
}

}  // namespace brunt::app
