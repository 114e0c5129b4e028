// SPDX-License-Identifier: Apache-2.0
// The ways a run can fail, one type each; the exit codes are the contract's.
#pragma once
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace brunt {

enum class ExitCode { done = 0, differs = 1, wrong_input = 2, guard = 3, machine = 4, on_request = 5 };

/// The user's input is wrong. One line a fault: where (file, line or key path), what, what is accepted.
class InputError : public std::runtime_error {
 public:
  explicit InputError(const std::string& fault);
  explicit InputError(std::vector<std::string> faults);
  [[nodiscard]] const std::vector<std::string>& faults() const { return faults_; }

 private:
  std::vector<std::string> faults_;
};

/// A physics guard stopped the run: NaN, inverted element, energy growth, step collapse.
class GuardError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// The machine failed the run: disk, memory, a lost rank, a library call that must not fail.
class MachineError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// A precondition between rooms, always checked; a failure is a bug of ours, never the user's.
void demand(bool holds, std::string_view what);

}  // namespace brunt
