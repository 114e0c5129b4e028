// SPDX-License-Identifier: Apache-2.0
// Our readers of STL, OBJ and PLY beside CGAL's polygon soups: the same triangles with the same coordinates, and the
// median time of interleaved runs. Reads the files named; without any the six bodies of tests/support/depth_bodies.hpp,
// written in each format. Polygons are compared as sets of corners where ours are cut. The exit code is 1 if any
// differ. Usage: bench_surface_files [FILE ...]
#include <fmt/core.h>
#include <fmt/os.h>

#include <algorithm>
#include <ctime>
#include <filesystem>

#include "io/surface/surface_file.hpp"
#include "surface_peer.hpp"
#include "tests/support/depth_bodies.hpp"

using namespace brunt;

namespace {

namespace fs = std::filesystem;

constexpr int runs = 9;

double cpu_ms() {
  return 1e3 * static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

double median(std::vector<double> v) {
  std::sort(v.begin(), v.end());
  return v[v.size() / 2];
}

const Vec3& corner(const TriangleSurface& surface, std::size_t t, std::size_t k) {
  return surface.points[static_cast<std::size_t>(surface.triangles[t][k])];
}

std::string write_stl(const std::string& path, const TriangleSurface& surface) {
  auto out = fmt::output_file(path);
  out.print("solid body\n");
  for (std::size_t t = 0; t < surface.triangles.size(); ++t) {
    out.print("facet normal 0 0 0\nouter loop\n");
    for (std::size_t k = 0; k < 3; ++k) {
      const Vec3& x = corner(surface, t, k);
      out.print("vertex {} {} {}\n", x[0], x[1], x[2]);
    }
    out.print("endloop\nendfacet\n");
  }
  out.print("endsolid body\n");
  return path;
}

std::string write_binary_stl(const std::string& path, const TriangleSurface& surface) {
  std::string bytes(80, ' ');
  const auto put = [&](auto value) { bytes.append(reinterpret_cast<const char*>(&value), sizeof value); };
  put(static_cast<std::uint32_t>(surface.triangles.size()));
  for (std::size_t t = 0; t < surface.triangles.size(); ++t) {
    for (int c = 0; c < 3; ++c) put(0.0F);
    for (std::size_t k = 0; k < 3; ++k)
      for (int c = 0; c < 3; ++c) put(static_cast<float>(corner(surface, t, k)[c]));
    put(std::uint16_t{0});
  }
  auto out = fmt::output_file(path);
  out.print("{}", bytes);
  return path;
}

std::string write_obj(const std::string& path, const TriangleSurface& surface) {
  auto out = fmt::output_file(path);
  for (const Vec3& x : surface.points) out.print("v {} {} {}\n", x[0], x[1], x[2]);
  for (const auto& t : surface.triangles) out.print("f {} {} {}\n", t[0] + 1, t[1] + 1, t[2] + 1);
  return path;
}

std::vector<std::string> written_bodies(const fs::path& folder) {
  std::vector<std::string> paths;
  for (const auto& [name, surface] : {std::pair{"l_shape", test::l_shape()},
                                      {"knot", test::knot()},
                                      {"pawn", test::pawn()},
                                      {"hub", test::hub()},
                                      {"mallet", test::mallet()},
                                      {"bumpy_sphere", test::bumpy_sphere()}}) {
    const std::string stem = (folder / name).string();
    paths.push_back(write_stl(stem + "_text.stl", surface));
    paths.push_back(write_binary_stl(stem + "_binary.stl", surface));
    paths.push_back(write_obj(stem + ".obj", surface));
    paths.push_back(stem + ".ply");
    io::write_ply(paths.back(), surface);
  }
  return paths;
}

/// What differs; empty where nothing does. CGAL makes one point of equal ones in STL, so that corners are compared.
std::string difference(const TriangleSurface& ours, const bench::PolygonSoup& soup) {
  std::size_t triangles = 0, at = 0;
  for (const auto& polygon : soup.polygons) triangles += polygon.size() - 2;
  if (triangles != ours.triangles.size()) return fmt::format("{} triangles", triangles);
  for (const auto& polygon : soup.polygons) {
    std::vector<std::array<double, 3>> one, other;
    const auto add = [](auto& list, const Vec3& x) { list.push_back({x[0], x[1], x[2]}); };
    for (const std::size_t p : polygon) add(other, soup.points[p]);
    for (const std::size_t end = at + polygon.size() - 2; at < end; ++at)
      for (std::size_t k = 0; k < 3; ++k) add(one, corner(ours, at, k));
    if (polygon.size() > 3)  // order and number of corners depend on how it was cut
      for (auto* list : {&one, &other}) {
        std::sort(list->begin(), list->end());
        list->erase(std::unique(list->begin(), list->end()), list->end());
      }
    if (one != other) return fmt::format("coordinates near triangle {}", at);
  }
  return {};
}

bool compare(const std::string& path) {
  std::vector<double> ms, others;
  TriangleSurface ours;
  std::optional<bench::PolygonSoup> soup;
  for (int run = 0; run < runs; ++run) {
    double before = cpu_ms();
    ours = io::read_surface(path).surface;
    ms.push_back(cpu_ms() - before);
    before = cpu_ms();
    soup = bench::cgal_soup(path);
    others.push_back(cpu_ms() - before);
  }
  const std::string found = soup ? difference(ours, *soup) : "refused by CGAL";
  fmt::print("{:24} {:6} points {:6} triangles: Brunt {:7.3f} ms, CGAL {:7.3f} ms: {}\n",
             fs::path(path).filename().string(), ours.points.size(), ours.triangles.size(), median(ms), median(others),
             found.empty() ? "the same" : found);
  return found.empty();
}

}  // namespace

int main(int count, char** arguments) {
  const fs::path folder = fs::temp_directory_path() / "brunt_surface_files";
  fs::create_directories(folder);
  const std::vector<std::string> paths =
      count > 1 ? std::vector<std::string>(arguments + 1, arguments + count) : written_bodies(folder);
  int differ = 0;
  for (const std::string& path : paths) differ += compare(path) ? 0 : 1;
  fs::remove_all(folder);
  fmt::print("{} files, {} read otherwise\n", paths.size(), differ);
  return differ > 0 ? 1 : 0;
}
