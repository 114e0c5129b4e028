// SPDX-License-Identifier: Apache-2.0
// MPI and PETSc for the lifetime of the program.
#pragma once

namespace brunt::comm {

/// Starts MPI, unless it runs, and PETSc. PETSc's signal handler is disabled, since it would intercept SIGTERM. Returns
/// whether MPI was started here.
bool start_libraries(int& argc, char**& argv);
/// Ends PETSc, and MPI where it was started here.
void end_libraries(bool mpi_too);

class Session {
 public:
  Session(int& argc, char**& argv) : owns_mpi_(start_libraries(argc, argv)) {}
  ~Session() { end_libraries(owns_mpi_); }
  Session(const Session&) = delete;
  Session& operator=(const Session&) = delete;

  /// Ends all ranks at once with this exit code, for a failure on one rank that the others cannot detect.
  [[noreturn]] static void abort(int exit_code);

 private:
  bool owns_mpi_;
};

}  // namespace brunt::comm
