// SPDX-License-Identifier: Apache-2.0
#include "comm/session.hpp"

#include <mpi.h>
#include <petscsys.h>
#include <unistd.h>

#include <array>
#include <cstdlib>
#include <filesystem>
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

/// Of Open MPI's own files, in a process without others; empty where it chose one itself.
std::filesystem::path own_folder;

void remove_own_folder() {
  std::error_code ignored;
  if (!own_folder.empty()) std::filesystem::remove_all(own_folder, ignored);
  own_folder.clear();
}

/// A process without others needs neither networks nor Open MPI's daemon beside it, which take nine tenths of its
/// start. Without the daemon all such processes would share one folder and names in shared memory: each has a folder of
/// its own, and none uses shared memory. Settings of the user are kept.
void start_alone() {
  setenv("OMPI_MCA_pml", "ob1", 0);
  if (getenv("OMPI_MCA_ess_singleton_isolated") || getenv("OMPI_MCA_orte_tmpdir_base")) return;
  std::error_code failed;
  std::string folder = (std::filesystem::temp_directory_path(failed) / "brunt.XXXXXX").string();
  if (failed || mkdtemp(folder.data()) == nullptr) return;
  own_folder = folder;
  std::atexit(remove_own_folder);
  setenv("OMPI_MCA_ess_singleton_isolated", "1", 1);
  setenv("OMPI_MCA_orte_tmpdir_base", folder.c_str(), 1);
  setenv("OMPI_MCA_btl", "self", 1);
}

}  // namespace

bool start_libraries(int& argc, char**& argv) {
  int runs = 0;
  MPI_Initialized(&runs);
  if (runs == 0 && !has_launcher()) start_alone();
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
  if (mpi_too) remove_own_folder();
}

void Session::abort(int exit_code) {
  remove_own_folder();
  MPI_Abort(MPI_COMM_WORLD, exit_code);
  std::_Exit(exit_code);
}

}  // namespace brunt::comm
