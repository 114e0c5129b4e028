// SPDX-License-Identifier: Apache-2.0
// Surface files with random damage: a reader gives a surface or an InputError, and takes no more memory than the size
// of the file allows.
#include <malloc.h>

#include <catch2/catch.hpp>
#include <chrono>
#include <cstdlib>
#include <new>

#include "core/error.hpp"
#include "geometry/triangles/closed_surface.hpp"
#include "geometry/triangles/merge_points.hpp"
#include "io/surface/surface_file.hpp"
#include "mutations.hpp"
#include "support/surface_samples.hpp"

using namespace brunt;
using io::SurfaceFormat;

namespace {

std::size_t memory_now = 0, memory_peak = 0;  // bytes of operator new

}  // namespace

[[gnu::noinline]] void* operator new(std::size_t size, const std::nothrow_t& /*tag*/) noexcept {
  void* memory = std::malloc(size);
  if (memory == nullptr) return nullptr;
  memory_now += malloc_usable_size(memory);
  memory_peak = std::max(memory_peak, memory_now);
  return memory;
}
[[gnu::noinline]] void* operator new(std::size_t size) {
  if (void* memory = operator new(size, std::nothrow)) return memory;
  throw std::bad_alloc();
}
[[gnu::noinline]] void operator delete(void* memory) noexcept {
  memory_now -= malloc_usable_size(memory);
  std::free(memory);
}
[[gnu::noinline]] void operator delete(void* memory, std::size_t /*size*/) noexcept {
  operator delete(memory);
}

namespace {

/// Bytes of memory that a reader may take for a byte of a file, and for any file. A face of a binary PLY file takes
/// four bytes at least, and 12 for its triangle, 12 for its corners (three times that while their array grows), 16 for
/// its place.
constexpr std::size_t memory_ratio = 24, memory_base = 1 << 12;
constexpr double most_seconds = 5;  // for one file of a few kilobytes: a hang

const std::string rich_obj = R"(# quadrilaterals, a concave polygon, all kinds of corners
mtllib a.mtl
v 0 0 0 1.0
v 2 0 0 0.5 0.5 0.5
v +2.0e0 1 0
v 1 1 0
v 1 2 0
v 0 2 0
vt 0 0
vn 0 0 1
g top \
 side
f 1/1/1 2/1/1 3//1 4/1 \
  5 6
f -6 -1 -2 -3 -4 -5
l 1 2
f 1 2 4
s off
)";

const std::string rich_ply = R"(ply
format ascii 1.0
comment lists and other elements
element material 2
property list uchar float shades
element vertex 6
property float nx
property double x
property double y
property double z
property uchar red
element face 3
property list uchar int vertex_index
property list uchar float weights
element edge 1
property int vertex1
end_header
2 0.5 0.75
0
0 0 0 0 255
0 2 0 0 255
0 2 1 0 0
0 1 1 0 0
0 1 2 0 1
0 0 2 0 1
6 0 1 2 3 4 5 0
6 5 4 3 2 1 0 1 0.5
3 0 1 3 0
7
)";

std::vector<std::string> samples(SurfaceFormat format) {
  const test::PolygonSurface l = test::l_surface(), box = test::box_surface({-0.5, 0, 1e-3}, {1. / 3, 2e5, 7});
  const TriangleSurface triangles = test::fans_of(box);
  switch (format) {
    case SurfaceFormat::stl:
      return {test::ascii_stl(triangles), test::binary_stl(triangles), test::binary_stl(triangles, "solid in binary")};
    case SurfaceFormat::obj:
      return {test::obj(l), test::obj(box), rich_obj};
    case SurfaceFormat::ply:
      break;
  }
  return {test::ascii_ply(l), rich_ply, test::binary_ply<float>(l, std::endian::little),
          test::binary_ply<double>(l, std::endian::big), test::binary_ply<double>(box, std::endian::little)};
}

bool is_valid(const TriangleSurface& surface) {
  for (const Vec3& x : surface.points)
    if (!(x.cwiseAbs().maxCoeff() <= io::largest_coordinate)) return false;
  for (const auto& triangle : surface.triangles)
    for (const LocalIndex corner : triangle)
      if (corner < 0 || corner >= static_cast<LocalIndex>(surface.points.size())) return false;
  return !surface.triangles.empty();
}

/// Merging and checking take what the reader gives, closed or not.
bool is_checked(const io::SurfaceFile& file) {
  const double tolerance = geometry::default_tolerance(file.surface, file.single_precision);
  const geometry::MergedSurface merged = geometry::merge_points(file.surface, tolerance);
  const geometry::SurfaceFaults faults = geometry::check_closed(merged.surface);
  return faults.sound() == describe(faults, merged.surface, "a").empty();
}

struct Outcomes {
  int surfaces = 0, refused = 0;
  double most_memory = 0;  // over that of the file, above memory_base
};

Outcomes run(SurfaceFormat format, int count, unsigned seed) {
  const std::vector<std::string> originals = samples(format);
  test::Mutations mutations(seed);
  Outcomes outcomes;
  for (int k = 0; k < count; ++k) {
    const std::string text =
        mutations.mutate(originals[mutations.below(originals.size())], originals[mutations.below(originals.size())]);
    const std::size_t before = memory_now;
    memory_peak = memory_now;
    const auto start = std::chrono::steady_clock::now();
    try {
      const io::SurfaceFile file = io::parse_surface(text, "a", format);
      ++outcomes.surfaces;
      if (!is_valid(file.surface)) FAIL("a surface that is none, mutation " << k << ":\n" << text);
      const std::size_t peak = memory_peak;
      if (!is_checked(file)) FAIL("a fault without a line, mutation " << k << ":\n" << text);
      memory_peak = peak;
    } catch (const InputError& error) {
      ++outcomes.refused;
      if (std::string(error.what()).rfind("a:", 0) != 0) FAIL("a fault without a place: " << error.what());
    }
    const std::chrono::duration<double> time = std::chrono::steady_clock::now() - start;
    if (time.count() > most_seconds) FAIL(time.count() << " s, mutation " << k << ":\n" << text);
    const auto memory = static_cast<double>(memory_peak - before) - static_cast<double>(memory_base);
    outcomes.most_memory = std::max(outcomes.most_memory, memory / static_cast<double>(text.size() + 1));
  }
  return outcomes;
}

void run_all(int count, unsigned seed) {
  for (const SurfaceFormat format : {SurfaceFormat::stl, SurfaceFormat::obj, SurfaceFormat::ply}) {
    const Outcomes outcomes = run(format, count, seed);
    WARN("format " << static_cast<int>(format) << ": " << outcomes.surfaces << " surfaces, " << outcomes.refused
                   << " refused, memory at most " << outcomes.most_memory << " times the file");
    CHECK(outcomes.surfaces > count / 50);
    CHECK(outcomes.refused > count / 10);
    CHECK(outcomes.most_memory < static_cast<double>(memory_ratio));
  }
}

}  // namespace

TEST_CASE("Damaged surface files are read or refused: 3,000 a format") {
  run_all(3000, 1);
}

TEST_CASE("Damaged surface files are read or refused: 100,000 a format", "[.long]") {
  run_all(100'000, 2);
}
