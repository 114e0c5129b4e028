// SPDX-License-Identifier: Apache-2.0
#include "comm/session.hpp"

#include <mpi.h>
#include <petscsys.h>

#include <array>
#include <cstdlib>
#include <string>

#include "core/error.hpp"

namespace brunt::comm {

bool start_libraries(int& argc, char**& argv) {
  int runs = 0;
  MPI_Initialized(&runs);
  if (runs == 0) demand(MPI_Init(&argc, &argv) == MPI_SUCCESS, "MPI starts");
  // PETSc gets neither the program's arguments nor the user's ~/.petscrc, which would change results
  std::string name = argc > 0 ? argv[0] : "brunt";
  std::string skip = "-skip_petscrc";
  std::array<char*, 3> arguments{name.data(), skip.data(), nullptr};
  int count = 2;
  char** first = arguments.data();
  demand(PetscInitialize(&count, &first, nullptr, nullptr) == 0, "PETSc starts");
  demand(PetscPopSignalHandler() == 0, "PETSc gives up its signal handler");
  return runs == 0;
}

void end_libraries(bool mpi_too) {
  PetscFinalize();
  if (mpi_too) MPI_Finalize();
}

void Session::abort(int exit_code) {
  MPI_Abort(MPI_COMM_WORLD, exit_code);
  std::_Exit(exit_code);
}

}  // namespace brunt::comm
