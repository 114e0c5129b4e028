// SPDX-License-Identifier: Apache-2.0
// MPI and PETSc for the lifetime of the program.
#pragma once

namespace brunt::comm {

class Session {
 public:
  /// Starts MPI and PETSc. PETSc's signal handler is disabled, since it would intercept SIGTERM.
  Session(int& argc, char**& argv);
  ~Session();
  Session(const Session&) = delete;
  Session& operator=(const Session&) = delete;

  /// Ends all ranks at once with this exit code, for a failure on one rank that the others cannot detect.
  [[noreturn]] static void abort(int exit_code);
};

}  // namespace brunt::comm
