// SPDX-License-Identifier: Apache-2.0
// Abaqus files in pieces: found from the file that names them, with faults that name file and line.
#include <fmt/format.h>

#include <catch2/catch.hpp>
#include <filesystem>
#include <fstream>

#include "core/error.hpp"
#include "io/mesh/mesh_file.hpp"
#include "unit/io/own_folder.hpp"

using namespace brunt;

namespace {

const std::string nodes = "1,0,0,0\n2,1,0,0\n3,1,1,0\n4,0,1,0\n5,0,0,1\n6,1,0,1\n7,1,1,1\n8,0,1,1\n";
const std::string cube = "1,1,2,3,4,5,6,7,8\n";

struct Files {
  test::OwnFolder folder{"include"};
  void put(const std::string& name, const std::string& text) const {
    const std::filesystem::path path = std::filesystem::path(folder.path) / name;
    std::filesystem::create_directories(path.parent_path());
    std::ofstream(path) << text;
  }
  [[nodiscard]] std::string fault() const {
    try {
      io::read_mesh(folder.path + "/main.inp");
    } catch (const InputError& error) {
      std::string what = error.what();
      for (auto at = what.find(folder.path + "/"); at != std::string::npos; at = what.find(folder.path + "/"))
        what.erase(at, folder.path.size() + 1);
      return what;
    }
    return "none";
  }
};

}  // namespace

TEST_CASE("an included file stands where it is named", "[include]") {
  for (const std::string word :
       {"*INCLUDE, INPUT=sub/a.inp\n", "*include,input = \"sub/a.inp\"\n", "*Include,\n INPUT=sub/a.inp\n"}) {
    Files files;
    files.put("main.inp", "*Heading\nx\n" + word + "*Elset, elset=more\n1\n*Nset, nset=foot\n1, 2\n");
    files.put("sub/a.inp", "** nodes\n*Node\n*Include, input=deeper/n.inp\n*Include, input=../e.inp\n");
    files.put("sub/deeper/n.inp", nodes);  // data of the card before
    files.put("e.inp", "*Element, type=C3D8, elset=all\n" + cube);
    const mesh::Mesh mesh = io::read_mesh(files.folder.path + "/main.inp");
    REQUIRE(mesh.blocks.size() == 1);
    CHECK(mesh.blocks[0].name == "all");
    CHECK(mesh.coordinates.size() == 8);
    CHECK(mesh.node_sets.at("foot").size() == 2);
  }
  Files files;  // data from a file of their own
  files.put(
      "main.inp",
      "*Node, input=n.txt, nset=every\n*Element, type=C3D8, elset=all, input=e.txt\n*Nset, nset=one, input=s.txt\n");
  files.put("n.txt", nodes);
  files.put("e.txt", cube);
  files.put("s.txt", "every\n");
  CHECK(io::read_mesh(files.folder.path + "/main.inp").node_sets.at("one").size() == 8);
}

TEST_CASE("what is wrong with an inclusion is one fault at its line", "[include]") {
  const auto fault = [](const std::string& main, const std::string& other = "", const std::string& third = "") {
    Files files;
    files.put("main.inp", main);
    if (!other.empty()) files.put("a.inp", other);
    if (!third.empty()) files.put("sub/b.inp", third);
    return files.fault();
  };
  CHECK_THAT(fault("*Heading\n*Include, input=no.inp\n"),
             Catch::StartsWith("main.inp:2: cannot read the included file 'no.inp'"));
  CHECK_THAT(fault("*Heading\n*Include, input=no.inp\n"), Catch::Contains("does not exist"));
  CHECK_THAT(fault("*Include, input=a.inp\n", "** nothing\n"), Catch::Contains("missing solid elements"));
  CHECK_THAT(fault("*Include\n"), Catch::StartsWith("main.inp:1: missing file of *INCLUDE"));
  CHECK_THAT(fault("*Include, input=.\n"), Catch::Contains("main.inp:1") && Catch::Contains("not a regular file"));
  CHECK_THAT(fault("*Include, input=/dev/zero\n"), Catch::Contains("not a regular file"));
  CHECK_THAT(fault("\n*Include, input=main.inp\n"),
             Catch::Contains("main.inp:2: invalid included file 'main.inp'") && Catch::Contains("includes itself"));
  CHECK_THAT(fault("*Include, input=a.inp\n", "*Node\n\n*Include, input=sub/b.inp\n", "*Include, input=../a.inp\n"),
             Catch::StartsWith("sub/b.inp:1: invalid included file '../a.inp'") && Catch::Contains("includes itself"));
  // faults within, before and behind an included file
  CHECK_THAT(fault("*Include, input=a.inp\n", "*Node\n1, 0, 0, 0\n\n2, x, 0, 0\n"),
             Catch::StartsWith("a.inp:4: invalid value 'x'"));
  CHECK_THAT(fault("*Node\n*Include, input=a.inp\n\n1, 0, 0, 0\n2, y, 0, 0\n", "11, 0, 0, 0\n12, 0, 0, 0\n"),
             Catch::StartsWith("main.inp:5: invalid value 'y'"));
  CHECK_THAT(fault("*Node\nz, 0, 0, 0\n*Include, input=a.inp\n", "*Node\n1, 0, 0, 0\n"),
             Catch::StartsWith("main.inp:2: invalid value 'z'"));
  CHECK_THAT(fault("*Include, input=a.inp\n*Element, type=C3D4\n1, 1, 2, 3, 9\n",
                   "*Node\n1,0,0,0\n*Include, input=sub/b.inp\n3,0,1,0\n", "2,1,0,0\n"),
             Catch::StartsWith("main.inp:3: unknown node 9"));
  CHECK_THAT(fault("*Include, input=a.inp\n", "*Node\n1,0,0,0\n*Include, input=sub/b.inp\n2,q,1,0\n", "3,1,0,0\n"),
             Catch::StartsWith("a.inp:4: invalid value 'q'"));
}

TEST_CASE("a note says that the end of each included file cannot be checked", "[include]") {
  const std::string main = "*Node, input=n.txt\n*Element, type=C3D8, elset=all, input=e.txt\n";
  const std::string foot = "*Nset, nset=foot\n1, 2,\n", section = "*Solid Section, elset=all\n";
  const auto notes = [](const std::string& text, const std::string& sets) {
    Files files;
    files.put("main.inp", text);
    files.put("n.txt", nodes);
    files.put("e.txt", cube);
    files.put("s.txt", sets);
    std::string all;
    for (const std::string& note : io::read_mesh(files.folder.path + "/main.inp").notes) all += note + '\n';
    return all;
  };
  const auto says = [](const std::string& place, const std::string& card, const std::string& more = "") {
    return Catch::Contains(place + ": the file ends with *" + card + ": whether it is truncated cannot be checked" +
                           more + "\n");
  };
  const std::string whole = "*Node\n" + nodes + "*Element, type=C3D8, elset=all\n" + cube;
  CHECK_THAT(notes(whole + "*Nset, nset=foot, input=s.txt\n" + section, "1, 2,\n"), says("s.txt:1", "NSET"));
  CHECK_THAT(notes(whole + "*Include, input=s.txt\n" + section, "** sets\n" + foot + "\n** end\n"),
             says("s.txt:3", "NSET"));
  CHECK_THAT(notes(whole + foot + "*Include, input=s.txt\n" + section, "3, 4\n"), says("s.txt:1", "NSET"));
  CHECK_THAT(notes(main + section, ""), says("n.txt:8", "NODE", ", nor that of 1 more"));
  CHECK_THAT(notes(main + foot, ""), says("n.txt:8", "NODE", ", nor that of 2 more"));
  CHECK_THAT(notes(whole + "*Include, input=s.txt\n", foot + section), !Catch::Contains("truncated"));
  CHECK_THAT(notes("*Part, name=P\n" + whole +
                       "*End Part\n*Assembly, name=A\n*Instance, name=I, part=P\n*End Instance\n"
                       "*End Assembly\n*Nset, nset=foot, instance=I\n1, 2,\n",
                   ""),
             says("main.inp:19", "NSET"));
}

TEST_CASE("files that include each other without end are bounded", "[include]") {
  Files files;
  files.put("main.inp", "*Include, input=f0.inp\n*Include, input=f0.inp\n");
  for (int i = 0; i < 40; ++i)
    files.put(fmt::format("f{}.inp", i), fmt::format("*Include, input=f{0}.inp\n*Include, input=f{0}.inp\n", i + 1));
  files.put("f40.inp", "*Heading\n");
  CHECK_THAT(files.fault(), Catch::Contains("more than 32 nested included files"));
  files.put("f25.inp", "*Heading\n");
  CHECK_THAT(files.fault(), Catch::Contains("more than 10000 included files"));
}
