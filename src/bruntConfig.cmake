# SPDX-License-Identifier: Apache-2.0
# find_package(brunt): the target brunt::brunt, with what it links.
include(CMakeFindDependencyMacro)
enable_language(C)
find_dependency(MPI 3.1 COMPONENTS C CXX)
find_dependency(PkgConfig)
if(NOT TARGET PkgConfig::PETSC)
  pkg_check_modules(PETSC REQUIRED QUIET IMPORTED_TARGET PETSc)
endif()
find_dependency(fmt)
find_dependency(yaml-cpp)
include(${CMAKE_CURRENT_LIST_DIR}/bruntTargets.cmake)
