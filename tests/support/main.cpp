// SPDX-License-Identifier: Apache-2.0
// One main for every test program: MPI and PETSc around Catch2.
#define CATCH_CONFIG_RUNNER
#include <catch2/catch.hpp>

#include "comm/session.hpp"

int main(int argc, char** argv) {
  const brunt::comm::Session session(argc, argv);
  return Catch::Session().run(argc, argv);
}
