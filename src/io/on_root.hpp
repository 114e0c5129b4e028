// SPDX-License-Identifier: Apache-2.0
// Work of one rank for all: files other than HDF5.
#pragma once
#include <filesystem>
#include <string>
#include <utility>

#include "comm/communicator.hpp"
#include "core/error.hpp"

namespace brunt::io {

/// Runs `work` on the root rank; if it throws, all ranks throw the same InputError or MachineError. Collective.
template <class Work>
void on_root(const comm::Communicator& ranks, Work&& work) {
  std::string wrong_input;
  std::string machine_fault;
  if (ranks.is_root()) {
    try {
      std::forward<Work>(work)();
    } catch (const InputError& error) {
      wrong_input = error.what();
    } catch (const MachineError& error) {
      machine_fault = error.what();
    } catch (const std::filesystem::filesystem_error& error) {
      machine_fault = error.path1().string() + ": " + error.code().message();
    }
  }
  ranks.broadcast(wrong_input);
  ranks.broadcast(machine_fault);
  if (!wrong_input.empty()) throw InputError(wrong_input);
  if (!machine_fault.empty()) throw MachineError(machine_fault);
}

}  // namespace brunt::io
