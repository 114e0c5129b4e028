// SPDX-License-Identifier: Apache-2.0
// Checkpoints: every saved array of the registry in canonical order. Any number of ranks can read what any other number
// wrote, with the same bits. A file is written under a temporary name and renamed when it is on disk; the last two are
// kept. Every table has a hash of its values (model/hash.hpp), so that a flipped bit is detected.
//
// Layout: attributes of /: format, fingerprint, scene, history_rows, step, time, nodes, and `hash` of the header;
//         /nodes/NAME, /elements/NAME, /globals/NAME: tables [entities][components] with the attribute `hash`;
//         /measured: times measured by the ranks (measured_work.hpp); not part of the state;
//         /records/NAME/keys, /records/NAME/values (with `hash`): records that come and go.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "comm/communicator.hpp"
#include "io/results/measured_work.hpp"
#include "model/registry.hpp"

namespace brunt::io {

struct CheckpointHeader {
  GlobalIndex step = 0;
  double time = 0;
  /// Identifies scene and mesh: a short text (< 60 kB), equal in all runs that may continue from this
  /// checkpoint.
  std::string fingerprint;
  /// The data behind the fingerprint, so that a restart can report the differences; a text of 60 kB or more is omitted.
  std::string scene{};
  GlobalIndex history_rows = -1;  ///< of history.csv up to this step; negative: unknown
  std::string program{};          ///< that wrote it, with its version; empty: unknown, as before format 5
};

/// Writes folder/checkpoint_<step, 9 digits>.h5 and returns its path; all older ones except the previous one are
/// removed. `work`: of this rank, if measured. Collective. Throws MachineError with path and reason on all ranks;
/// earlier checkpoints are then unchanged.
std::string write_checkpoint(const comm::Communicator& ranks, const std::string& folder, const CheckpointHeader& header,
                             const model::Registry& registry, const RankWork* work = nullptr);

/// Reads only step, time and fingerprint. Collective; throws InputError.
[[nodiscard]] CheckpointHeader read_checkpoint_header(const comm::Communicator& ranks, const std::string& path);

/// Fills every saved array of the registry, including copies of nodes, and its tables with a share of the records (the
/// caller sends each to its rank). Collective. Throws InputError with the file, and the table if one is damaged, or
/// with the differences of the model: fingerprint, counts, names of arrays. Nothing is changed unless the whole file is
/// valid.
CheckpointHeader read_checkpoint(const comm::Communicator& ranks, const std::string& path,
                                 const std::string& fingerprint, const model::Registry& registry);

/// The checkpoints of the same folder with lower steps, the latest first. Not collective.
[[nodiscard]] std::vector<std::string> checkpoints_before(const std::string& path);

/// The checkpoint of the highest step in the folder. Not collective.
[[nodiscard]] std::optional<std::string> latest_checkpoint(const std::string& folder);

}  // namespace brunt::io
