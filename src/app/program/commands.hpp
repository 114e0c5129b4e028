// SPDX-License-Identifier: Apache-2.0
// The commands other than `run`. Each is collective, returns the exit code and throws InputError on all ranks.
#pragma once
#include <string>
#include <vector>

#include "comm/communicator.hpp"
#include "depth_options.hpp"

namespace brunt::app {

struct CheckOptions {
  std::string scene;
  std::vector<std::string> overrides;
  bool all = false;  ///< every overlap, not only the deepest ones
};
/// Parts, masses, sets, supports, loads, contact, stable step, gaps and overlaps at the start, estimated cost.
int check(const comm::Communicator& ranks, const CheckOptions& options);

struct PartitionOptions {
  std::string scene;
  std::vector<std::string> overrides;
  int parts = 1;
  std::string from;   ///< checkpoint, or result folder, whose measured times are the weights; empty: estimates
  std::string write;  ///< folder for `brunt run --partition`; empty: none
};
int partition(const comm::Communicator& ranks, const PartitionOptions& options);

struct CompareOptions {
  std::string a, b;
  double tolerance = 0;
};
int compare(const comm::Communicator& ranks, const CompareOptions& options);

struct SearchOptions {
  std::string file, method = "blocks";
  int repeat = 1;
  bool list = false;
};
int search(const comm::Communicator& ranks, const SearchOptions& options);

/// Penetration depth of two surfaces, or of the parts of a scene: see depth_options.hpp.
int depth_command(const comm::Communicator& ranks, const DepthOptions& options);

struct InfoOptions {
  bool keys = false;  ///< the keys of a scene, instead of version and libraries
  bool json = false;  ///< of keys: for programs
};
int info(const comm::Communicator& ranks, const InfoOptions& options);
std::string version();

}  // namespace brunt::app
