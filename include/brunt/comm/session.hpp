// SPDX-License-Identifier: Apache-2.0
// MPI and PETSc for the life of the program.
#pragma once

namespace brunt::comm {

class Session {
 public:
  /// Starts MPI and PETSc (without PETSc's signal handler: it would swallow SIGTERM).
  Session(int& argc, char**& argv);
  ~Session();
  Session(const Session&) = delete;
  Session& operator=(const Session&) = delete;

  /// Ends all ranks at once with this exit code, when one rank fails where the others cannot know.
  [[noreturn]] static void abort(int exit_code);
};

}  // namespace brunt::comm
