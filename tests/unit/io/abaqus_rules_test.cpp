// SPDX-License-Identifier: Apache-2.0
// A bar of three cubes written in the ways that the Abaqus manuals allow: what each gives by hand, and what is refused.
#include <fmt/core.h>

#include <catch2/catch.hpp>
#include <cmath>

#include "abaqus_text.hpp"
#include "mesh/topology.hpp"

using namespace brunt;
using test::fault_of;
using test::read;

namespace {

/// Nodes 101, 111, ... at (x, y, z) with x slowest, for 3 x 1 x 1 cubes of edge 1.
std::string nodes(const std::string& keyword = "*NODE") {
  std::string text = keyword + "\n";
  for (int n = 0; n < 16; ++n) text += fmt::format("{}, {}, {}, {}\n", 101 + 10 * n, n / 4, n / 2 % 2, n % 2);
  return text;
}

const std::string elements = R"(*ELEMENT, TYPE=C3D8R, ELSET=BAR
1000, 101, 141, 161, 121, 111, 151, 171, 131
1005, 141, 181, 201, 161, 151, 191, 211, 171
1010, 181, 221, 241, 201, 191, 231, 251, 211
)";
const std::string section = "*SOLID SECTION, ELSET=BAR, MATERIAL=M\n";
const std::string bar = "*HEADING\nbar\n" + nodes() + elements + section;
const std::vector<LocalIndex> foot{0, 1, 2, 3};

std::vector<LocalIndex> foot_of(const std::string& text) {
  return read(text).node_sets.at("FOOT");
}

double volume_of(const mesh::Mesh& mesh) {
  double volume = 0;  // of prisms over the face of corners 0 to 3, which is right for the meshes of this file
  for (const mesh::Block& block : mesh.blocks)
    for (LocalIndex e = 0; e < block.count(); ++e) {
      const auto at = [&](int k) { return mesh.coordinates[static_cast<std::size_t>(block.element(e)[k])]; };
      volume += 0.5 * (at(2) - at(0)).cross(at(3) - at(1)).dot(at(4) - at(0));
    }
  return volume;
}

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  for (std::size_t at = text.find(from); at != std::string::npos; at = text.find(from, at + to.size()))
    text.replace(at, from.size(), to);
  return text;
}

}  // namespace

TEST_CASE("abaqus rules: sets by range, by elements, by name and before their nodes") {
  CHECK(foot_of(bar + "*NSET, NSET=FOOT\n101, 111, 121, 131\n") == foot);
  CHECK(foot_of(bar + "*NSET, NSET=FOOT, GENERATE\n101, 131, 10\n") == foot);
  CHECK(foot_of("*NSET, NSET=FOOT, GENERATE\n101, 131\n" + bar) == foot);
  CHECK(foot_of(bar + "*NSET, NSET=\"foot one\"\n101, 111, 121, 131\n*NSET, NSET=FOOT\n\"foot one\"\n") == foot);
  CHECK(foot_of(bar + "*ELSET, ELSET=E1\n1000\n*NSET, NSET=FOOT\n101, 111\n*NSET, NSET=FOOT, ELSET=E1\n").size() == 8);
  const mesh::Mesh gaps = read(bar + "*NSET, NSET=FOOT, GENERATE\n101, 131\n*ELSET, ELSET=ALL, GENERATE\n1, 99999\n");
  CHECK(gaps.node_sets.at("FOOT") == foot);
  REQUIRE(gaps.notes.size() == 3);  // the file may be truncated in its last set
  CHECK_THAT(gaps.notes[0] + gaps.notes[1] + gaps.notes[2],
             Catch::Contains("4 of its 31 numbers exist") && Catch::Contains("3 of its 99999 numbers exist"));
  const mesh::Mesh pushed = read(bar + "*ELSET, ELSET=\"last one\"\n1010\n*SURFACE, NAME=PUSH\n\"last one\", S4\n");
  CHECK(pushed.node_sets.at("PUSH") == std::vector<LocalIndex>{12, 13, 14, 15});
}

TEST_CASE("abaqus rules: a number with a point is no member of a set") {
  const std::string set = bar + "*NSET, NSET=FOOT\n";
  CHECK(fault_of(set + "101.0\n") == ":26: invalid value '101.0'; expected an integer, or the name of a set");
  CHECK(fault_of(set + "101.\n") == ":26: invalid value '101.'; expected an integer, or the name of a set");
  CHECK(fault_of(set + "I.101\n") == ":26: unknown instance 'I'; expected an instance defined above");
}

TEST_CASE("abaqus rules: sets of sets hold each member once") {
  const auto nested = [](int levels, const std::string& data) {
    std::string text = bar + "*NSET, NSET=S0\n101, 111, 121, 131, 101\n*ELSET, ELSET=E0\n1000, 1000\n";
    for (int k = 1; k <= levels; ++k)
      for (const std::string kind : {"NSET", "ELSET"}) {
        text += fmt::format("*{0}, {0}={1}{2}\n", kind, kind == "NSET" ? "S" : "E", k);
        text += replaced(replaced(data, "SET", kind == "NSET" ? "S" : "E"), "#", std::to_string(k - 1));
      }
    return text;
  };
  // with repeats, the last ones would have 8^30 and 4^30 members
  for (const std::string data :
       {"SET#, SET#, SET#, SET#, SET#, SET#, SET#, SET#\n", "SET#, SET#\nSET#\nSET#, SET0\n"}) {
    const std::string text = nested(30, data);
    CHECK(foot_of(text + "*NSET, NSET=FOOT\nS30, S29, S30\n") == foot);
    CHECK(foot_of(text + "*NSET, NSET=FOOT, ELSET=E30\n").size() == 8);
    const mesh::Mesh surfaces = read(text + "*SURFACE, NAME=ONE\nE30, S1\nE30, S1\nE30, S2\nE29, S1\n");
    CHECK(surfaces.side_sets.at("ONE").size() == 2);
  }
}

TEST_CASE("abaqus rules: an independent instance has its own mesh") {
  const std::string mesh = nodes() + elements + "*NSET, NSET=root, GENERATE\n101, 131, 10\n" + section;
  const auto assembly = [&](const std::string& place) {
    return "*PART, NAME=Rod\n" + mesh + "*END PART\n*PART, NAME=Pin\n*END PART\n*ASSEMBLY, NAME=A\n" +
           "*INSTANCE, NAME=Rod-1, PART=Rod\n*END INSTANCE\n*INSTANCE, NAME=Pin-1, PART=Pin\n" + place + mesh +
           "*END INSTANCE\n*NSET, NSET=FOOT, INSTANCE=Pin-1\nroot, 141\n*END ASSEMBLY\n";
  };
  const mesh::Mesh both = read(assembly("0., 5., 0.\n"));
  REQUIRE(both.blocks.size() == 2);
  CHECK(both.blocks[0].name == "Rod-1.BAR");
  CHECK(both.blocks[1].name == "Pin-1.BAR");
  CHECK(both.blocks[1].count() == 3);
  CHECK(volume_of(both) == Approx(6).epsilon(1e-14));
  CHECK(both.coordinates[16] == Vec3(0, 5, 0));
  CHECK(both.node_sets.at("FOOT") == std::vector<LocalIndex>{16, 17, 18, 19, 20});
  CHECK(both.node_sets.at("Rod-1.root") == foot);
  CHECK_THAT(fault_of(replaced(assembly(""), "PART=Pin", "PART=Rod")), Catch::Contains("its part has a mesh"));
  CHECK_THAT(fault_of(assembly("0, 5\n0, 0, 0, 0, 0, 1\n")), Catch::Contains("missing numbers of a rotation"));
  CHECK_THAT(fault_of(assembly("") + nodes()), Catch::Contains("invalid *NODE outside of parts"));
}

TEST_CASE("abaqus rules: nodes in cylindrical and spherical coordinates and in a local system") {
  const auto ring = [](char system) {
    std::string text = fmt::format("*NODE, SYSTEM={}\n", system);
    for (int n = 0; n < 16; ++n)  // radius 1 and 2, angles 0 to 90, height 0 and 1
      text += fmt::format("{}, {}, {}, {}\n", n + 1, 1 + n / 2 % 2, n / 4 * 30, n % 2);
    return text +
           "*ELEMENT, TYPE=C3D8R, ELSET=BAR\n1, 1, 3, 7, 5, 2, 4, 8, 6\n2, 5, 7, 11, 9, 6, 8, 12, 10\n"
           "3, 9, 11, 15, 13, 10, 12, 16, 14\n" +
           section;
  };
  CHECK(volume_of(read(ring('C'))) ==
        Approx(3 * 0.25 * (4 - 1)).epsilon(1e-14));  // sin(30) / 2 (R^2 - r^2), three times
  const mesh::Mesh sphere = read(replaced(ring('S'), ", 1\n", ", 60\n"));
  CHECK((sphere.coordinates[6] - Vec3(std::sqrt(3.), 1, 0)).norm() < 1e-15);
  CHECK((sphere.coordinates[5] - Vec3(std::sqrt(3.) / 4, 0.25, std::sqrt(3.) / 2)).norm() < 1e-15);
  const mesh::Mesh moved = read("*SYSTEM\n2, 0, 2\n" + bar);
  CHECK(moved.coordinates[15] == Vec3(5, 1, 3));
  const mesh::Mesh turned = read("*SYSTEM\n1, 1, 1, 1, 5, 9\n" + bar);  // x along global y, since z is kept
  CHECK((turned.coordinates[15] - Vec3(0, 4, 2)).norm() < 1e-15);
  const mesh::Mesh upright = read("*SYSTEM\n0, 0, 0, 0, 0, 2\n3, 0, 7\n" + bar);  // x along z, y along x, z along y
  CHECK((upright.coordinates[15] - Vec3(1, 1, 3)).norm() < 1e-15);
  CHECK_THAT(fault_of("*SYSTEM\n1, 1, 1, 1, 1, 9\n" + bar), Catch::Contains("do not define the axes"));
  CHECK_THAT(fault_of(replaced(bar, "*NODE", "*NODE, SYSTEM=X")), Catch::Contains("expected R, C or S"));
}

TEST_CASE("abaqus rules: byte-order marks, line ends, blank lines, numbers and names") {
  const std::string whole = bar + "*NSET, NSET=FOOT\n101, 111, 121, 131\n";
  for (const std::string& text :
       {"\xEF\xBB\xBF" + whole, std::string(50, '\n') + whole, replaced(whole, "\n", "\r\n"),
        replaced(whole, "\n", "\r"), replaced(whole, "\n", "\n** 1, 2\n"),
        replaced(whole, ", ELSET=BAR", ",\nelset = Bar"), replaced(whole, "*SOLID SECTION", "*solidsection"),
        replaced(whole, "\n101, 0, 0, 0", "\n+101, +.0D0, 0.e-3,")})
    CHECK(foot_of(text) == foot);
  using Catch::Contains;
  CHECK_THAT(fault_of("\xFF\xFE*\0N"), Contains("UTF-16"));
  CHECK_THAT(fault_of(replaced(whole, "101, 111, 121", "101, 111,, 121")), Contains("missing entry: a field is empty"));
  CHECK_THAT(fault_of(replaced(whole, "101, 111, 121", "\"101, 111, 121")), Contains("missing quotation mark"));
  CHECK_THAT(fault_of(replaced(whole, "111, 0, 0, 1", "111, 0, 0, +-1")), Contains("invalid value '+-1'"));
  CHECK_THAT(fault_of(replaced(whole, "NSET=FOOT\n", "NSET=\"Foot\"\n") + "*NSET, NSET=A\nFOOT\n"),
             Contains("unknown set 'FOOT'"));
  CHECK_THAT(fault_of(whole + "*NSET, NSET=A\nFOOT\n*NSET, NSET=FOOT\n141\n"), Contains("invalid addition to set"));
  CHECK_THAT(fault_of(whole + "*NSET, NSET=A\n999\n"), Contains("unknown node 999"));
  CHECK_THAT(fault_of(whole + "*NSET, NSET=A, GENERATE\n1, 9\n"), Contains("no node has one of these numbers"));
  CHECK_THAT(fault_of(whole + "*NSET, NSET=A, GENERATE\n1, 9, 3\n"), Contains("a step that leads from"));
}

TEST_CASE("abaqus rules: every keyword and parameter is read, without effect or refused") {
  using Catch::Contains;
  for (const char* word : {"NGEN", "NFILL", "NCOPY", "NMAP", "ELGEN", "ELCOPY", "PARAMETER", "IMPERFECTION", "ADJUST"})
    CHECK_THAT(fault_of(bar + fmt::format("*{}\n", word)),
               Contains("it would change the mesh") && Contains("expected"));
  CHECK_THAT(fault_of(replaced(bar, "*ELEMENT", "*ELEM")), Contains("expected *ELEMENT written in full"));
  CHECK_THAT(fault_of(replaced(bar, "ELSET=BAR\n1000", "ELS=BAR\n1000")),
             Contains("unknown parameter ELS of *ELEMENT"));
  CHECK_THAT(fault_of(replaced(bar, "*NODE", "*NODE, NSET=A, NSET=B")), Contains("given twice"));
  CHECK_THAT(fault_of(bar + "*SURFACE, NAME=A, COMBINE=UNION\nB, C\n"),
             Contains("invalid parameter COMBINE of *SURFACE"));
  CHECK(read(replaced(bar, ", MATERIAL=M", ", MATERIAL=M, CONTROLS=c, ORIENTATION=o")).notes.empty());
  CHECK(read(bar + "*DENSITY\n1,\n*CONTACT PAIR, INTERACTION=i\na, b\n").notes.empty());
  REQUIRE(read(bar + "*UNHEARD OF\n1, 2\n").notes.size() == 1);
  CHECK_THAT(read(bar + "*UNHEARD OF\n1, 2\n").notes[0], Contains("unknown keyword *UNHEARD OF"));
}

TEST_CASE("abaqus rules: a file that ends early is refused, or a note or fewer sets and elements tell it") {
  const std::string whole = "*HEADING\nbar\n" + nodes() + elements + "*NSET, NSET=FOOT\n101, 111,\n121, 131\n" +
                            section + "*STEP\n*DYNAMIC, EXPLICIT\n, 1.\n*END STEP\n";
  std::size_t read_with_a_note = 0, unseen = 0, at_bytes = 0;
  for (std::size_t end = whole.find('\n'); end + 1 < whole.size(); end = whole.find('\n', end + 1)) try {
      const mesh::Mesh mesh = read(whole.substr(0, end + 1));
      const bool all_nodes_used = mesh.blocks[0].count() == 3;
      ++(mesh.notes.empty() && all_nodes_used ? unseen : read_with_a_note);
    } catch (const InputError&) {
    }
  CHECK(unseen == 1);            // before *STEP, which a mesh need not have
  CHECK(read_with_a_note == 5);  // behind each element, and in and behind the set
  for (std::size_t end = whole.find("*NSET"); end < whole.find("*STEP"); ++end)
    if (whole[end - 1] != '\n' && fault_of(whole.substr(0, end)) == "none") ++at_bytes;
  CHECK(at_bytes == 4);  // within ", MATERIAL=M", which has no effect
  CHECK_THAT(fault_of(whole.substr(0, whole.find("*END STEP"))), Catch::Contains("missing end of this step"));
}
