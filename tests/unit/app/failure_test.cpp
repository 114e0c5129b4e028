// SPDX-License-Identifier: Apache-2.0
// Exit codes of what goes wrong, and faults that the root tells.
#include "app/program/failure.hpp"

#include <catch2/catch.hpp>
#include <cstdlib>

#include "prepared_scene.hpp"

using namespace brunt;

TEST_CASE("failure: each kind of fault has its exit code") {
  const comm::Communicator self = comm::Communicator::self();
  CHECK(app::guarded(self, [] { return 0; }) == 0);
  CHECK(app::guarded(self, [] { return 5; }) == 5);
  CHECK(app::guarded(self, []() -> int { throw InputError("a fault of the test"); }) == 2);
  CHECK(app::guarded(self, []() -> int { throw GuardError("a guard of the test"); }) == 3);
  CHECK(app::guarded(self, []() -> int { throw MachineError("a machine of the test"); }) == 4);
  CHECK(app::guarded(self, []() -> int { throw std::bad_alloc(); }) == 4);
}

TEST_CASE("failure: all faults of the root are thrown, line by line; none, nothing") {
  const comm::Communicator self = comm::Communicator::self();
  CHECK_NOTHROW(app::share_faults(self, {}));
  const std::vector<std::string> faults{"first", "second fault"};
  try {
    app::share_faults(self, faults);
    FAIL("nothing thrown");
  } catch (const InputError& error) {
    CHECK(error.faults() == faults);
  }
  bool called = false;
  app::on_root(self, [&] { called = true; });
  CHECK(called);
  CHECK_THROWS_AS(app::on_root(self, [] { throw InputError("of the root"); }), InputError);
  CHECK_THROWS_AS(app::on_root(self, [] { throw GuardError("not the user's"); }), GuardError);
}

TEST_CASE("failure: the exit code goes into the file that the environment names") {
  const support::SceneFolder folder;
  CHECK(app::leave_exit_code(3, true) == 3);
  setenv("BRUNT_EXIT_FILE", folder.file("code").c_str(), 1);
  CHECK(app::leave_exit_code(3, false) == 0);
  CHECK_FALSE(std::filesystem::exists(folder.file("code")));
  CHECK(app::leave_exit_code(3, true) == 0);
  unsetenv("BRUNT_EXIT_FILE");
  int code = 0;
  std::ifstream(folder.file("code")) >> code;
  CHECK(code == 3);
}
