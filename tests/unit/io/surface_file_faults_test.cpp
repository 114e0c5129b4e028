// SPDX-License-Identifier: Apache-2.0
// Broken surface files: each is refused with its place and what is expected.
#include <catch2/catch.hpp>
#include <limits>

#include "core/error.hpp"
#include "io/surface/surface_file.hpp"
#include "support/surface_samples.hpp"

using namespace brunt;
using io::SurfaceFormat;

namespace {

std::string fault_of(const std::string& text, const std::string& name) {
  try {
    (void)io::parse_surface(text, name, io::surface_format(name));
  } catch (const InputError& error) {
    return error.what();
  }
  return "read as if it were sound";
}

std::string obj_fault(const std::string& text) {
  return fault_of(text, "a.obj");
}

std::string ply_fault(const std::string& text) {
  return fault_of(text, "a.ply");
}

std::string stl_fault(const std::string& text) {
  return fault_of(text, "a.stl");
}

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  return text.replace(text.find(from), from.size(), to);
}

const test::PolygonSurface box = test::box_surface({0, 0, 0}, {1, 1, 1});
const TriangleSurface triangles = test::fans_of(box);

}  // namespace

TEST_CASE("Files that are none") {
  const std::string page = "\n<!DOCTYPE html>\n<html><body>404</body></html>\n";
  for (const char* name : {"a.stl", "a.obj", "a.ply"}) {
    CHECK(fault_of("", name) == name + std::string(": invalid surface file: it is empty; expected a surface"));
    CHECK(fault_of(page, name) == name + std::string(":1: invalid surface file: it is a web page; expected a surface"));
  }
  CHECK(stl_fault("v 0 0 0\n") == "a.stl:1: unknown text 'v'; expected 'solid', or a binary file of 84 + 50 n bytes");
  CHECK(stl_fault(std::string(20, '\0')) ==
        "a.stl: invalid file of 20 bytes, neither text nor binary STL; expected at least 84");
  CHECK(obj_fault("hello world\n") ==
        "a.obj:1: unknown statement 'hello'; expected v, f, or what goes with polygons (vt, vn, g, o, s, usemtl, ...)");
  CHECK(ply_fault("plyplyply\x01\n") == "a.ply:1: invalid beginning 'plyplyply?' of the file; expected 'ply'");
  CHECK(stl_fault("solid nothing\nendsolid nothing\n") == "a.stl: missing faces; expected at least one");
  CHECK(stl_fault(test::binary_stl({})) == "a.stl: missing faces; expected at least one");
  CHECK(obj_fault("v 0 0 0\n# f 1 1 1\n") == "a.obj: missing faces; expected at least one");
  CHECK(ply_fault(test::ascii_ply({box.points, {}})) == "a.ply: missing faces; expected at least one");
}

TEST_CASE("Binary STL: its size, and numbers that are none") {
  const std::string bytes = test::binary_stl(triangles);
  CHECK(stl_fault(bytes.substr(0, 600)) ==
        "a.stl: invalid size of 600 bytes, less than needed; expected 684 for its 12 triangles");
  CHECK(stl_fault(bytes + "abc") ==
        "a.stl: invalid size of 687 bytes, more than needed; expected 684 for its 12 triangles");
  CHECK(stl_fault(test::binary_stl(triangles, "solid cut off").substr(0, 683)) ==
        "a.stl: invalid size of 683 bytes, less than needed; expected 684 for its 12 triangles");
  std::string many = bytes;
  many.replace(80, 4, "\xFF\xFF\xFF\xFF");
  CHECK(stl_fault(many) ==
        "a.stl: invalid size of 684 bytes, less than needed; expected 214748364834 for its 4294967295 triangles");
  TriangleSurface wrong = triangles;
  wrong.points[3][1] = std::numeric_limits<double>::quiet_NaN();
  CHECK(stl_fault(test::binary_stl(wrong)) ==
        "a.stl: triangle 1 of 12, byte 124: invalid coordinate y: nan; expected a finite number");
  wrong.points[3][1] = -std::numeric_limits<double>::infinity();
  CHECK(stl_fault(test::binary_stl(wrong)) ==
        "a.stl: triangle 1 of 12, byte 124: invalid coordinate y: -inf; expected a finite number");
}

TEST_CASE("ASCII STL: words in the wrong place") {
  const std::string text = test::ascii_stl(triangles);
  CHECK(stl_fault(text.substr(0, text.find("endloop"))) ==
        "a.stl:7: missing end of a solid: the file is truncated; expected 'endloop'");
  CHECK(stl_fault(replaced(text, "endsolid body\n", "")) ==
        "a.stl:85: missing end of a solid: the file is truncated; expected 'facet' or 'endsolid'");
  CHECK(stl_fault(replaced(text, "vertex 0 1 0", "vertex 0 1")) == "a.stl:5: missing coordinate z; expected a number");
  CHECK(stl_fault(replaced(text, "vertex 0 1 0", "vertex 0 one 0")) ==
        "a.stl:5: invalid coordinate y 'one'; expected a number");
  CHECK(stl_fault(replaced(text, "vertex 0 1 0", "vertex 0 1,5 0")) ==
        "a.stl:5: invalid coordinate y '1,5'; expected a number");
  CHECK(stl_fault(replaced(text, "vertex 0 1 0", "vertex 0 nan 0")) ==
        "a.stl:5: invalid coordinate y: nan; expected a finite number");
  CHECK(stl_fault(replaced(text, "endloop", "vertex 1 1 1")) == "a.stl:7: unknown text 'vertex'; expected 'endloop'");
  CHECK(stl_fault(text + "more\n") ==
        "a.stl:87: unknown text 'more'; expected 'solid', or a binary file of 84 + 50 n bytes");
}

TEST_CASE("OBJ: points and indices") {
  const std::string points = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";
  CHECK(obj_fault("v 0 0\n") == "a.obj:1: missing coordinate z; expected a number");
  CHECK(obj_fault("\nv 0 1e999 0\n") == "a.obj:2: invalid coordinate y '1e999'; expected a number");
  CHECK(obj_fault("v 0 -inf 0\n") == "a.obj:1: invalid coordinate y: -inf; expected a finite number");
  CHECK(obj_fault("v 0 2e60 0\n") ==
        "a.obj:1: out of range: coordinate y is 2e+60; expected a magnitude of at most 1e+60");
  CHECK(obj_fault("v 0 0 0 grey\n") == "a.obj:1: invalid weight or colour 'grey'; expected a number");
  CHECK(obj_fault("v 0 0 0 1 1 1 1 1\n") == "a.obj:1: invalid point of 8 numbers; expected 3, 4, 6 or 7");
  CHECK(obj_fault(points + "f 1 2\n") == "a.obj:5: invalid face of 2 corners; expected at least 3");
  CHECK(obj_fault(points + "f 1 2 \\\n0\n") ==
        "a.obj:6: out of range: index 0 of a point; expected one of the 4 points above, or a later one");
  CHECK(obj_fault(points + "f 1 2 -5\n") ==
        "a.obj:5: out of range: index -5 of a point; expected one of the 4 points above, or a later one");
  CHECK(obj_fault(points + "f 1 2 3\nf 1 2 5\n") == "a.obj:6: out of range: index 5 of a point; expected at most 4");
  CHECK(obj_fault(points + "f 1 2 99999999999\n") ==
        "a.obj:5: out of range: index 99999999999 of a point; expected one of the 4 points above, or a later one");
  CHECK(obj_fault(points + "f 1 2 3.5\n") ==
        "a.obj:5: invalid corner '3.5'; expected a, a/b, a//c or a/b/c of integers");
  for (const char* corner : {"3/", "3//", "3/1/", "/1", "3/1/1/1", "3/a", "3//b"})
    CHECK(obj_fault(points + "f 1 2 " + corner + "\n") ==
          fmt::format("a.obj:5: invalid corner '{}'; expected a, a/b, a//c or a/b/c of integers", corner));
  CHECK(obj_fault(points + "f 1 2 3 1\n") ==
        "a.obj:5: invalid face: corner 1 is given twice; expected different corners");
  CHECK(obj_fault("v 0 0 0\nv 2 0 0\nv 0 1 0\nv 1 1 0\nf 1 2 3 4\n") ==
        "a.obj:5: invalid face of 4 corners: it intersects itself; expected a simple polygon");
  CHECK(obj_fault(points + "curv 0 1 1 2 3\n").substr(0, 32) == "a.obj:5: unknown statement 'curv");
}

TEST_CASE("PLY: the header") {
  const std::string text = test::ascii_ply(box);
  const auto with = [&](const std::string& from, const std::string& to) { return ply_fault(replaced(text, from, to)); };
  CHECK(with("ascii 1.0", "ascii 2.0") == "a.ply:2: unknown version '2.0' of PLY; expected 1.0");
  CHECK(with("ascii", "utf8") ==
        "a.ply:2: unknown format 'utf8'; expected ascii, binary_little_endian or binary_big_endian");
  CHECK(with("format ascii 1.0\n", "") == "a.ply:9: missing format; expected 'format ascii 1.0' or a binary one");
  CHECK(with("vertex 8", "vertex -8") == "a.ply:4: invalid number '-8' of entries; expected an integer >= 0");
  CHECK(
      with("vertex 8", "vertex 4000000000") ==
      "a.ply:4: out of range: 4000000000 entries of vertex; expected at most 18, which the rest of the file can hold");
  CHECK(with("face 6", "face 2000000000") ==
        "a.ply:8: out of range: 2000000000 entries of face; expected at most 30, which the rest of the file can hold");
  CHECK(with("double y", "real y") ==
        "a.ply:6: unknown type 'real'; expected char, uchar, short, ushort, int, uint, "
        "float, double, or int8 to float64");
  CHECK(with("double y", "double x") == "a.ply:6: invalid second property x; expected different names");
  CHECK(with("double y", "double u") == "a.ply:4: missing property y of vertex; expected numbers x, y, z");
  CHECK(with("list uchar int", "list uchar float") ==
        "a.ply:8: missing list vertex_indices (or vertex_index) of face; expected a list of an integer type");
  CHECK(with("list uchar int", "list float int") ==
        "a.ply:9: invalid list with a length of type float; expected an integer type");
  CHECK(with("element face", "element tristrips") == "a.ply:10: missing element face; expected vertex and face");
  CHECK(with("element face", "element vertex") == "a.ply:8: invalid second element vertex; expected different names");
  CHECK(with("end_header", "endheader").substr(0, 40) == "a.ply:10: unknown statement 'endheader';");
  CHECK(ply_fault(text.substr(0, 44)) == "a.ply:3: missing end of the header; expected 'end_header'");
}

TEST_CASE("PLY: the entries") {
  const std::string text = test::ascii_ply(box);
  const auto with = [&](const std::string& from, const std::string& to) { return ply_fault(replaced(text, from, to)); };
  CHECK(with("1 1 0\n", "1 1\n") == "a.ply:14: missing coordinate z; expected a number");
  CHECK(with("1 1 0\n", "1 1 0 0\n") == "a.ply:14: unknown text '0'; expected the end of the line");
  CHECK(with("1 1 0\n", "1 x 0\n") == "a.ply:14: invalid coordinate y 'x'; expected a number");
  CHECK(with("4 0 2 3 1\n", "4 0 2 8 1\n") == "a.ply:19: out of range: index 8 of a point; expected 0 to 7");
  CHECK(with("4 0 2 3 1\n", "4 0 2 3\n") == "a.ply:19: missing index of a point; expected an integer");
  CHECK(with("4 0 2 3 1\n", "2 0 2\n") == "a.ply:19: invalid face of 2 corners; expected at least 3");
  CHECK(with("4 0 2 3 1\n", "4 0 2 3 0\n") ==
        "a.ply:19: invalid face: corner 0 is given twice; expected different corners");
  CHECK(with("4 1 3 7 5\n", "") == "a.ply:23: missing entries: the file is truncated; expected face 6 of 6");
  CHECK(with("4 1 3 7 5\n", "4 1 3 7 5\n\nmore") ==
        "a.ply:26: unknown text 'more' after the last entry; expected the end of the file");
  const std::string bytes = test::binary_ply<double>(box, std::endian::big);
  const std::size_t header = bytes.find("end_header\n") + 11;
  CHECK(ply_fault(bytes.substr(0, bytes.size() - 1)) ==
        fmt::format("a.ply: face 6 of 6, byte {}: missing bytes: the file is truncated; expected the rest of the entry",
                    header + 278));
  CHECK(ply_fault(bytes + "\n") ==
        fmt::format("a.ply: invalid content: 1 bytes follow the last entry, from byte {}; expected the end of the file",
                    header + 294));
  std::string wrong = bytes;
  wrong.replace(header + 16, 8, "\x7F\xF8\0\0\0\0\0\0", 8);
  CHECK(ply_fault(wrong) ==
        fmt::format("a.ply: vertex 1 of 8, byte {}: invalid coordinate z: nan; expected a finite number", header + 24));
  wrong = bytes;
  wrong[header + 192 + 3] = '\1';
  CHECK(ply_fault(wrong) ==
        fmt::format("a.ply: face 1 of 6, byte {}: out of range: index 256 of a point; expected 0 to 7", header + 197));
  CHECK(ply_fault(replaced(bytes, "vertex 8", "vertex 7")).substr(0, 6) == "a.ply:");
}
