// SPDX-License-Identifier: Apache-2.0
// Differences of two results: state files, checkpoints, histories, or result folders, field by field.
#pragma once
#include <string>
#include <vector>

#include "comm/communicator.hpp"

namespace brunt::io {

/// One field over all records. The scale is the largest magnitude of the field in A or B over all records; where a
/// field is a small difference of large quantities it is at least what these are: of gaps and penetrations the size of
/// the mesh, of energies the largest term of the balance, of momenta sqrt(2 mass kinetic), which bounds them. NaN on
/// either side counts as an infinite difference.
struct FieldDifference {
  std::string field;    ///< "node/displacement", "history/kinetic", "nodes/velocity" (of a checkpoint)
  double absolute = 0;  ///< largest |a - b|
  double relative = 0;  ///< absolute / scale of the field, see below
  double time = 0;      ///< of the first record with the largest difference
  std::string where;    ///< entity and component there: "node 17 [2]"; "step 40" in a history
};

struct Comparison {
  std::vector<FieldDifference> fields;
  std::vector<std::string>
      mismatches;  ///< differences that prevent a comparison: meshes, fields, records of one side only; one line each

  /// No mismatch, and no relative difference above `tolerance`; 0 requires equal values.
  [[nodiscard]] bool within(double tolerance) const;
};

/// A and B are two state.h5 files, two checkpoints, two history.csv, or two result folders (state.h5 and history.csv
/// are then compared); or a folder and a file, which is compared with the corresponding file of the folder (the latest
/// checkpoint). Records and rows are paired by step, the remaining ones by time; those without a partner are
/// mismatches. Nodes are identified by the numbers of the input, elements by their position in the input (in
/// checkpoints by the canonical index), both as stored in A. Collective. Throws InputError if a file cannot be read or
/// the kinds differ.
[[nodiscard]] Comparison compare_results(const comm::Communicator& ranks, const std::string& a, const std::string& b);

/// The table that `brunt compare` prints, with the result in the last line.
[[nodiscard]] std::string comparison_text(const Comparison& comparison, double tolerance);

}  // namespace brunt::io
