// SPDX-License-Identifier: Apache-2.0
// The same surfaces from every format, to the last bit.
#include "io/surface/surface_file.hpp"

#include <catch2/catch.hpp>
#include <fstream>
#include <numbers>

#include "core/error.hpp"
#include "own_folder.hpp"
#include "support/surface_samples.hpp"

using namespace brunt;
using io::parse_surface;
using io::SurfaceFile;
using io::SurfaceFormat;

namespace {

/// No coordinate has few digits, so that a reader in single precision would be seen.
test::PolygonSurface inexact_box() {
  return test::box_surface({-1. / 3, 0.1, 1e-7 / 3}, {std::numbers::pi, 1e5 / 7, 2. / 3});
}

/// Coordinates that single precision holds.
test::PolygonSurface exact_box() {
  return test::box_surface({-0.25, 1, 2}, {3.5, 4, 1024});
}

SurfaceFile from_obj(const std::string& text) {
  return parse_surface(text, "a.obj", SurfaceFormat::obj);
}

SurfaceFile from_ply(const std::string& text) {
  return parse_surface(text, "a.ply", SurfaceFormat::ply);
}

SurfaceFile from_stl(const std::string& text) {
  return parse_surface(text, "a.stl", SurfaceFormat::stl);
}

std::string with_crlf(const std::string& text) {
  std::string result;
  for (const char c : text) result += c == '\n' ? std::string("\r\n") : std::string(1, c);
  return result;
}

/// Coordinates of the corners, triangle by triangle: STL has no points of its own.
std::vector<Vec3> corners_of(const TriangleSurface& surface) {
  std::vector<Vec3> corners;
  for (const auto& triangle : surface.triangles)
    for (const LocalIndex corner : triangle) corners.push_back(surface.points[static_cast<std::size_t>(corner)]);
  return corners;
}

}  // namespace

TEST_CASE("A box is the same from every file of doubles, to the last bit") {
  const auto box = inexact_box();
  const SurfaceFile reference = from_obj(test::obj(box));
  CHECK(reference.surface.points == box.points);
  CHECK(reference.surface.triangles.size() == 12);
  CHECK_FALSE(reference.single_precision);
  const auto same = [&](const SurfaceFile& file) {
    CHECK(file.surface.points == reference.surface.points);
    CHECK(file.surface.triangles == reference.surface.triangles);
    CHECK_FALSE(file.single_precision);
  };
  same(from_obj(with_crlf(test::obj(box))));
  same(from_obj("\xEF\xBB\xBF" + test::obj(box)));
  same(from_ply(test::ascii_ply(box)));
  same(from_ply(with_crlf(test::ascii_ply(box))));
  same(from_ply("\xEF\xBB\xBF" + test::ascii_ply(box)));
  same(from_ply(test::binary_ply<double>(box, std::endian::little)));
  same(from_ply(test::binary_ply<double>(box, std::endian::big)));
  const SurfaceFile stl = from_stl(test::ascii_stl(reference.surface));
  CHECK(corners_of(stl.surface) == corners_of(reference.surface));
  CHECK(stl.single_precision);
  CHECK(corners_of(from_stl(with_crlf(test::ascii_stl(reference.surface))).surface) == corners_of(stl.surface));
}

TEST_CASE("A box of floats is the same from files of floats") {
  const auto box = exact_box();
  const SurfaceFile reference = from_obj(test::obj(box));
  for (const std::endian order : {std::endian::little, std::endian::big}) {
    const SurfaceFile file = from_ply(test::binary_ply<float>(box, order));
    CHECK(file.surface.points == box.points);
    CHECK(file.surface.triangles == reference.surface.triangles);
    CHECK(file.single_precision);
  }
  const auto corners = corners_of(reference.surface);
  CHECK(corners_of(from_stl(test::ascii_stl(reference.surface)).surface) == corners);
  CHECK(corners_of(from_stl(test::binary_stl(reference.surface)).surface) == corners);
  CHECK(corners_of(from_stl(test::binary_stl(reference.surface, "solid of another program")).surface) == corners);
}

TEST_CASE("OBJ: corners with texture and normal, negative indices, weights, colours, continued lines, comments") {
  const std::string points = "v 0 0 0\nv +1 0 0 1.0\nv 1 1e0 0 0.5 0.5 0.5 # grey\nv 0 1 0 1 0 0 1\n";
  const auto triangles = from_obj(points + "f 1 2 3 4\n").surface.triangles;
  for (const char* face : {"f 1/7 2/8 3/9 4/1", "f 1//7 2//8 3//9 4//1", "f 1/2/3 2/3/4 3/4/5 4/5/6", "f -4 -3 -2 -1",
                           "  f\t1 -3/1 3//-1 -1/1/1 # four", "f 1 2 \\\n 3\\\r\n 4", "g a \\\n b\nf 1 2 3 4#four",
                           "vt 0 0\nvn 0 0 1\nusemtl a\nl 1 2\np 1\ns 1\nf 1 2 3 4"}) {
    INFO(face);
    const SurfaceFile file = from_obj(points + face);
    CHECK(file.surface.points == std::vector<Vec3>{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}});
    CHECK(file.surface.triangles == triangles);
  }
  CHECK(from_obj("f 1 2 3 4\n" + points).surface.triangles == triangles);  // faces before their points
}

TEST_CASE("PLY: other elements and properties, all types, faces before points") {
  const std::string ascii = R"(ply
format ascii 1.0
obj_info none
element material 2
property list uchar float shades
property int kind
element face 1
property uchar red
property list int8 uint16 vertex_index
property list uchar double weights
element nothing 1000000000000
element vertex 3
property float64 z
property float nx
property int8 x
property uint16 y
element edge 1
property int vertex1
property int vertex2
end_header
2 0.5 0.7 1
0 3
255 3 0 1 2 3 0.1 0.2 0.3

0.125 0 -1 65535
0 nan 1 0
0 0 0 1
0 1
)";
  const SurfaceFile text = from_ply(ascii);
  CHECK(text.surface.points == std::vector<Vec3>{{-1, 65535, 0.125}, {1, 0, 0}, {0, 1, 0}});
  CHECK(text.surface.triangles == std::vector<std::array<LocalIndex, 3>>{{0, 1, 2}});
  std::string binary = ascii.substr(0, ascii.find("end_header") + 11);
  binary.replace(binary.find("ascii"), 5, "binary_big_endian");
  constexpr auto big = std::endian::big;
  test::append(binary, std::uint8_t{2});
  for (const float x : {0.5f, 0.7f}) test::append(binary, x, big);
  test::append(binary, std::int32_t{1}, big);
  test::append(binary, std::uint8_t{0});
  test::append(binary, std::int32_t{3}, big);
  binary += "\xFF\x03";
  for (std::uint16_t i = 0; i < 3; ++i) test::append(binary, i, big);
  binary += '\x03';
  for (const double x : {0.1, 0.2, 0.3}) test::append(binary, x, big);
  const auto add_point = [&](double z, std::int8_t x, std::uint16_t y) {
    test::append(binary, z, big);
    test::append(binary, 0.f, big);
    test::append(binary, x, big);
    test::append(binary, y, big);
  };
  add_point(0.125, -1, 65535);
  add_point(0, 1, 0);
  add_point(0, 0, 1);
  for (const std::int32_t i : {0, 1}) test::append(binary, i, big);
  const SurfaceFile bytes = from_ply(binary);
  CHECK(bytes.surface.points == text.surface.points);
  CHECK(bytes.surface.triangles == text.surface.triangles);
}

TEST_CASE("STL: upper case, several solids, everything in one line") {
  const std::string facet = "FACET NORMAL 0 0 nan OUTER LOOP VERTEX 0 0 0 vertex 1 0 0 VERTEX 0 1 0 ENDLOOP ENDFACET ";
  CHECK(from_stl("SOLID\n" + facet + facet + "ENDSOLID").surface.triangles.size() == 2);
  CHECK(from_stl("solid a b c\n" + facet + "endsolid a b c\n\n solid\n" + facet + "endsolid").surface.points.size() ==
        6);
}

TEST_CASE("The extension chooses the reader, in any case") {
  const test::OwnFolder folder("surface_file");
  const auto box = exact_box();
  const auto put = [&](const std::string& name, const std::string& text) {
    std::ofstream(folder.path + "/" + name, std::ios::binary) << text;
    return folder.path + "/" + name;
  };
  const TriangleSurface triangles = from_obj(test::obj(box)).surface;
  CHECK(io::read_surface(put("a.obj", test::obj(box))).surface.points == box.points);
  CHECK(io::read_surface(put("b.OBJ", test::obj(box))).surface.points == box.points);
  CHECK(io::read_surface(put("c.Ply", test::ascii_ply(box))).surface.points == box.points);
  CHECK(io::read_surface(put("d.e.STL", test::binary_stl(triangles))).surface.points.size() == 36);
  CHECK_THROWS_WITH(io::read_surface("some.folder/body"),
                    "some.folder/body: unknown extension '' of a surface file; expected .stl, .obj or .ply");
  CHECK_THROWS_WITH(io::read_surface("body.off"),
                    "body.off: unknown extension '.off' of a surface file; expected .stl, .obj or .ply");
  CHECK_THROWS_AS(io::read_surface(folder.path + "/none.stl"), InputError);
}
