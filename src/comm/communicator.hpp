// SPDX-License-Identifier: Apache-2.0
// The ranks of a run. Every function is collective unless stated otherwise. mpi.h is included by comm/native.hpp only.
#pragma once
#include <cstddef>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "core/types.hpp"

namespace brunt::comm {

class Communicator {
 public:
  /// A private copy of all ranks (MPI must be initialised, see comm/session.hpp).
  static Communicator world();
  /// This rank alone: for tests and for commands that run on one rank.
  static Communicator self();

  [[nodiscard]] Rank rank() const;  // not collective
  [[nodiscard]] int size() const;   // not collective
  [[nodiscard]] bool is_root() const { return rank() == 0; }

  void barrier() const;
  [[nodiscard]] double max(double value) const;  ///< a NaN on any rank is NaN on all, here and in `min`
  [[nodiscard]] double min(double value) const;
  void max(std::span<double> values) const;  ///< element by element, in place
  /// The same while other messages are in progress: `values` are undefined between begin and end. One reduction at a
  /// time.
  void begin_max(std::span<double> values) const;
  void end_max(std::span<double> values) const;
  [[nodiscard]] GlobalIndex sum(GlobalIndex value) const;
  void sum(std::span<GlobalIndex> values) const;  ///< wraps modulo 2^64, so it is exact in any order
  /// Both in one message, in place; at most six of each. Sums wrap modulo 2^64.
  void max_and_sum(std::span<double> largest, std::span<GlobalIndex> sums) const;
  [[nodiscard]] GlobalIndex max(GlobalIndex value) const;
  [[nodiscard]] bool any(bool value) const;
  [[nodiscard]] GlobalIndex sum_before(GlobalIndex value) const;  ///< sum over the ranks below this one

  void broadcast(std::vector<std::byte>& bytes, Rank root = 0) const;
  void broadcast(std::string& text, Rank root = 0) const;
  /// The bytes of each rank, by rank, on `root`; empty elsewhere.
  [[nodiscard]] std::vector<std::vector<std::byte>> gather(std::span<const std::byte> bytes, Rank root = 0) const;
  /// The bytes that `root` creates for this rank. `for_rank` is called on `root` only, once for each rank, and its
  /// result is sent at once.
  [[nodiscard]] std::vector<std::byte> scatter(const std::function<std::vector<std::byte>(Rank)>& for_rank,
                                               Rank root = 0) const;
  [[nodiscard]] std::vector<double> gather_all(double value) const;

 private:
  struct Native;
  explicit Communicator(std::shared_ptr<Native> native);
  std::shared_ptr<Native> native_;
  friend struct NativeAccess;  // comm/native.hpp
};

}  // namespace brunt::comm
