// SPDX-License-Identifier: Apache-2.0
// Checkpoints: every saved array of the registry in canonical order, so that any number of ranks reads what any other
// number wrote, to the same bits. A file is written under another name, has reached the disk when it gets its own,
// and the last two are kept. Every table carries a hash of its values (model/hash.hpp): a flipped bit is found.
//
// Layout: attributes of /: format, fingerprint, scene, history_rows, step, time, nodes, and `hash` of the header;
//         /nodes/NAME, /elements/NAME, /globals/NAME: tables [entities][components] with the attribute `hash`;
//         /measured: what the ranks measured of their own work (measured_work.hpp), no part of the state;
//         /records/NAME/keys, /records/NAME/values (with `hash`): records that come and go.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "brunt/comm/communicator.hpp"
#include "brunt/io/measured_work.hpp"
#include "brunt/model/registry.hpp"

namespace brunt::io {

struct CheckpointHeader {
  GlobalIndex step = 0;
  double time = 0;
  /// Identifies program version and scene: a short text (< 60 kB), the same in every run that may go on from here.
  std::string fingerprint;
  /// What the fingerprint stands for, so that a restart can say what differs; a text of 60 kB and more is left out.
  std::string scene{};
  GlobalIndex history_rows = -1;  ///< of history.csv up to this step; negative: not known
};

/// Writes folder/checkpoint_<step, 9 digits>.h5 and returns its path; older ones but the last before are removed.
/// `work`: of this rank, where it was measured. Collective. Throws MachineError with path and reason on all ranks; the
/// checkpoints before stay as they were.
std::string write_checkpoint(const comm::Communicator& ranks, const std::string& folder, const CheckpointHeader& header,
                             const model::Registry& registry, const RankWork* work = nullptr);

/// Step, time and fingerprint alone. Collective; throws InputError.
[[nodiscard]] CheckpointHeader read_checkpoint_header(const comm::Communicator& ranks, const std::string& path);

/// Fills every saved array of the registry, nodes of other ranks included, and its tables with a share of the records
/// (the caller sends them home). Collective. Throws InputError naming the
/// file, and the table if one is damaged; or saying how the model differs: fingerprint, counts, array names. Nothing is
/// changed unless the whole file is sound.
CheckpointHeader read_checkpoint(const comm::Communicator& ranks, const std::string& path,
                                 const std::string& fingerprint, const model::Registry& registry);

/// The checkpoints of the same folder with lower steps, the last one first. Not collective.
[[nodiscard]] std::vector<std::string> checkpoints_before(const std::string& path);

/// The checkpoint of the highest step in the folder. Not collective.
[[nodiscard]] std::optional<std::string> latest_checkpoint(const std::string& folder);

}  // namespace brunt::io
