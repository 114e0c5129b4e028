// SPDX-License-Identifier: Apache-2.0
// The contact settings of a scene, for each pair of blocks and in total. scene/build resolves the entries of a scene
// (names of parts, in order) once; the model holds them, and contact only reads them.
#pragma once
#include <algorithm>
#include <cstdint>
#include <vector>

#include "contact/data/options.hpp"
#include "contact/data/standard_tolerances.hpp"

namespace brunt::contact {

/// Admissible roles of a pair of blocks (a, b).
enum class PairRule : std::int8_t { apart, automatic, slave, master };  ///< slave: a is the slave of b

struct PairSpecification {
  PairRule rule = PairRule::apart;
  Passes passes = Passes::one;
  FrictionLaw friction{};
  Tied tied = Tied::no;
};

/// Pairs of blocks; the setting of (a, b) also applies to (b, a).
class PairTable {
 public:
  PairTable() = default;
  /// The same setting for all pairs; the rule names no slave.
  PairTable(std::size_t block_count, const PairSpecification& all);

  /// Sets (a, b), and (b, a) to match.
  void set(std::int32_t a, std::int32_t b, const PairSpecification& pair);
  [[nodiscard]] const PairSpecification& at(std::int32_t a, std::int32_t b) const { return pairs_[place(a, b)]; }
  [[nodiscard]] std::size_t block_count() const { return block_count_; }
  /// Position of the entry of (a, b) in arrays over pairs of blocks.
  [[nodiscard]] std::size_t place(std::int32_t a, std::int32_t b) const {
    return static_cast<std::size_t>(a) * block_count_ + static_cast<std::size_t>(b);
  }
  template <class Predicate>
  [[nodiscard]] bool any(Predicate&& holds) const {
    return std::ranges::any_of(pairs_, holds);
  }

  [[nodiscard]] bool any_acts() const;       ///< some pair may have contact
  [[nodiscard]] bool any_tied() const;       ///< some pair is tied
  [[nodiscard]] bool any_friction() const;   ///< some pair has a friction law
  [[nodiscard]] bool forces_a_side() const;  ///< some rule names the slave
  [[nodiscard]] bool averages() const;       ///< some pair that may have contact uses the mean of its passes

 private:
  std::size_t block_count_ = 0;
  std::vector<PairSpecification> pairs_;
};

struct Specification {
  PairTable pairs{};                  ///< no blocks: no contact between bodies, walls only
  EnforcementSettings enforcement{};  ///< of walls too
  Criterion criterion = Criterion::automatic;
  Rebuild rebuild{};
  const Tolerances* tolerances = &standard_tolerances;  ///< no scene sets them
};

/// Whether nodes of the master on rims are also constrained in one-pass contact that was chosen automatically.
bool holds_rims(const Specification& specification);

}  // namespace brunt::contact
