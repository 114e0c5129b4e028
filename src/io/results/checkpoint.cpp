// SPDX-License-Identifier: Apache-2.0
// Writes, reads, finds and prunes checkpoints (see the header).
#include "io/results/checkpoint.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <filesystem>
#include <map>

#include "checkpoint_records.hpp"
#include "checkpoint_tables.hpp"
#include "core/error.hpp"
#include "io/disk_space.hpp"
#include "io/hdf5.hpp"
#include "io/on_root.hpp"
#include "io/text_file.hpp"
#include "measured_tables.hpp"
#include "model/hash.hpp"

namespace brunt::io {
namespace {

namespace fs = std::filesystem;
// 4: /measured; 5: /program, and contact remembers constraints that no motion satisfies
constexpr GlobalIndex format_version = 5, oldest_readable = 3;
constexpr std::size_t longest_attribute = 60000;  // HDF5 takes 64 kB

GlobalIndex header_hash(const CheckpointHeader& header, GlobalIndex nodes, GlobalIndex format = format_version) {
  const auto time = std::bit_cast<std::uint64_t>(header.time);
  return static_cast<GlobalIndex>(
      model::hash_text(fmt::format("{} {} {} {} {}", format, header.step, time, nodes, header.fingerprint)));
}

GlobalIndex table_hash(const comm::Communicator& ranks, const SavedTable& table, GlobalIndex first,
                       std::span<const double> rows) {
  const bool counted = table.array->entity != model::StateArray::Entity::global || ranks.is_root();
  const std::uint64_t mine = counted ? model::hash_rows(table.path, first, rows, table.array->components) : 0;
  return ranks.sum(static_cast<GlobalIndex>(mine));
}

void write_tables(Hdf5File& file, const CheckpointHeader& header, const model::Registry& registry,
                  const RankWork* work) {
  file.set_attribute("/", "format", format_version);
  file.set_attribute("/", "fingerprint", header.fingerprint);
  file.set_attribute("/", "step", header.step);
  file.set_attribute("/", "time", header.time);
  file.set_attribute("/", "nodes", registry.global_nodes);
  if (!header.scene.empty() && header.scene.size() < longest_attribute) file.set_attribute("/", "scene", header.scene);
  if (header.history_rows >= 0) file.set_attribute("/", "history_rows", header.history_rows);
  if (!header.program.empty()) file.set_attribute("/", "program", header.program);
  file.set_attribute("/", "hash", header_hash(header, registry.global_nodes));
  const TableLayout layout(file.ranks(), registry, TableLayout::Nodes::owned);
  for (const SavedTable& table : saved_tables(registry)) {
    std::vector<double> rows = layout.to_blocks(table);
    const GlobalIndex hash = table_hash(file.ranks(), table, layout.rows(table).first, rows);
    // Equal on every rank, so one copy suffices.
    if (table.array->entity == model::StateArray::Entity::global && !file.ranks().is_root()) rows.clear();
    file.create_doubles(table.path, table.rows, table.array->components);
    file.write(table.path, layout.rows(table).first, std::span<const double>(rows));
    file.set_attribute(table.path, "hash", hash);
  }
  for (const RecordTable* table : registry.tables) write_records(file, *table);
  if (work) write_measured(file, *work, registry, layout);
}

GlobalIndex bytes_of(const comm::Communicator& ranks, const model::Registry& registry, bool measured) {
  GlobalIndex bytes = 16384;
  for (const SavedTable& table : saved_tables(registry)) bytes += table_bytes(table.rows, table.array->components);
  for (const RecordTable* table : registry.tables) bytes += record_bytes(ranks, *table);
  if (!measured) return bytes;
  bytes += table_bytes(ranks.size(), 2);
  for (const GlobalIndex count : registry.block_count) bytes += table_bytes(count, 2);
  return bytes;
}

// step -> path
std::map<GlobalIndex, std::string> checkpoints_in(const std::string& folder) {
  std::map<GlobalIndex, std::string> found;
  const std::string prefix = "checkpoint_";
  std::error_code no_folder;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, no_folder)) {
    const std::string name = entry.path().stem().string();
    if (entry.path().extension() != ".h5" || name.rfind(prefix, 0) != 0) continue;
    const std::string digits = name.substr(prefix.size());
    if (digits.empty() || digits.size() > 18 || digits.find_first_not_of("0123456789") != std::string::npos) continue;
    found[std::stoll(digits)] = entry.path().string();
  }
  return found;
}

// Keeps the new checkpoint and the previous one; later ones belong to an abandoned run.
void prune(const std::string& folder, GlobalIndex step) {
  const auto found = checkpoints_in(folder);
  auto before = found.lower_bound(step);
  const GlobalIndex kept = before == found.begin() ? step : (--before)->first;
  for (const auto& [other, path] : found)
    if (other != step && other != kept) fs::remove(path);
}

CheckpointHeader sound_header(const Hdf5File& file) {
  if (!file.has_attribute("/", "fingerprint"))
    throw InputError(file.path() + ": invalid checkpoint; expected a file checkpoint_*.h5 of a result folder");
  const GlobalIndex version = file.integer_attribute("/", "format");
  if (version < oldest_readable || version > format_version)
    throw InputError(fmt::format("{}: unknown checkpoint format {}; expected {} to {}", file.path(), version,
                                 oldest_readable, format_version));
  CheckpointHeader header;
  header.step = file.integer_attribute("/", "step");
  header.time = file.real_attribute("/", "time");
  header.fingerprint = file.text_attribute("/", "fingerprint");
  if (file.integer_attribute("/", "hash") != header_hash(header, file.integer_attribute("/", "nodes"), version))
    throw InputError(
        file.path() +
        ": invalid header of the checkpoint: its hash differs from the stored one; expected an undamaged file");
  if (file.has_attribute("/", "scene")) header.scene = file.text_attribute("/", "scene");
  if (file.has_attribute("/", "program")) header.program = file.text_attribute("/", "program");
  if (file.has_attribute("/", "history_rows")) header.history_rows = file.integer_attribute("/", "history_rows");
  return header;
}

/// Of a file in an older format, who has written it; otherwise empty.
std::string writer_of(const Hdf5File& file) {
  const GlobalIndex version = file.integer_attribute("/", "format");
  if (version == format_version) return {};
  const std::string program =
      file.has_attribute("/", "program") ? file.text_attribute("/", "program") : "an earlier version of brunt";
  return fmt::format("{} in checkpoint format {}; this version writes format {}", program, version, format_version);
}

std::vector<std::string> without(const std::vector<std::string>& names, const std::vector<std::string>& others) {
  std::vector<std::string> rest;
  std::set_difference(names.begin(), names.end(), others.begin(), others.end(), std::back_inserter(rest));
  return rest;
}

/// Tables of the model without those that a checkpoint may lack and this one does.
std::vector<SavedTable> tables_to_read(const Hdf5File& file, const model::Registry& registry) {
  std::vector<SavedTable> tables = saved_tables(registry);
  const std::vector<std::string> stored = state_tables(file);
  std::erase_if(tables, [&](const SavedTable& table) {
    return !table.array->expected && !std::ranges::binary_search(stored, table.path.substr(1));
  });
  return tables;
}

void check_same_tables(const Hdf5File& file, const std::vector<SavedTable>& tables,
                       const std::vector<RecordTable*>& records) {
  std::vector<std::string> wanted;
  wanted.reserve(tables.size() + 2 * records.size());
  for (const SavedTable& table : tables) wanted.push_back(table.path.substr(1));
  for (const RecordTable* table : records)
    for (const std::string& path : {keys_path(*table), values_path(*table)}) wanted.push_back(path.substr(1));
  std::sort(wanted.begin(), wanted.end());
  const std::vector<std::string> stored = state_tables(file);
  std::vector<std::string> faults;
  for (const std::string& name : without(wanted, stored))
    faults.push_back(fmt::format(
        "{}: invalid for this model: missing table {}; expected a checkpoint of the same model", file.path(), name));
  for (const std::string& name : without(stored, wanted))
    faults.push_back(fmt::format(
        "{}: invalid for this model: unknown table {}; expected a checkpoint of the same model", file.path(), name));
  if (!faults.empty()) throw InputError(std::move(faults));
  for (const SavedTable& table : tables) {
    const Hdf5File::Extent found = file.extent(table.path);
    if (found != Hdf5File::Extent{table.rows, table.array->components, Hdf5File::Type::doubles})
      faults.push_back(fmt::format("{}: invalid for this model: {} has the size {} x {}; expected {} x {}", file.path(),
                                   table.path.substr(1), found.rows, found.width, table.rows, table.array->components));
  }
  for (const RecordTable* table : records)
    for (std::string& fault : record_faults(file, *table, writer_of(file))) faults.push_back(std::move(fault));
  if (!faults.empty()) throw InputError(std::move(faults));
}

std::vector<double> sound_rows(const Hdf5File& file, const SavedTable& table, const RowRange& range) {
  std::vector<double> rows(static_cast<std::size_t>(range.count) * static_cast<std::size_t>(table.array->components));
  file.read(table.path, range.first, std::span<double>(rows));
  if (table_hash(file.ranks(), table, range.first, rows) != file.integer_attribute(table.path, "hash"))
    throw InputError(
        fmt::format("{}: invalid values of {}: their hash differs from the stored one; expected an undamaged file",
                    file.path(), table.path.substr(1)));
  return rows;
}

}  // namespace

std::string write_checkpoint(const comm::Communicator& ranks, const std::string& folder, const CheckpointHeader& header,
                             const model::Registry& registry, const RankWork* work) {
  std::string path = fmt::format("{}/checkpoint_{:09}.h5", folder, header.step);
  const std::string draft = path + ".tmp";
  try {
    demand_disk_space(ranks, draft, bytes_of(ranks, registry, work != nullptr));
    Hdf5File file(ranks, draft, Hdf5File::Mode::create);
    write_tables(file, header, registry, work);
    file.close();
  } catch (const MachineError&) {
    std::error_code ignored;  // what matters is why the checkpoint failed
    if (ranks.is_root()) fs::remove(draft, ignored);
    throw;
  }
  on_root(ranks, [&] {
    rename_durably(draft, path);
    prune(folder, header.step);
  });
  return path;
}

CheckpointHeader read_checkpoint_header(const comm::Communicator& ranks, const std::string& path) {
  return sound_header(Hdf5File(ranks, path, Hdf5File::Mode::read));
}

CheckpointHeader read_checkpoint(const comm::Communicator& ranks, const std::string& path,
                                 const std::string& fingerprint, const model::Registry& registry) {
  const Hdf5File file(ranks, path, Hdf5File::Mode::read);
  CheckpointHeader header = sound_header(file);
  if (header.fingerprint != fingerprint)
    throw InputError(
        fmt::format("{}: invalid fingerprint \"{}\": written by another scene or program version; expected \"{}\"",
                    path, header.fingerprint, fingerprint));
  const std::vector<SavedTable> tables = tables_to_read(file, registry);
  check_same_tables(file, tables, registry.tables);
  const TableLayout layout(ranks, registry, TableLayout::Nodes::all);
  std::vector<std::vector<double>> rows;
  rows.reserve(tables.size());
  for (const SavedTable& table : tables) rows.push_back(sound_rows(file, table, layout.rows(table)));
  std::vector<RecordTable> records;
  for (const RecordTable* table : registry.tables) records.push_back(read_records(file, *table));
  for (std::size_t i = 0; i < tables.size(); ++i) layout.from_blocks(tables[i], rows[i]);
  for (std::size_t i = 0; i < records.size(); ++i) *registry.tables[i] = std::move(records[i]);
  return header;
}

std::vector<std::string> checkpoints_before(const std::string& path) {
  const std::string folder = fs::path(path).parent_path().string();
  const auto found = checkpoints_in(folder.empty() ? "." : folder);
  const auto same_name = [&](const auto& entry) {
    return fs::path(entry.second).filename() == fs::path(path).filename();
  };
  std::vector<std::string> before;
  for (auto at = std::ranges::find_if(found, same_name); at != found.end() && at != found.begin();)
    before.push_back((--at)->second);
  return before;
}

std::optional<std::string> latest_checkpoint(const std::string& folder) {
  const auto found = checkpoints_in(folder);
  if (found.empty()) return std::nullopt;
  return found.rbegin()->second;
}

}  // namespace brunt::io
