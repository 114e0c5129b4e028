// SPDX-License-Identifier: Apache-2.0
// history.csv: exact numbers, restart, and faults with their line.
#include "io/results/history.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <limits>

#include "core/error.hpp"
#include "io/text_file.hpp"
#include "scratch_folder.hpp"

using namespace brunt;

namespace {
const std::vector<io::HistoryColumn> columns{{"time", "s"}, {"kinetic", "J"}, {"active_contacts", ""}};
}

TEST_CASE("history: header with units, and numbers that read back to the same bits") {
  const test::ScratchFolder folder(comm::Communicator::self());
  const std::vector<double> row{1.0 / 3, std::numeric_limits<double>::denorm_min(), -1e300};
  {
    io::HistoryFile file(folder / "history.csv", columns);
    file.write(7, row);
    CHECK(io::read_text(folder / "history.csv").find('\n') != std::string::npos);  // there before the file is closed
    file.write(8, std::vector<double>{std::nan(""), 0, 3});
  }
  CHECK(io::read_text(folder / "history.csv").rfind("step,time [s],kinetic [J],active_contacts\n7,", 0) == 0);
  const io::History history = io::read_history(folder / "history.csv");
  CHECK(history.names == std::vector<std::string>{"step", "time", "kinetic", "active_contacts"});
  REQUIRE(history.rows.size() == 2);
  CHECK(history.rows[0] == std::vector<double>{7, row[0], row[1], row[2]});
  CHECK(std::isnan(history.rows[1][1]));
}

TEST_CASE("history: a restart drops later rows and an unfinished one") {
  const test::ScratchFolder folder(comm::Communicator::self());
  const std::string path = folder / "history.csv";
  io::replace_text(path, "step,time [s],kinetic [J],active_contacts\n1,1,1,1\n5,2,2,2\n9,3,3,3\n4,0.");
  { io::HistoryFile(path, columns, 5).write(6, std::vector<double>{2.5, 0, 0}); }
  CHECK(io::read_text(path) == "step,time [s],kinetic [J],active_contacts\n1,1,1,1\n5,2,2,2\n6,2.5,0,0\n");
  CHECK_THROWS_WITH(io::HistoryFile(path, {{"time", "s"}}, 5), Catch::Contains(":1: invalid columns"));
}

TEST_CASE("history: faults are told with file and line; a disk that refuses is a MachineError") {
  const test::ScratchFolder folder(comm::Communicator::self());
  const std::string path = folder / "history.csv";
  io::replace_text(path, "step,time\n1,2\n2,x\n");
  CHECK_THROWS_WITH(io::read_history(path), Catch::Contains("history.csv:3: invalid value \"x\""));
  io::replace_text(path, "step,time\n1,2,3\n");
  CHECK_THROWS_WITH(io::read_history(path),
                    Catch::Contains("history.csv:2: invalid row of 3 values; expected one for each of 2 columns"));
  CHECK_THROWS_AS(io::read_history(folder / "none.csv"), InputError);
  CHECK_THROWS_AS(io::HistoryFile(folder / "none/history.csv", columns), MachineError);
}
