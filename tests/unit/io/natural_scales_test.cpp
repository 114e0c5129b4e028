// SPDX-License-Identifier: Apache-2.0
// Scales of quantities that are small differences of large ones.
#include "io/results/natural_scales.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <filesystem>
#include <limits>
#include <stdexcept>

#include "io/results/compare.hpp"
#include "io/results/state_file.hpp"
#include "io/text_file.hpp"
#include "scratch_folder.hpp"
#include "small_mesh.hpp"

using namespace brunt;

namespace {

const comm::Communicator& self() {
  static const comm::Communicator ranks = comm::Communicator::self();
  return ranks;
}

/// A result with this gap at every node and a history with these rows.
void write_result(const std::string& folder, double gap, const std::string& rows) {
  std::filesystem::create_directories(folder);
  const test::SmallMesh small(self());
  const std::vector<io::StateField> fields{{"gap", io::Place::node, 1, std::vector<double>(13, gap)}};
  io::StateFile(self(), folder, small.mesh).write(1, 1, fields);
  io::replace_text(folder + "/history.csv",
                   "step,time,kinetic,contact,total,mass,momentum_x,max_penetration,probe\n" + rows);
}

double relative(const io::Comparison& comparison, const std::string& name) {
  for (const io::FieldDifference& field : comparison.fields)
    if (field.field == name) return field.relative;
  throw std::out_of_range(name);
}

}  // namespace

TEST_CASE("natural scales: the size of the mesh is the diagonal of its box") {
  const test::ScratchFolder folder(self());
  write_result(folder / "a", 0, "");
  const io::Hdf5File file(self(), folder / "a/state.h5", io::Hdf5File::Mode::read);
  CHECK(io::size_of_mesh(file) == Approx(3));  // 2, 1, 2
  CHECK(io::natural_scale("gap", 3) == 3);
  CHECK(io::natural_scale("velocity", 3) == 0);
}

TEST_CASE("natural scales: terms of a sum have the largest of them, momenta their bound") {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const io::History a{{"step", "kinetic", "contact", "mass", "momentum_y", "max_penetration"},
                      {{0, 8, 1e-20, 4, 0, 0}}};
  const io::History b{{"step", "kinetic", "external"}, {{0, 2, -9}, {1, 2, nan}}};
  const std::vector<double> expected{0, 9, 9, 0, 8, 5};
  CHECK(io::natural_scales(a, b, 5) == expected);
}

TEST_CASE("compare: rounding of what cancels is no difference, what is larger is one") {
  const test::ScratchFolder folder(self());
  write_result(folder / "a", 1e-17, "1,1,8,1e-18,8,4,1e-18,1e-17,1e-17\n");
  write_result(folder / "b", -2e-17, "1,1,8,-1e-18,8,4,3e-18,2e-17,2e-17\n");
  const io::Comparison rounding = io::compare_results(self(), folder / "a", folder / "b");
  CHECK(relative(rounding, "node/gap") == Approx(1e-17));
  CHECK(relative(rounding, "history/contact") == Approx(2e-18 / 8));
  CHECK(relative(rounding, "history/momentum_x") == Approx(2e-18 / 8));
  CHECK(relative(rounding, "history/max_penetration") == Approx(1e-17 / 3));
  CHECK(relative(rounding, "history/probe") == Approx(0.5));  // nothing is known about its terms
  CHECK_FALSE(rounding.within(0));

  write_result(folder / "c", 3e-7, "1,1,8,1e-18,8,4,1e-18,1e-17,1e-17\n");
  const io::Comparison open = io::compare_results(self(), folder / "a", folder / "c");
  CHECK(relative(open, "node/gap") == Approx(1e-7));
  CHECK_FALSE(open.within(1e-8));
}
