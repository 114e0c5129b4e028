// SPDX-License-Identifier: Apache-2.0
// Record tables of a registry in a checkpoint: /records/NAME/keys and /records/NAME/values with the attribute `hash`.
// Their rows are in the order of the ranks that wrote them; the caller sends them to their owners.
#pragma once
#include <string>
#include <vector>

#include "core/record_table.hpp"
#include "io/hdf5.hpp"

namespace brunt::io {

std::string keys_path(const RecordTable& table);
std::string values_path(const RecordTable& table);

/// The size of the records of all ranks in the file. Collective.
GlobalIndex record_bytes(const comm::Communicator& ranks, const RecordTable& table);

/// Collective.
void write_records(Hdf5File& file, const RecordTable& table);

/// Differences between the file's tables and `table`; both exist.
/// writer: of a file in an older format; empty: it is in the present one.
std::vector<std::string> record_faults(const Hdf5File& file, const RecordTable& table, const std::string& writer);

/// A share of the file's records. Throws InputError if they are damaged. Collective.
RecordTable read_records(const Hdf5File& file, const RecordTable& table);

}  // namespace brunt::io
