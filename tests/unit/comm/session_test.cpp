// SPDX-License-Identifier: Apache-2.0
// What a session leaves to the program: its exit code, its signals, its user's files. Each test starts this test
// program again, as a process of its own, on one of the hidden tests at the end.
#include "comm/session.hpp"

#include <sys/wait.h>
#include <unistd.h>

#include <catch2/catch.hpp>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

namespace fs = std::filesystem;
using brunt::comm::Session;

namespace {

struct Ended {
  int status = 0;      // of waitpid
  std::string output;  // of both streams
};

/// The environment without what says that this process is an MPI rank already, and with another HOME.
std::vector<std::string> environment(const fs::path& home) {
  std::vector<std::string> kept{"HOME=" + home.string()};
  for (char** entry = environ; *entry; ++entry) {
    const std::string line = *entry;
    const bool rank = line.starts_with("PMIX_") || line.starts_with("OMPI_COMM_") || line.starts_with("OMPI_MCA_orte_");
    if (!rank && !line.starts_with("HOME=")) kept.push_back(line);
  }
  return kept;
}

Ended run_hidden(const std::string& tag, const std::string& petscrc = {}) {
  const fs::path home = fs::temp_directory_path() / ("brunt_session_" + std::to_string(getpid()));
  fs::create_directories(home);
  std::ofstream(home / ".petscrc") << petscrc;
  const fs::path output = home / "output";
  std::vector<std::string> lines = environment(home);
  std::vector<char*> pointers;
  for (std::string& line : lines) pointers.push_back(line.data());
  pointers.push_back(nullptr);
  const std::string program = fs::read_symlink("/proc/self/exe");
  Ended ended;
  const pid_t child = fork();
  if (child == 0) {
    for (const int stream : {STDOUT_FILENO, STDERR_FILENO})
      if (!std::freopen(output.c_str(), "a", stream == STDOUT_FILENO ? stdout : stderr)) _exit(99);
    execle(program.c_str(), program.c_str(), tag.c_str(), nullptr, pointers.data());
    _exit(98);
  }
  REQUIRE(waitpid(child, &ended.status, 0) == child);
  std::ifstream text(output);
  ended.output.assign(std::istreambuf_iterator<char>(text), {});
  fs::remove_all(home);
  return ended;
}

}  // namespace

TEST_CASE("abort ends the program with its code") {
  const Ended ended = run_hidden("[.abort]");
  INFO(ended.output);
  REQUIRE(WIFEXITED(ended.status));
  CHECK(WEXITSTATUS(ended.status) == 4);
}

TEST_CASE("SIGTERM reaches the program, not PETSc") {
  const Ended ended = run_hidden("[.terminate]");
  INFO(ended.output);
  CHECK(ended.output.find("PETSC ERROR") == std::string::npos);
  REQUIRE(WIFSIGNALED(ended.status));
  CHECK(WTERMSIG(ended.status) == SIGTERM);
}

TEST_CASE("the user's PETSc options change nothing") {
  const Ended ended = run_hidden("[.nothing]", "-options_view\n");
  INFO(ended.output);
  REQUIRE(WIFEXITED(ended.status));
  CHECK(WEXITSTATUS(ended.status) == 0);
  CHECK(ended.output.find("PETSc Option Table") == std::string::npos);
}

TEST_CASE("aborts", "[.abort]") {
  Session::abort(4);
}
TEST_CASE("is ended from outside", "[.terminate]") {
  std::raise(SIGTERM);
}
TEST_CASE("runs to its end", "[.nothing]") {
  SUCCEED();
}
