// SPDX-License-Identifier: Apache-2.0
// Searches of several metrics that exchange what they find. A motion that is found for one is a candidate for all that
// admit it, so rms <= DISP <= PDt holds for the answers as it does for the depths.
#pragma once
#include <array>
#include <optional>
#include <vector>

#include "depth/penetration_depth.hpp"
#include "search.hpp"
#include "small_motions.hpp"

namespace brunt::depth {

class JointSearch {
 public:
  /// bounds: of PDt, DISP, rms [length]. Metrics up to the asked one are searched; the careful mode
  /// takes the others as well where the answer is longer than its bound.
  JointSearch(Encounter& encounter, const Query& query, const Mat3& basis, const std::array<double, 3>& bounds);

  /// From the placements of the query alone.
  void try_placements();
  void run();
  /// The answer of a finished search, as a candidate.
  void take(JointSearch& other);
  /// Of the overlap at q_0.
  [[nodiscard]] const SmallMotions& small_motions() const { return ways_; }
  /// Of the asked metric.
  [[nodiscard]] Search& asked() { return *searches_[index_of(query_.metric)]; }
  [[nodiscard]] int walks() const;
  [[nodiscard]] int steps() const;
  [[nodiscard]] std::int64_t pairs() const;

 private:
  [[nodiscard]] static std::size_t index_of(Metric metric) { return static_cast<std::size_t>(metric); }
  void prepare(bool careful);
  void find_small_motion(const RigidMotion& from, Freedom freedom);
  void find_small_motions(std::size_t m);
  void start_askew(std::size_t m);
  /// Small motions are tried.
  [[nodiscard]] bool is_shallow() const;
  void add_metrics(std::size_t count, bool careful);  ///< up to so many
  void search_all(bool careful, std::size_t first);
  void exchange_ends();
  void finish(bool careful);

  Encounter& encounter_;
  const Query& query_;
  Mat3 basis_;
  std::array<double, 3> bounds_;
  SmallMotions ways_;
  std::size_t metrics_ = 0;  // searched: the first ones
  std::array<std::optional<Search>, 3> searches_;
  std::vector<RigidMotion> small_, finished_;  // free
  RigidMotion last_;                           // end of the last small motion
  int tried_ = 0;                              // small motions: 1 straight, 2 all
  bool askew_ = false;                         // tried
  int walks_ = 0, steps_ = 0;                  // of earlier searches
  std::int64_t pairs_ = 0;
};

}  // namespace brunt::depth
