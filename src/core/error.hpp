// SPDX-License-Identifier: Apache-2.0
// Error types of a run, one for each kind of failure; the exit codes are part of the interface.
#pragma once
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace brunt {

enum class ExitCode { done = 0, differs = 1, wrong_input = 2, guard = 3, machine = 4, on_request = 5 };

/// Wrong input. Each fault is one line: the place (file, line or key path), what is wrong, and what is expected.
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

/// The machine failed: disk, memory, a lost rank, or a library call that must not fail.
class MachineError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Checks a precondition between rooms. A failure is a bug of the program, not of the input.
void demand(bool holds, std::string_view what);

}  // namespace brunt
