// SPDX-License-Identifier: Apache-2.0
#include "comm/session.hpp"

#include <mpi.h>
#include <petscsys.h>
#include <unistd.h>

#include <array>
#include <cstdlib>
#include <string>
#include <string_view>

#include "core/error.hpp"

namespace brunt::comm {
namespace {

/// Whether mpirun, srun or another launcher has started this process.
bool has_launcher() {
  constexpr std::array<std::string_view, 6> prefixes{"OMPI_COMM_", "PMIX_", "PMI_", "SLURM_", "FLUX_", "JSM_"};
  for (char** entry = environ; *entry != nullptr; ++entry)
    for (const std::string_view prefix : prefixes)
      if (std::string_view(*entry).starts_with(prefix)) return true;
  return false;
}

}  // namespace

bool start_libraries(int& argc, char**& argv) {
  int runs = 0;
  MPI_Initialized(&runs);
  // A process without others need not look for networks, which takes half of its start; settings of the user are kept.
  // (Without Open MPI's daemon it would start faster still, but all such processes would share one session folder.)
  if (runs == 0 && !has_launcher()) setenv("OMPI_MCA_pml", "ob1", 0);
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
