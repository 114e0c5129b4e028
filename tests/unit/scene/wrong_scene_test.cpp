// SPDX-License-Identifier: Apache-2.0
// One spoilt line at a time: the message must name the line, the key path, and what is wrong.
#include <algorithm>
#include <catch2/catch.hpp>

#include "core/error.hpp"
#include "scene/read/read.hpp"
#include "unit/scene/good_scene.hpp"

using namespace brunt;
using namespace brunt::scene;

namespace {

struct Wrong {
  std::string from, to;           ///< text of the small scene, and what it is spoilt to
  std::string where;              ///< the message's beginning
  std::vector<std::string> told;  ///< phrases of it
};

std::vector<std::string> faults_of(const std::string& text, std::vector<std::string> overrides = {}) {
  try {
    read_scene(text, "bar.yaml", overrides);
  } catch (const InputError& error) {
    return error.faults();
  }
  return {};
}

std::string spoilt(const std::string& from, const std::string& to) {
  std::string text(small_scene);
  const std::size_t at = text.find(from);
  REQUIRE(at != std::string::npos);
  return text.replace(at, from.size(), to);
}

void check_message(const std::vector<std::string>& faults, const std::string& where,
                   const std::vector<std::string>& told) {
  INFO("faults:\n" << InputError(faults).what());
  REQUIRE(faults.size() == 1);
  CHECK_THAT(faults[0], Catch::StartsWith(where + ": "));
  for (const std::string& phrase : told) CHECK_THAT(faults[0], Catch::Contains(phrase));
}

void check_all(const std::vector<Wrong>& table) {
  for (const Wrong& wrong : table) {
    INFO("spoilt: " << wrong.from << " -> " << wrong.to);
    check_message(faults_of(spoilt(wrong.from, wrong.to)), wrong.where, wrong.told);
  }
}

}  // namespace

TEST_CASE("wrong numbers", "[scene]") {
  check_all({
      {"7800", "-7800", "bar.yaml:16: materials.steel.density", {"out of range: -7800", "a number > 0"}},
      {"7800", "0", "bar.yaml:16: materials.steel.density", {"out of range"}},
      {"7800", "\"7800\"", "bar.yaml:16: materials.steel.density", {"quoted text '7800'", "a number > 0"}},
      {"7800", "7800 kg", "bar.yaml:16: materials.steel.density", {"'7800 kg'", "a number > 0"}},
      {"7800", "7,800", "bar.yaml:16: materials.steel.density", {"'7,800'", "no comma", "write 7800 or 7.800"}},
      {"7800", "'7,8'", "bar.yaml:16: materials.steel.density", {"'7,8'", "no comma", "write 7.8;"}},
      {"7800", "1,234,567", "bar.yaml:16: materials.steel.density", {"no comma", "write 1234567; expected"}},
      {"poisson: 0.3", "poisson: 0,3", "bar.yaml:18: materials.steel.poisson", {"no comma", "0.3"}},
      {"cfl: 0.9", "steps: 4,000", "bar.yaml:43: run.steps", {"no comma", "4000", "an integer"}},
      {"  end: 1.0e-3\n  cfl: 0.9",
       "  {end: 1,500, cfl: 0.9}",
       "bar.yaml:42: run.end",
       {"'1,500'", "no comma", "1500"}},
      {"at: [1, 0, 0]",
       "at: [1,5, 0, 0]",
       "bar.yaml:12: mesh.1.box.at",
       {"invalid list of 4 entries", "expected three numbers [x, y, z]", "no comma"}},
      {"7800", "", "bar.yaml:16: materials.steel.density", {"missing value"}},
      {"7800", "[1, 2]", "bar.yaml:16: materials.steel.density", {"invalid list of 2 entries", "a number > 0"}},
      {"2.0e11", ".inf", "bar.yaml:17: materials.steel.young", {"not a finite number"}},
      {"2.0e11", "nan", "bar.yaml:17: materials.steel.young", {"not a finite number"}},
      {"2.0e11", "1e999", "bar.yaml:17: materials.steel.young", {"not a finite number"}},
      {"0.3", "0.5", "bar.yaml:18: materials.steel.poisson", {"out of range", "> -1 and < 0.5"}},
      {"0.3", "-1", "bar.yaml:18: materials.steel.poisson", {"out of range"}},
      {"1.0e-3", "0", "bar.yaml:42: run.end", {"out of range: 0", "a number > 0"}},
      {"1.0e-3", "-1", "bar.yaml:42: run.end", {"out of range"}},
      {"cfl: 0.9", "cfl: 1.01", "bar.yaml:43: run.cfl", {"out of range", "> 0 and <= 1"}},
      {"cfl: 0.9", "min_step_ratio: 1", "bar.yaml:43: run.min_step_ratio", {"out of range: 1", "> 0 and < 1"}},
      {"cfl: 0.9", "min_step_ratio: 0", "bar.yaml:43: run.min_step_ratio", {"out of range"}},
      {"cfl: 0.9", "wall_limit: soon", "bar.yaml:43: run.wall_limit", {"'soon'", "3h55m"}},
      {"cfl: 0.9", "steps: 2.5", "bar.yaml:43: run.steps", {"invalid value '2.5'", "an integer"}},
      {"cfl: 0.9", "steps: 0", "bar.yaml:43: run.steps", {"out of range", "from 1"}},
      {"every: 1.0e-4", "every: 0", "bar.yaml:45: output.every", {"out of range"}},
      {"node: 1", "node: -1", "bar.yaml:39: probes.0.node", {"out of range"}},
      {"[2, 2, 2]", "[2, 2, 0]", "bar.yaml:7: mesh.0.box.elements.2", {"out of range", "from 1"}},
      {"[2, 2, 2]", "[2, 2]", "bar.yaml:7: mesh.0.box.elements", {"invalid list of 2 entries", "three integers"}},
      {"[2, 2, 2]",
       "[2000, 2000, 2000]",
       "bar.yaml:7: mesh.0.box.elements",
       {"out of range: 8e+09 elements", "expected at most"}},
      {"[1, 1, 1]", "[1, 1, -1]", "bar.yaml:6: mesh.0.box.size.2", {"out of range"}},
  });
}

TEST_CASE("wrong keys and words", "[scene]") {
  check_all({
      {"yield: 4.0e8",
       "yield: 4.0e8\n    hardning: 1.0e8",
       "bar.yaml:20: materials.steel.hardning",
       {"unknown key", "did you mean 'hardening'?"}},
      {"model: j2", "model: elastic", "bar.yaml:19: materials.steel.yield", {"unknown key"}},
      {"model: j2", "model: J3", "bar.yaml:15: materials.steel.model", {"unknown value 'J3'", "did you mean 'j2'"}},
      {"output:", "ouput:", "bar.yaml:44: ouput", {"unknown key", "did you mean 'output'?"}},
      {"cfl:", "clf:", "bar.yaml:43: run.clf", {"unknown key", "did you mean 'cfl'?"}},
      {"units: SI", "units: si", "bar.yaml:2: units", {"unknown value 'si'", "did you mean 'SI'?", "mm-ms-kg", "none"}},
      {"units: SI\n", "", "bar.yaml:1: units", {"missing", "mm-ms-kg"}},
      {"    density: 7800\n", "", "bar.yaml:14: materials.steel.density", {"missing", "a number > 0"}},
      {"    yield: 4.0e8\n", "", "bar.yaml:14: materials.steel.yield", {"missing"}},
      {"  end: 1.0e-3\n", "", "bar.yaml:41: run", {"missing end", "steps"}},
      {"run:\n  end: 1.0e-3\n  cfl: 0.9\n", "", "bar.yaml:1: run", {"missing"}},
      {"run:\n  end: 1.0e-3\n  cfl: 0.9\n", "run: 1.0e-3\n", "bar.yaml:41: run", {"invalid value '1.0e-3'", "a map"}},
      {"fields: [displacement]",
       "fields: [displacment]",
       "bar.yaml:46: output.fields.0",
       {"unknown value 'displacment'", "did you mean 'displacement'?"}},
      {"fields: [displacement]", "fields: displacement", "bar.yaml:46: output.fields", {"a list of fields"}},
      {"field: velocity",
       "field: reaction",
       "bar.yaml:40: probes.0.field",
       {"unknown value 'reaction'", "displacement, velocity, position"}},
      {"normal: [0, 0, 1]", "normal: [0, 0, 0]", "bar.yaml:32: rigid_walls.0.normal", {"zero vector"}},
      {"friction: 0", "parts: [left, axle]", "bar.yaml:33: rigid_walls.0.parts.1", {"unknown part 'axle'"}},
      {"friction: 0", "parts: [left, left]", "bar.yaml:33: rigid_walls.0.parts.1", {"each once"}},
      {"friction: 0", "parts: []", "bar.yaml:33: rigid_walls.0.parts", {"at least one part"}},
      {"friction: 0", "parts: left", "bar.yaml:33: rigid_walls.0.parts", {"a list"}},
      {"friction: 0", "bilateral: yes", "bar.yaml:33: rigid_walls.0.bilateral", {"true or false"}},
      {"    velocity: [1, 0, 0]\n", "", "bar.yaml:28: initial.0", {"missing velocity or rotation"}},
      {"velocity: [1, 0, 0]",
       "velocity: [1, 0, 0]\n    velocity: [2, 0, 0]",
       "bar.yaml:30: initial.0.velocity",
       {"given twice", "line 29"}},
      {"density: 7800",
       "density: 7800\n    density: 7850",
       "bar.yaml:17: materials.steel.density",
       {"given twice", "first in line 16"}},
      {"yield: 4.0e8",
       "hardening_table: [[0, 4.0e8], [0, 5.0e8]]",
       "bar.yaml:19: materials.steel.hardening_table.1",
       {"does not increase"}},
      {"yield: 4.0e8",
       "hardening_table: [[0, 4.0e8], [1, 3.0e8]]",
       "bar.yaml:19: materials.steel.hardening_table.1",
       {"invalid yield stress: it decreases"}},
      {"yield: 4.0e8",
       "hardening_table: [[0.1, 4.0e8]]",
       "bar.yaml:19: materials.steel.hardening_table.0",
       {"invalid plastic strain of the first point; expected 0"}},
      {"[[0, 0], [1, 1]]", "[[0, 0], [0, 1]]", "bar.yaml:26: curves.ramp.1", {"strictly increasing"}},
      {"[[0, 0], [1, 1]]", "[]", "bar.yaml:26: curves.ramp", {"a list of points"}},
      {"name: tip", "name: a,b", "bar.yaml:38: probes.0.name", {"invalid name 'a,b'"}},
  });
}

TEST_CASE("a mistyped key that is required is one fault", "[scene]") {
  check_all({
      {"density:",
       "densty:",
       "bar.yaml:16: materials.steel.densty",
       {"unknown key", "did you mean 'density'?", "yield"}},
      {"units:", "unit:", "bar.yaml:2: unit", {"did you mean 'units'?"}},
      {"materials:", "matrials:", "bar.yaml:13: matrials", {"did you mean 'materials'?"}},
      {"parts:", "part:", "bar.yaml:20: part", {"did you mean 'parts'?"}},
      {"  end: 1.0e-3", "  edn: 1.0e-3", "bar.yaml:42: run.edn", {"did you mean 'end'?"}},
      {"    velocity: [1, 0, 0]",
       "    velocty: [1, 0, 0]",
       "bar.yaml:29: initial.0.velocty",
       {"did you mean 'velocity'?"}},
      {"- part: left", "- prt: left", "bar.yaml:28: initial.0.prt", {"did you mean 'part'?"}},
      {"    node: 1", "    nod: 1", "bar.yaml:39: probes.0.nod", {"did you mean 'node'?"}},
      {"  - box:\n      part: left", "  - bx:\n      part: left", "bar.yaml:4: mesh.0.bx", {"did you mean 'box'?"}},
  });
  // what is not near is another matter
  const std::vector<std::string> two = faults_of(spoilt("density: 7800", "colour: 7800"));
  REQUIRE(two.size() == 2);
  CHECK_THAT(two[0], Catch::Contains("density: missing"));
  CHECK_THAT(two[1], Catch::Contains("colour: unknown key; expected one of "));
}

TEST_CASE("only a word that is near a known one is asked for", "[scene]") {
  const auto told = [](const std::string& good_text, const std::string& wrong) {
    const std::vector<std::string> faults = faults_of(spoilt(good_text, wrong));
    INFO(wrong);
    const auto unknown = std::ranges::find_if(
        faults, [](const std::string& fault) { return fault.find("unknown ") != std::string::npos; });
    REQUIRE(unknown != faults.end());
    return *unknown;
  };
  for (const std::string& fault : {told("units: SI", "units: mm"), told("- part: left", "- nodes: left"),
                                   told("material: steel", "material: wood"), told("[left, right]", "[left, ground]"),
                                   told("- part: left", "- part: ground")}) {
    INFO(fault);
    CHECK_THAT(fault, Catch::Contains("; expected one of "));
    CHECK_THAT(fault, !Catch::Contains("did you mean") && !Catch::Contains("nearest"));
  }
}

TEST_CASE("names that do not fit together", "[scene]") {
  check_all({
      {"material: steel",
       "material: stel",
       "bar.yaml:22: parts.left.material",
       {"unknown material 'stel'", "did you mean 'steel'?"}},
      {"- part: left", "- part: lefd", "bar.yaml:28: initial.0.part", {"unknown part 'lefd'", "did you mean 'left'?"}},
      {"friction: 0",
       "motion: ram",
       "bar.yaml:33: rigid_walls.0.motion",
       {"unknown curve 'ram'", "did you mean 'ramp'?"}},
      {"node: 1\n    field: velocity",
       "wall: wall1",
       "bar.yaml:39: probes.0.wall",
       {"unknown rigid wall 'wall1'", "did you mean 'wall0'?"}},
      {"[left, right]",
       "[left, rigth]",
       "bar.yaml:35: contact.0.between.1",
       {"unknown part 'rigth'", "did you mean 'right'?"}},
      {"  right:\n    material: steel\n",
       "  right: {material: steel, block: 7}\n",
       "bar.yaml:8: mesh.1",
       {"missing part of the generated body 'right'", "parts: {right:"}},
      {"  right:\n    material: steel\n",
       "  right: {material: steel}\n  middle: {material: steel}\n",
       "bar.yaml:24: parts.middle",
       {"unknown block 'middle'", "no body of the mesh has this name", "expected one of left, right"}},
      {"field: velocity",
       "field: velocity\n  - {name: tip, node: 2, field: velocity}",
       "bar.yaml:41: probes.1",
       {"invalid name 'tip': used twice"}},
      {"node: 1\n", "set: left\n    node: 1\n", "bar.yaml:38: probes.0", {"2 places are given"}},
      {"curves:\n",
       "sets:\n  left: {box: [[0, 0, 0], [1, 1, 1]]}\ncurves:\n",
       "bar.yaml:26: sets.left",
       {"invalid name: a part has the same name"}},
      {"curves:\n",
       "sets:\n  foot: {part: left, side_set: 3}\ncurves:\n",
       "bar.yaml:26: sets.foot",
       {"invalid selection"}},
      {"curves:\n",
       "sets:\n  foot: {box: [[0, 0, 1], [1, 1, 0]]}\ncurves:\n",
       "bar.yaml:26: sets.foot.box",
       {"invalid box: a lower bound exceeds the upper one"}},
  });
}

TEST_CASE("what later versions bring is recognised and refused", "[scene]") {
  const std::string not_yet = "unknown in this version";
  check_all({
      {"title: small", "space: axisymmetric", "bar.yaml:1: space", {not_yet, "expected 3d"}},
      {"material: steel", "material: steel\n    element: quad4", "bar.yaml:23: parts.left.element", {not_yet, "hex8"}},
      {"friction: 0", "friction: -0.1", "bar.yaml:33: rigid_walls.0.friction", {">= 0"}},
      {"slave: auto",
       "friction: {static: 0.2, kinetic: 0.3}",
       "bar.yaml:36: contact.0.friction.kinetic",
       {"kinetic coefficient 0.3: larger than the static one, 0.2"}},
      {"poisson: 0.3",
       "poisson: 0.3\n    stress_rate: 1.0",
       "bar.yaml:19: materials.steel.stress_rate",
       {"unknown value '1.0'", "jaumann, logarithmic"}},
      {"slave: auto",
       "rebuild: sometimes",
       "bar.yaml:36: contact.0.rebuild",
       {"invalid value 'sometimes'", "auto, random or an integer from 1"}},
      {"slave: auto", "rebuild: 0", "bar.yaml:36: contact.0.rebuild", {"out of range", "auto, random or an integer"}},
      {"slave: auto",
       "rebuild: 1.5",
       "bar.yaml:36: contact.0.rebuild",
       {"invalid value '1.5'", "auto, random or an integer"}},
      {"slave: auto", "competing: oldest", "bar.yaml:36: contact.0.competing", {"unknown value 'oldest'", "velocity"}},
      {"slave: auto", "self: 7", "bar.yaml:36: contact.0.self", {"true or false"}},
      {"slave: auto", "tied: 1", "bar.yaml:36: contact.0.tied", {"true or false"}},
      {"[left, right]\n    slave: auto", "[left, left]\n    tied: true", "bar.yaml:36: contact.0.tied", {"to itself"}},
      {"slave: auto", "tied: true\n    friction: 0.2", "bar.yaml:36: contact.0.tied", {"friction of tied parts"}},
      {"slave: auto", "tied: true\n    method: penalty", "bar.yaml:35: contact.0", {"tied", "rate or row_sum"}},
      {"slave: auto",
       "method: segments",
       "bar.yaml:36: contact.0.method",
       {"unknown value 'segments'", "rate, row_sum"}},
      {"slave: auto",
       "passes: two\n    friction: {static: 0.3, lag: 1}",
       "bar.yaml:36: contact.0.passes",
       {"passes: auto or one"}},
      {"slave: auto", "friction: {static: 0.3, lag: -1}", "bar.yaml:36: contact.0.friction.lag", {">= 0"}},
      {"slave: auto", "friction: {kinetic: 0.3}", "bar.yaml:36: contact.0.friction.static", {"missing"}},
      {"slave: auto", "friction: 0.1\n    method: reference", "bar.yaml:35: contact.0", {"has no friction"}},
      {"    slave: auto",
       "    tolerance: 1e-4\nenforcement:\n  tolerance: 1e-3",
       "bar.yaml:36: contact.0.tolerance",
       {"invalid value 1e-4: enforcement.tolerance is 1e-3", "expected the same value"}},
      {"    slave: auto", "enforcement:\n  tolerence: 1e-3", "bar.yaml:37: enforcement.tolerence", {"tolerance"}},
      {"    slave: auto", "enforcement:\n  tolerance: 2", "bar.yaml:37: enforcement.tolerance", {"> 0 and < 1"}},
      {"    slave: auto", "enforcement: rate", "bar.yaml:36: enforcement", {"a map {method: rate"}},
      {"    slave: auto",
       "    tied: true\nenforcement:\n  method: penalty",
       "bar.yaml:35: contact.0",
       {"tied", "rate or row_sum"}},
      {"slave: auto", "stiffness: 2.5", "bar.yaml:36: contact.0.stiffness", {"> 0 and <= 2"}},
      {"slave: auto",
       "passes: three",
       "bar.yaml:36: contact.0.passes",
       {"unknown value 'three'", "auto, one, two, mortar, averaged"}},
      {"slave: auto", "thickness: 0.1", "bar.yaml:36: contact.0.thickness", {not_yet, "auto"}},
      {"slave: auto",
       "initial_overlap: adjust",
       "bar.yaml:36: contact.0.initial_overlap",
       {"unknown value 'adjust'", "error, warn, move, place, offset"}},
      {"slave: auto",
       "initial_overlap: 0.1",
       "bar.yaml:36: contact.0.initial_overlap",
       {"error, warn, move, place, offset"}},
      {"slave: auto",
       "slave: middle",
       "bar.yaml:36: contact.0.slave",
       {"unknown value 'middle'", "first, second, left"}},
      {"[left, right]\n    slave: auto",
       "all\n    slave: first",
       "bar.yaml:36: contact.0.slave",
       {"invalid slave 'first'", "expected auto"}},
      {"[left, right]\n    slave: auto",
       "all\n    slave: right",
       "bar.yaml:36: contact.0.slave",
       {"invalid slave 'right' for between: all", "between: [a, b]"}},
  });
}

TEST_CASE("broken YAML", "[scene]") {
  check_message(faults_of(""), "bar.yaml:1", {"empty", "units"});
  check_message(faults_of("# nothing but a comment\n"), "bar.yaml:1", {"empty"});
  check_message(faults_of("just text"), "bar.yaml:1", {"invalid value 'just text'", "sections"});
  check_message(faults_of(spoilt("[0, 0, 1]", "[0, 0, 1")), "bar.yaml:32",
                {"invalid YAML, column 13", "missing closing"});
  check_message(faults_of(spoilt("  cfl: 0.9", "\tcfl: 0.9")), "bar.yaml:43", {"tab", "spaces"});
  check_message(faults_of(spoilt("title", " title")), "bar.yaml:2", {"second YAML document", "one column"});
  check_message(faults_of(spoilt("title: small", "title: @small")), "bar.yaml:1",
                {"invalid YAML, column 8", "first character '@'", "quotes"});
  check_message(faults_of(",title: a comma too many\n"), "bar.yaml:1", {"second YAML document"});
  check_message(faults_of(std::string("a: 1\0b: 2", 9)), "bar.yaml:1", {"zero bytes"});
}

TEST_CASE("meshes, decks and surfaces are no scenes", "[scene]") {
  const auto told = [](const std::string& text, const std::string& file) {
    try {
      (void)read_scene(text, file);
    } catch (const InputError& error) {
      REQUIRE(error.faults().size() == 1);
      return error.faults().front();
    }
    return std::string("no fault");
  };
  using Catch::Contains;
  for (const char* deck : {"*HEADING\n a bar\n*NODE\n", "** made by a generator\n*Node\n1, 0, 0, 0\n"})
    CHECK_THAT(told(deck, "deck.inp"),
               Contains("deck.inp:1: invalid scene") && Contains("Abaqus") && Contains("mesh: {file: deck.inp}"));
  for (const char* file : {"d.k", "d.key", "d.txt"})
    CHECK_THAT(told("$# a comment\n*KEYWORD\n*NODE\n", file), Contains("LS-DYNA deck, which is not read"));
  CHECK_THAT(told("*NODE\n", "d.k"), Contains("LS-DYNA deck"));
  CHECK_THAT(told("$MeshFormat\n4.1 0 8\n", "meshes/a.msh"), Contains("Gmsh") && Contains("mesh: {file: a.msh}"));
  CHECK_THAT(told(std::string("CDF\x02\0\0", 6), "a.exo"), Contains("Exodus") && Contains("mesh: {file: a.exo}"));
  CHECK_THAT(told(std::string("\x89HDF\r\n\0", 7), "a.e"), Contains("Exodus"));
  CHECK_THAT(told("solid a\nfacet normal 0 0 0\n", "a.stl"), Contains("surface") && Contains("brunt depth"));
  CHECK_THAT(told(std::string(84, '\0'), "a.STL"), Contains("surface"));
  CHECK_THAT(told("# made by a tool\nv 0 0 0\n", "a.obj"), Contains("surface"));
  CHECK_THAT(told("ply\nformat ascii 1.0\n", "a.ply"), Contains("surface"));
  CHECK_THAT(told("title: *anchor\n", "a.yaml"), Contains("unknown anchor"));
}

TEST_CASE("wrong overrides are named as such", "[scene]") {
  const std::string good(small_scene);
  check_message(faults_of(good, {"run.ned=1"}), "--set run.ned=1: run.ned", {"unknown key", "did you mean 'end'?"});
  check_message(faults_of(good, {"run.end=-1"}), "--set run.end=-1: run.end", {"out of range"});
  check_message(faults_of(good, {"run.end"}), "--set run.end", {"--set key.path=value"});
  check_message(faults_of(good, {"run.cfl="}), "--set run.cfl=", {"missing value", "null"});
  check_message(faults_of(good, {"run..end=1"}), "--set run..end=1", {"--set key.path=value"});
  check_message(faults_of(good, {"mesh.2.box.scale=1"}), "--set mesh.2.box.scale=1: mesh.2", {"no such entry"});
  check_message(faults_of(good, {"run.end.x=1"}), "--set run.end.x=1: run.end.x",
                {"the key above it has a single value"});
  check_message(faults_of(good, {"mesh.0.box.size=[1"}), "--set mesh.0.box.size=[1", {"invalid YAML"});
  check_message(faults_of(good, {"materials.steel.yield=\"3\""}),
                "--set materials.steel.yield=\"3\": materials.steel.yield", {"quoted text"});
}

TEST_CASE("all faults of a scene are told at once, in the order of its lines", "[scene]") {
  std::string text = spoilt("7800", "-1");
  text.replace(text.find("cfl: 0.9"), 8, "cfl: 2.0");
  text.replace(text.find("part: left\n    velocity"), 10, "part: lost");
  const std::vector<std::string> faults = faults_of(text, {"output.every=0"});
  REQUIRE(faults.size() == 4);
  CHECK_THAT(faults[0], Catch::StartsWith("bar.yaml:16: materials.steel.density: "));
  CHECK_THAT(faults[1], Catch::StartsWith("bar.yaml:28: initial.0.part: "));
  CHECK_THAT(faults[2], Catch::StartsWith("bar.yaml:43: run.cfl: "));
  CHECK_THAT(faults[3], Catch::StartsWith("--set output.every=0: output.every: "));
}
