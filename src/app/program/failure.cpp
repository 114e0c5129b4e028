// SPDX-License-Identifier: Apache-2.0
#include "failure.hpp"

#include <fmt/core.h>

#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <new>

#include "comm/session.hpp"

namespace brunt::app {
namespace {

int code_of(ExitCode code) {
  return static_cast<int>(code);
}

/// The other ranks may wait for this one in a collective call: only ending all of them releases them.
int fail_alone(const comm::Communicator& ranks, const std::string& what) {
  fmt::print(stderr, "brunt: rank {}: {}\n", ranks.rank(), what);
  leave_exit_code(code_of(ExitCode::machine), true);
  if (ranks.size() > 1) comm::Session::abort(code_of(ExitCode::machine));
  return code_of(ExitCode::machine);
}

}  // namespace

int guarded(const comm::Communicator& ranks, const std::function<int()>& command) {
  int code = code_of(ExitCode::done);
  try {
    code = command();
  } catch (const InputError& error) {  // thrown on all ranks
    if (ranks.is_root())
      for (const std::string& fault : error.faults()) fmt::print(stderr, "brunt: {}\n", fault);
    code = code_of(ExitCode::wrong_input);
  } catch (const GuardError& error) {  // thrown on all ranks
    if (ranks.is_root()) fmt::print(stderr, "brunt: stopped: {}\n", error.what());
    code = code_of(ExitCode::guard);
  } catch (const std::bad_alloc&) {
    return fail_alone(ranks, "out of memory");
  } catch (const std::exception& error) {
    return fail_alone(ranks, error.what());
  }
  std::fflush(stdout);
  return leave_exit_code(code, ranks.is_root());
}

void share_faults(const comm::Communicator& ranks, std::vector<std::string> faults, Rank from) {
  std::string text;
  for (const std::string& fault : faults) text += fault + '\n';
  ranks.broadcast(text, from);
  if (text.empty()) return;
  faults.clear();
  for (std::size_t first = 0; first < text.size();) {
    const std::size_t last = text.find('\n', first);
    faults.push_back(text.substr(first, last - first));
    first = last + 1;
  }
  throw InputError(std::move(faults));
}

int leave_exit_code(int code, bool root) {
  const char* path = std::getenv("BRUNT_EXIT_FILE");
  if (!path) return code;
  if (root) std::ofstream(path) << code << '\n';
  return 0;
}

}  // namespace brunt::app
