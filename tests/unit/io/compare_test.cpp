// SPDX-License-Identifier: Apache-2.0
// Comparison: the size, time and place of the largest difference; what cannot be compared; NaN.
#include "io/results/compare.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <filesystem>

#include "core/error.hpp"
#include "io/results/checkpoint.hpp"
#include "io/text_file.hpp"
#include "scratch_folder.hpp"
#include "small_mesh.hpp"
#include "small_model.hpp"

using namespace brunt;

namespace {

struct Fixture {
  comm::Communicator self = comm::Communicator::self();
  test::ScratchFolder folder{self};
  test::SmallMesh small{self};
  std::string a = folder / "a", b = folder / "b";
  std::vector<io::StateField> fields = small.fields(10);
  Fixture() {
    std::filesystem::create_directories(a);
    std::filesystem::create_directories(b);
    write_state(a);
  }
  void write_state(const std::string& path) {
    io::StateFile file(self, path, small.mesh);
    file.write(0, 0, small.fields(0));
    file.write(10, 2.5, fields);
  }
  [[nodiscard]] io::Comparison compare() const { return io::compare_results(self, a, b); }
};

const io::FieldDifference& field(const io::Comparison& comparison, const std::string& name) {
  for (const io::FieldDifference& row : comparison.fields)
    if (row.field == name) return row;
  throw std::out_of_range(name);
}

}  // namespace

TEST_CASE_METHOD(Fixture, "compare: equal states are the same at tolerance 0") {
  write_state(b);
  CHECK(compare().within(0));
  CHECK_THAT(io::comparison_text(compare(), 0), Catch::Contains("\nsame"));
}

TEST_CASE_METHOD(Fixture, "compare: size, time and place of a difference") {
  fields[0].values[3 * 8 + 1] += 0.5;  // row 8 is node 4, number 104: the mesh lists nodes backwards
  write_state(b);
  const io::FieldDifference row = field(compare(), "node/displacement");
  // the other largest displacement is 0.01 * 6; node 4, y has (4 * 3 + 1) % 7 = 6 too, hence 0.56 in B
  CHECK(row.absolute == Approx(0.5));
  CHECK(row.relative == Approx(0.5 / 0.56));
  CHECK(row.time == 2.5);
  CHECK(row.where == "node 104 [1]");
  CHECK(compare().within(0.9));
  CHECK_FALSE(compare().within(0.8));
  CHECK(field(compare(), "element/stress").absolute == 0);
}

TEST_CASE_METHOD(Fixture, "compare: NaN differs from everything, itself included") {
  fields[1].values[0] = std::nan("");
  write_state(a);
  write_state(b);
  CHECK(std::isinf(field(compare(), "element/stress").absolute));
  CHECK_FALSE(compare().within(1e9));
}

TEST_CASE_METHOD(Fixture, "compare: other meshes, fields and record counts are differences") {
  SECTION("field") {
    fields.pop_back();
    write_state(b);
    CHECK_THAT(io::comparison_text(compare(), 1), Catch::Contains("element/alive is not in every record"));
  }
  SECTION("mesh") {
    small.mesh.coordinates[0] += 0.25;
    write_state(b);
    CHECK_THAT(io::comparison_text(compare(), 1), Catch::Contains("mesh: coordinates differs"));
  }
  SECTION("records") {
    io::StateFile(self, b, small.mesh).write(0, 0, small.fields(0));
    CHECK_THAT(io::comparison_text(compare(), 1), Catch::Contains("record: step 10 (time 2.5) is only in A"));
  }
  CHECK_FALSE(compare().within(1e9));
}

TEST_CASE_METHOD(Fixture, "compare: histories by column and step") {
  write_state(b);
  io::replace_text(a + "/history.csv", "step,time [s],kinetic\n1,0.1,8\n2,0.2,4\n");
  CHECK_FALSE(compare().within(1e9));  // B has none
  io::replace_text(b + "/history.csv", "step,time [s],kinetic\n1,0.1,8\n2,0.2,6\n");
  const io::FieldDifference row = field(compare(), "history/kinetic");
  CHECK(row.absolute == 2);
  CHECK(row.relative == 0.25);
  CHECK(row.where == "step 2");
  CHECK(row.time == 0.2);
}

TEST_CASE_METHOD(Fixture, "compare: records of the same step belong together, whatever stands between them") {
  {
    io::StateFile file(self, b, small.mesh);
    file.write(0, 0, small.fields(0));
    file.write(5, 1.25, small.fields(5));
    file.write(10, 2.5, fields);
  }
  io::replace_text(a + "/history.csv", "step,time,kinetic\n1,0.1,8\n4,0.4,3\n");
  io::replace_text(b + "/history.csv", "step,time,kinetic\n1,0.1,8\n2,0.2,9\n3,0.3,9\n4,0.4,3\n");
  const io::Comparison comparison = compare();
  CHECK(comparison.mismatches ==
        std::vector<std::string>{"record: step 5 (time 1.25) is only in B", "history rows: steps 2, 3 are only in B"});
  for (const io::FieldDifference& row : comparison.fields) CHECK(row.absolute == 0);
  CHECK_FALSE(comparison.within(1e9));
}

TEST_CASE_METHOD(Fixture, "compare: a folder stands for its file of the other side's kind") {
  write_state(b);
  io::replace_text(a + "/history.csv", "step,time,kinetic\n1,0.1,8\n");
  CHECK(io::compare_results(self, a + "/state.h5", b).within(0));
  CHECK(io::compare_results(self, a, b + "/state.h5").within(0));
  CHECK_THROWS_WITH(io::compare_results(self, a + "/history.csv", b),
                    Catch::Contains("b/history.csv: cannot read the file: it does not exist"));
}

TEST_CASE_METHOD(Fixture, "compare: checkpoints by table; kinds that do not fit are refused") {
  const test::SmallModel model(self);
  const std::string path_a = io::write_checkpoint(self, a, {1, 0.5, ""}, model.registry);
  model.registry.arrays[0].at(5, 2) = 3;
  const std::string path_b = io::write_checkpoint(self, b, {1, 0.5, ""}, model.registry);
  const io::Comparison comparison = io::compare_results(self, path_a, path_b);
  CHECK(field(comparison, "nodes/velocity").absolute == 3);
  CHECK(field(comparison, "nodes/velocity").where == "row 5 [2]");
  CHECK(field(comparison, "globals/clock").absolute == 0);
  CHECK_THROWS_AS(io::compare_results(self, path_a, a + "/state.h5"), InputError);
  CHECK(field(io::compare_results(self, path_a, b), "nodes/velocity").absolute == 3);
  CHECK_THROWS_AS(io::compare_results(self, path_a, folder / "none"), InputError);
}
