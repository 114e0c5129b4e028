// SPDX-License-Identifier: Apache-2.0
// Our search beside those of other libraries and the paper's two, in one run, on one core: milliseconds of processor
// time from nodes and boxes to pairs. Usage: bench_search [--own] [scene or number of nodes ...], default the five
// scenes at 1e4, 1e5 and 1e6; --own leaves the others out and adds memory and hard scenes.
#include <fmt/core.h>

#include <algorithm>
#include <cstdlib>
#include <ctime>
#include <functional>
#include <map>
#include <string_view>
#include <vector>

#include "contact/search/binary_sort.hpp"
#include "contact/search/bucket_sort.hpp"
#include "contact/search/search.hpp"
#include "search_peers.hpp"
#include "search_scenes.hpp"

using namespace brunt;
using bench::BoxNode;
using bench::SearchScene;

namespace {

/// Waiting for a processor that others use does not count.
double processor_seconds() {
  timespec now{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

/// Sum over all pairs: the order does not matter. The function of `brunt search`.
std::uint64_t hash_of(LocalIndex box, LocalIndex node) {
  std::uint64_t z = (static_cast<std::uint64_t>(box) << 32 | static_cast<std::uint64_t>(node)) * 0x9E3779B97F4A7C15ULL;
  z ^= z >> 29;
  z *= 0xBF58476D1CE4E5B9ULL;
  return z ^ (z >> 32);
}

struct Found {
  std::size_t count = 0;
  std::uint64_t hash = 0;
  friend bool operator==(const Found&, const Found&) = default;
};

Found summary_of(const Ragged<LocalIndex>& pairs) {
  Found found;
  for (LocalIndex node = 0; node < pairs.rows(); ++node)
    for (const LocalIndex box : pairs.row(node)) found.hash += hash_of(box, node);
  found.count = pairs.values.size();
  return found;
}

Found summary_of(const std::vector<BoxNode>& pairs) {
  Found found;
  for (const BoxNode& pair : pairs) found.hash += hash_of(pair[0], pair[1]);
  found.count = pairs.size();
  return found;
}

/// A method on a scene: what is kept from one repeat to the next lives in it.
using Repeat = std::function<Found(double& seconds)>;

template <class Pairs, class Work>
Repeat repeatable(const SearchScene& scene, const Work& work) {
  return [&scene, work, pairs = Pairs()](double& seconds) mutable {
    const double start = processor_seconds();
    work(scene, pairs);
    seconds = processor_seconds() - start;
    return summary_of(pairs);
  };
}

Repeat ours(const SearchScene& scene, contact::SearchScratch& scratch) {
  return repeatable<Ragged<LocalIndex>>(scene, [&scratch](const SearchScene& s, Ragged<LocalIndex>& pairs) {
    scratch.history = {};  // or a repeat would find all sorted
    contact::find_pairs(s.boxes, s.nodes, scratch, pairs);
  });
}

void paper_buckets(const SearchScene& scene, Ragged<LocalIndex>& pairs) {
  contact::BucketSort sorted;
  contact::sort_into_buckets(scene.nodes, contact::bucket_grid(scene.nodes, scene.boxes, 8 * scene.nodes.size()),
                             sorted);
  contact::find_pairs_in_buckets(sorted, scene.boxes, scene.nodes, pairs);
}

void paper_bisection(const SearchScene& scene, Ragged<LocalIndex>& pairs) {
  contact::BinarySort sorted;
  contact::sort_along_axes(scene.nodes, sorted);
  contact::find_pairs_by_bisection(sorted, scene.boxes, scene.nodes, pairs);
}

/// As a run does it: the last search's order, after the motion that makes a run search again.
Repeat ours_after_motion(const SearchScene& scene, const SearchScene& moved, contact::SearchScratch& scratch) {
  return [&, pairs = Ragged<LocalIndex>()](double& seconds) mutable {
    contact::find_pairs(scene.boxes, scene.nodes, scratch, pairs);
    const double start = processor_seconds();
    contact::find_pairs(moved.boxes, moved.nodes, scratch, pairs);
    seconds = processor_seconds() - start;
    return summary_of(pairs);
  };
}

struct Method {
  const char* name;
  std::function<Repeat(const SearchScene&)> on;
};

std::vector<Method> other_methods() {
  std::vector<Method> methods{
      {"bucket sort", [](const SearchScene& s) { return repeatable<Ragged<LocalIndex>>(s, paper_buckets); }},
      {"binary sort", [](const SearchScene& s) { return repeatable<Ragged<LocalIndex>>(s, paper_bisection); }}};
  const auto add = [&](const char* name, bench::Search search) {
    methods.push_back({name, [search](const SearchScene& s) {
                         return repeatable<std::vector<BoxNode>>(s, [search](const SearchScene& scene, auto& pairs) {
                           pairs.clear();
                           search(scene, pairs);
                         });
                       }});
  };
#ifdef BRUNT_WITH_CGAL
  add("CGAL box_intersection_d", bench::search_cgal);
#endif
#ifdef BRUNT_WITH_BULLET
  add("Bullet btDbvt", bench::search_bullet);
#endif
#ifdef BRUNT_WITH_FCL
  add("FCL dynamic tree", bench::search_fcl);
#endif
#ifdef BRUNT_WITH_BOOST
  add("Boost rtree", bench::search_boost);
#endif
#ifdef BRUNT_WITH_NANOFLANN
  add("nanoflann", bench::search_nanoflann);
#endif
#ifdef BRUNT_WITH_EMBREE
  add("Embree", bench::search_embree);
#endif
  return methods;
}

constexpr double long_time = 3;  ///< [s] a method that takes longer is not repeated, nor run on a larger scene

struct Measured {
  double median = 0;  ///< [s]
  Found found;
};

Measured measure(const Repeat& repeat) {
  std::vector<double> times;
  Measured measured;
  for (int k = 0; k < 7; ++k) {
    double seconds = 0;
    measured.found = repeat(seconds);
    times.push_back(seconds);
    if (seconds > long_time || (k >= 2 && seconds > 0.3)) break;
  }
  std::sort(times.begin(), times.end());
  measured.median = times[times.size() / 2];
  return measured;
}

void print_row(const char* name, const std::vector<std::string>& cells) {
  fmt::print("| {:24} |", name);
  for (const std::string& cell : cells) fmt::print(" {:>13} |", cell);
  fmt::print("\n");
  std::fflush(stdout);
}

int compare(const std::vector<std::string>& names, std::size_t size, std::map<std::string, double>& last) {
  std::vector<SearchScene> scenes;
  for (const std::string& name : names) scenes.push_back(bench::scene_by_name(name, size));
  std::vector<std::string> titles, counts, times;
  std::vector<Found> expected;
  contact::SearchScratch scratch;
  for (const SearchScene& scene : scenes) {
    const Measured measured = measure(ours(scene, scratch));
    titles.push_back(scene.name);
    expected.push_back(measured.found);
    counts.push_back(fmt::format("{}", measured.found.count));
    times.push_back(fmt::format("{:.2f}", 1e3 * measured.median));
  }
  print_row(fmt::format("{:.0e} nodes, ms", static_cast<double>(size)).c_str(), titles);
  print_row("---", std::vector<std::string>(scenes.size(), "---:"));
  print_row("pairs", counts);
  print_row("Brunt", times);
  int faults = 0;
  for (const Method& method : other_methods()) {
    std::vector<std::string> cells;
    for (std::size_t s = 0; s < scenes.size(); ++s) {
      double& before = last[method.name + scenes[s].name];
      if (before > long_time / 4) {
        cells.emplace_back("-");
        before = 1e300;
        continue;
      }
      const Measured measured = measure(method.on(scenes[s]));
      before = measured.median;
      const bool same = measured.found == expected[s];
      faults += same ? 0 : 1;
      cells.push_back(fmt::format("{:.2f}{}", 1e3 * measured.median, same ? "" : " DIFFERS"));
    }
    print_row(method.name, cells);
  }
  fmt::print("\n");
  return faults;
}

void measure_own(const std::string& name, const std::vector<std::size_t>& sizes) {
  for (const std::size_t size : sizes) {
    const SearchScene scene = bench::scene_by_name(name, size);
    contact::SearchScratch scratch;
    const Repeat repeat = ours(scene, scratch);
    double first = 0;
    repeat(first);
    const Measured measured = measure(repeat);
    const SearchScene moved = bench::moved(scene, 0.3);
    const Measured after_motion = measure(ours_after_motion(scene, moved, scratch));
    fmt::print(
        "| {} | {} | {} | {:.3f} | {:.3f} | {:.3f} | {:.0f} | {:.0f} |\n", scene.name, scene.nodes.size(),
        measured.found.count, 1e3 * first, 1e3 * measured.median, 1e3 * after_motion.median,
        1e9 * measured.median / static_cast<double>(scene.nodes.size()),
        static_cast<double>(scratch.memory_bytes()) / static_cast<double>(scene.nodes.size() + scene.boxes.size()));
    std::fflush(stdout);
  }
}

}  // namespace

int main(int argc, char** argv) {
  bool own = false;
  std::vector<std::string> names;
  std::vector<std::size_t> sizes;
  for (int i = 1; i < argc; ++i) {
    const double size = std::atof(argv[i]);
    if (std::string_view(argv[i]) == "--own") {
      own = true;
    } else if (size > 0) {
      sizes.push_back(static_cast<std::size_t>(size));
    } else {
      names.emplace_back(argv[i]);
    }
  }
  if (sizes.empty()) sizes = {10000, 100000, 1000000};
  if (names.empty()) names = {"plates", "turned", "crumple", "random", "rod"};
  int faults = 0;
  if (own)
    fmt::print(
        "| scene | nodes | pairs | first, ms | ms | after motion, ms | ns a node | bytes a node or box "
        "|\n|---|---|---|---|---|---|---|---|\n");
  if (own)
    for (const std::string& name : names) measure_own(name, sizes);
  std::map<std::string, double> last;
  if (!own)
    for (const std::size_t size : sizes) faults += compare(names, size, last);
  return faults == 0 ? 0 : 1;
}
