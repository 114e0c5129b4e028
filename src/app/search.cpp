// SPDX-License-Identifier: Apache-2.0
// `brunt search`: the rank-local search on a text scene of nodes and boxes.
#include "brunt/contact/search/search.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <fstream>
#include <nlohmann/json.hpp>

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
  for (LocalIndex face = 0; face < pairs.rows(); ++face) {
    const auto& own = scene.own[static_cast<std::size_t>(face)];
    for (const LocalIndex node : pairs.row(face))
      if (std::ranges::find(own, node) == own.end()) kept.values.push_back(node);
    kept.close_row();
  }
  pairs = std::move(kept);
}

void search_on_root(const SearchOptions& options, int ranks) {
  const TextScene scene = read_text_scene(options.file);
  Ragged<LocalIndex> pairs;
  double best = 1e300;
  for (int k = 0; k < options.repeat; ++k) {
    const auto start = std::chrono::steady_clock::now();
    contact::find_pairs(scene.boxes, scene.nodes, pairs);
    best = std::min(best, std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
  }
  drop_own_nodes(scene, pairs);
  std::uint64_t hash = 0;
  for (LocalIndex face = 0; face < pairs.rows(); ++face)
    for (const LocalIndex node : pairs.row(face)) {
      hash += pair_hash(static_cast<std::uint64_t>(face), static_cast<std::uint64_t>(node));
      if (options.list) fmt::print("{} {}\n", face, node);
    }
  // three index and three rank vectors beside the pairs themselves
  const std::size_t memory = scene.nodes.size() * 6 * sizeof(LocalIndex) + pairs.values.size() * sizeof(LocalIndex);
  const nlohmann::ordered_json result{{"method", options.method},
                                      {"nodes", scene.nodes.size()},
                                      {"faces", scene.boxes.size()},
                                      {"pairs", pairs.values.size()},
                                      {"pairs_hash", fmt::format("{:016x}", hash)},
                                      {"build_s", 0.0},
                                      {"query_s", best},
                                      {"memory_bytes", memory},
                                      {"ranks", ranks}};
  fmt::print("{}\n", result.dump());
}

}  // namespace

int search(const comm::Communicator& ranks, const SearchOptions& options) {
  on_root(ranks, [&] { search_on_root(options, ranks.size()); });
  return 0;
}

}  // namespace brunt::app
