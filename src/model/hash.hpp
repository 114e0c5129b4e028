// SPDX-License-Identifier: Apache-2.0
// A hash of the state that does not depend on the partition: every value of every hashed array is mixed with its place
// (array name, canonical index, component), and the results are added modulo 2^64. Addition commutes, so the partial
// values of the ranks can be added in any order (Communicator::sum). Equal hashes mean that two states of one program
// agree bitwise; the hash is not a reference value across programs, and no protection against forgery.
#pragma once
#include <cstdint>
#include <span>
#include <string_view>

#include "core/types.hpp"
#include "model/registry.hpp"

namespace brunt::model {

/// All bits of `z` spread over all bits of the result (finaliser of SplitMix64; Steele, Lea, Flood, "Fast splittable
/// pseudorandom number generators", OOPSLA 2014, variant 13 of D. Stafford).
[[nodiscard]] std::uint64_t mix_bits(std::uint64_t z);

/// FNV-1a (Fowler, Noll, Vo) of the text, then `mix_bits`.
[[nodiscard]] std::uint64_t hash_text(std::string_view text);

/// The term of one value in the sum. `array`: hash_text of its name; the bits count, so 0.0 and -0.0 differ.
[[nodiscard]] std::uint64_t hash_value(std::uint64_t array, GlobalIndex gid, int component, double value);

/// The sum of the terms of consecutive rows: row i, `components` wide, has the index first + i.
[[nodiscard]] std::uint64_t hash_rows(std::string_view name, GlobalIndex first, std::span<const double> values,
                                      int components);

/// The sum of the terms of records, whatever their order: a value's place is the table's name, its key and component.
[[nodiscard]] std::uint64_t hash_records(const RecordTable& table);

/// This rank's part of the state hash: owned nodes, own elements and records, and the global arrays on the rank with
/// `is_root`. The sum of the parts of all ranks, modulo 2^64, is the hash of the state.
[[nodiscard]] std::uint64_t hash_of_rank(const Registry& registry, bool is_root);

/// Sixteen hexadecimal digits, as summary.json shows a hash.
[[nodiscard]] std::string hash_digits(std::uint64_t hash);

}  // namespace brunt::model
