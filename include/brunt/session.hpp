// SPDX-License-Identifier: Apache-2.0
// Start of the libraries that Brunt uses. Every function of include/brunt/ may be called while a Session lives, by all
// ranks of the communicator that it is given (they are collective), and throws an exception derived from
// std::exception, the same on all ranks, where its arguments are wrong.
#pragma once

namespace brunt::api {

/// MPI, unless the program has started it, and PETSc.
class Session {
 public:
  Session(int& argc, char**& argv);
  ~Session();
  Session(const Session&) = delete;
  Session& operator=(const Session&) = delete;

 private:
  bool owns_mpi_ = false;
};

}  // namespace brunt::api
