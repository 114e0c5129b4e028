// SPDX-License-Identifier: Apache-2.0
#include "brunt/session.hpp"

#include "comm/session.hpp"

namespace brunt::api {

Session::Session(int& argc, char**& argv) : owns_mpi_(comm::start_libraries(argc, argv)) {}

Session::~Session() {
  comm::end_libraries(owns_mpi_);
}

}  // namespace brunt::api
