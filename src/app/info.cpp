// SPDX-License-Identifier: Apache-2.0
#include <fmt/core.h>
#include <metis.h>
#include <petscversion.h>

#include <CLI/Version.hpp>
#include <Eigen/Core>

#include "app/program/commands.hpp"
#include "comm/native.hpp"
#include "core/simd.hpp"
#include "info_keys.hpp"

namespace brunt::app {

std::string version() {
  return "brunt " BRUNT_VERSION;
}

int info(const comm::Communicator& ranks, const InfoOptions& options) {
  if (!ranks.is_root()) return 0;
  if (options.keys) {
    fmt::print("{}", options.json ? keys_as_json() : keys_as_text());
    return 0;
  }
  char mpi[MPI_MAX_LIBRARY_VERSION_STRING];
  int length = 0;
  MPI_Get_library_version(mpi, &length);
  const std::string library(mpi, static_cast<std::size_t>(length));
  fmt::print("{}\n", version());
  fmt::print("compiled     {} for {}\n", __VERSION__, BRUNT_PORTABLE ? "any CPU with AVX2" : "the CPU of the build");
  fmt::print("MPI          {}\n", library.substr(0, library.find(',')));
  fmt::print("PETSc        {}.{}.{}\n", PETSC_VERSION_MAJOR, PETSC_VERSION_MINOR, PETSC_VERSION_SUBMINOR);
  fmt::print("METIS        {}.{}.{}\n", METIS_VER_MAJOR, METIS_VER_MINOR, METIS_VER_SUBMINOR);
  fmt::print("Eigen        {}.{}.{}\n", EIGEN_WORLD_VERSION, EIGEN_MAJOR_VERSION, EIGEN_MINOR_VERSION);
  fmt::print("limits       2^31 - 1 nodes or elements on each rank, and in the mesh that the root reads\n");
  fmt::print(
      "elements     hex8 (one point, hourglass control), hex8_full (2x2x2), hex8_bbar (2x2x2, B-bar), tet4;\n"
      "             shells shell4 (one point, hourglass control), shell4_full (2x2), shell3\n");
  fmt::print("materials    elastic, j2 (linear or tabulated, isotropic to kinematic), neo_hookean, rigid\n");
  fmt::print("             johnson_cook, piecewise_linear, hydrodynamic, crushable_foam; damage and erosion\n");
  fmt::print("             equations of state mie_gruneisen, linear_polynomial\n");
  fmt::print("stress rates jaumann, logarithmic (elastic, j2)\n");
  fmt::print(
      "contact      node to face and edge to edge, between bodies and of a body with itself, Coulomb friction\n");
  fmt::print("             methods rate, row_sum, printed, kinematic, gap_penalty, penalty, reference\n");
  fmt::print(
      "meshes       Exodus II, Gmsh 2.2 and 4.1 ASCII, Abaqus .inp; box, cylinder, sphere, tube, torus, plate\n");
  return 0;
}

}  // namespace brunt::app
