// SPDX-License-Identifier: Apache-2.0
// Compares results of the same kind (see the header).
#include "io/results/compare.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <set>

#include "compare_tables.hpp"
#include "core/error.hpp"
#include "io/results/checkpoint.hpp"
#include "io/results/history.hpp"
#include "io/results/record_pairs.hpp"
#include "io/results/state_file.hpp"
#include "measured_tables.hpp"
#include "natural_scales.hpp"

namespace brunt::io {
namespace {

namespace fs = std::filesystem;

std::string place_text(const Hdf5File& file, Place place, const LargestDifference& at) {
  if (place == Place::element) return fmt::format("element {} [{}]", at.row, at.component);
  std::int64_t id = 0;
  file.read("/mesh/node_id", at.row, std::span<std::int64_t>(&id, 1));
  return fmt::format("node {} [{}]", id, at.component);
}

// The mesh is compared exactly: fields of different meshes are not comparable.
bool same_mesh(const Hdf5File& a, const Hdf5File& b, Comparison& result) {
  for (const char* what : {"nodes", "elements", "blocks"}) {
    const GlobalIndex in_a = a.integer_attribute("/", what), in_b = b.integer_attribute("/", what);
    if (in_a != in_b) result.mismatches.push_back(fmt::format("mesh: {} {} in A, {} in B", what, in_a, in_b));
  }
  if (!result.mismatches.empty()) return false;
  for (const std::string& name : a.datasets("/mesh")) {
    const std::string table = fmt::format("/mesh/{}", name);
    if (!b.contains(table) || a.extent(table) != b.extent(table))
      result.mismatches.push_back(fmt::format("mesh: the size of {} differs in B", name));
    else if (largest_difference(a, table, b, table).difference > 0)
      result.mismatches.push_back(fmt::format("mesh: {} differs", name));
  }
  return result.mismatches.empty();
}

std::string table_path(const StateRecord::Table& table) {
  return (table.place == Place::node ? "node/" : "element/") + table.name;
}

// Fields of A that every record of both files has, in A's order.
std::vector<StateRecord::Table> common_tables(const std::vector<StateRecord>& a, const std::vector<StateRecord>& b,
                                              Comparison& result) {
  std::vector<StateRecord::Table> common;
  std::set<std::string> reported;
  const auto in_all = [](const std::vector<StateRecord>& records, const StateRecord::Table& table) {
    return std::all_of(records.begin(), records.end(), [&](const StateRecord& record) {
      return std::find(record.tables.begin(), record.tables.end(), table) != record.tables.end();
    });
  };
  for (const auto* side : {&a, &b})
    for (const StateRecord& record : *side)
      for (const StateRecord::Table& table : record.tables) {
        const bool known = std::find(common.begin(), common.end(), table) != common.end();
        if (known || reported.contains(table_path(table))) continue;
        if (in_all(a, table) && in_all(b, table)) {
          common.push_back(table);
        } else {
          result.mismatches.push_back(
              fmt::format("{} is not in every record of both results with the same components", table_path(table)));
          reported.insert(table_path(table));
        }
      }
  return common;
}

RecordPairs pair_up(const std::vector<Instant>& a, const std::vector<Instant>& b, const std::string& what,
                    Comparison& result) {
  RecordPairs pairs = pair_records(a, b);
  for (std::string& line : unpaired_lines(pairs, a, b, what)) result.mismatches.push_back(std::move(line));
  return pairs;
}

void compare_states(const comm::Communicator& ranks, const std::string& path_a, const std::string& path_b,
                    Comparison& result) {
  const Hdf5File a(ranks, path_a, Hdf5File::Mode::read), b(ranks, path_b, Hdf5File::Mode::read);
  if (!same_mesh(a, b, result)) return;
  const std::vector<StateRecord> records_a = state_records(a), records_b = state_records(b);
  const auto instants = [](const std::vector<StateRecord>& records) {
    std::vector<Instant> of_records;
    of_records.reserve(records.size());
    for (const StateRecord& record : records) of_records.push_back({record.step, record.time});
    return of_records;
  };
  const RecordPairs pairs = pair_up(instants(records_a), instants(records_b), "record", result);
  FieldTally times("time");
  for (const auto& [i, j] : pairs.both) {
    const double time_a = records_a[i].time, time_b = records_b[j].time;
    if (times.take(difference_of(time_a, time_b), std::max(std::abs(time_a), std::abs(time_b)), time_a))
      times.name_place(fmt::format("step {}", records_a[i].step));
  }
  result.fields.push_back(times.finish());
  const double size = size_of_mesh(a);
  for (const StateRecord::Table& table : common_tables(records_a, records_b, result)) {
    FieldTally tally(table_path(table));
    for (const auto& [i, j] : pairs.both) {
      const std::string name = fmt::format("/{}", table_path(table));
      const LargestDifference at = largest_difference(a, records_a[i].group + name, b, records_b[j].group + name);
      if (tally.take(at.difference, at.magnitude, records_a[i].time)) tally.name_place(place_text(a, table.place, at));
    }
    result.fields.push_back(tally.finish(natural_scale(table.name, size)));
  }
}

void compare_checkpoints(const comm::Communicator& ranks, const std::string& path_a, const std::string& path_b,
                         Comparison& result) {
  const Hdf5File a(ranks, path_a, Hdf5File::Mode::read), b(ranks, path_b, Hdf5File::Mode::read);
  const std::vector<std::string> names_a = state_tables(a), names_b = state_tables(b);
  std::vector<std::string> all;
  std::set_union(names_a.begin(), names_a.end(), names_b.begin(), names_b.end(), std::back_inserter(all));
  const double time = a.real_attribute("/", "time");
  const GlobalIndex step_a = a.integer_attribute("/", "step"), step_b = b.integer_attribute("/", "step");
  if (step_a != step_b)
    result.mismatches.push_back(fmt::format("checkpoints of different steps: {} in A, {} in B", step_a, step_b));
  for (const std::string& name : all) {
    const std::string table = fmt::format("/{}", name);
    const bool in_a = a.contains(table), in_b = b.contains(table);
    if (!in_a || !in_b) {
      result.mismatches.push_back(fmt::format("{} is not in {}", name, in_a ? "B" : "A"));
    } else if (a.extent(table) != b.extent(table)) {
      result.mismatches.push_back(fmt::format("the size of {} differs in B", name));
    } else {
      FieldTally tally(name);
      const LargestDifference at = largest_difference(a, table, b, table);
      if (tally.take(at.difference, at.magnitude, time))
        tally.name_place(fmt::format("row {} [{}]", at.row, at.component));
      result.fields.push_back(tally.finish());
    }
  }
}

std::vector<Instant> instants_of(const History& history) {
  const auto column = static_cast<std::size_t>(std::ranges::find(history.names, "time") - history.names.begin());
  std::vector<Instant> instants;
  for (const std::vector<double>& row : history.rows)
    instants.push_back({static_cast<GlobalIndex>(row[0]), column < row.size() ? row[column] : 0});
  return instants;
}

/// size: of the mesh [length], 0 where it is not known.
void compare_histories(const std::string& path_a, const std::string& path_b, double size, Comparison& result) {
  const History a = read_history(path_a), b = read_history(path_b);
  const std::vector<Instant> instants_a = instants_of(a), instants_b = instants_of(b);
  const RecordPairs pairs = pair_up(instants_a, instants_b, "history row", result);
  for (const std::string& name : b.names)
    if (std::find(a.names.begin(), a.names.end(), name) == a.names.end())
      result.mismatches.push_back(fmt::format("history: column {} is not in A", name));
  const std::vector<double> scales = natural_scales(a, b, size);
  for (std::size_t i = 0; i < a.names.size(); ++i) {
    const auto found = std::find(b.names.begin(), b.names.end(), a.names[i]);
    if (found == b.names.end()) {
      result.mismatches.push_back(fmt::format("history: column {} is not in B", a.names[i]));
      continue;
    }
    const auto j = static_cast<std::size_t>(found - b.names.begin());
    FieldTally tally("history/" + a.names[i]);
    for (const auto& [row_a, row_b] : pairs.both) {
      const double in_a = a.rows[row_a][i], in_b = b.rows[row_b][j];
      const double magnitude =
          std::max(std::isfinite(in_a) ? std::abs(in_a) : 0, std::isfinite(in_b) ? std::abs(in_b) : 0);
      if (tally.take(difference_of(in_a, in_b), magnitude, instants_a[row_a].time))
        tally.name_place(fmt::format("step {}", instants_a[row_a].step));
    }
    result.fields.push_back(tally.finish(scales[i]));
  }
}

enum class Kind { state, checkpoint, history, folder };

Kind kind_of(const std::string& path) {
  if (fs::is_directory(path)) return Kind::folder;
  if (fs::path(path).extension() == ".csv") return Kind::history;
  return fs::path(path).filename().string().rfind("checkpoint", 0) == 0 ? Kind::checkpoint : Kind::state;
}

// The file of this kind in a result folder.
std::string file_in(const std::string& folder, Kind kind) {
  if (kind == Kind::checkpoint) {
    const std::optional<std::string> latest = latest_checkpoint(folder);
    if (!latest) throw InputError(folder + ": missing checkpoint to compare; expected a file checkpoint_*.h5");
    return *latest;
  }
  std::string path = (fs::path(folder) / (kind == Kind::history ? "history.csv" : "state.h5")).string();
  if (!fs::exists(path))
    throw InputError(path +
                     ": cannot read the file: it does not exist; expected it, since the other side of the comparison "
                     "is such a file");
  return path;
}

// True if both folders have the file.
bool in_both(const std::string& a, const std::string& b, const char* name, Comparison& result) {
  const bool in_a = fs::exists(fs::path(a) / name), in_b = fs::exists(fs::path(b) / name);
  if (in_a != in_b) result.mismatches.push_back(fmt::format("{} is not in {}", name, in_a ? "B" : "A"));
  return in_a && in_b;
}

}  // namespace

bool Comparison::within(double tolerance) const {
  return mismatches.empty() && std::all_of(fields.begin(), fields.end(),
                                           [&](const FieldDifference& field) { return field.relative <= tolerance; });
}

Comparison compare_results(const comm::Communicator& ranks, const std::string& a, const std::string& b) {
  Comparison result;
  for (const std::string& path : {a, b})
    if (!fs::exists(path))
      throw InputError(path + ": cannot read the result: it does not exist; expected a result folder or file");
  const Kind kind = kind_of(a) == Kind::folder ? kind_of(b) : kind_of(a);
  const auto file_of = [&](const std::string& path) {
    return kind != Kind::folder && kind_of(path) == Kind::folder ? file_in(path, kind) : path;
  };
  const std::string file_a = file_of(a), file_b = file_of(b);
  if (kind_of(file_a) != kind_of(file_b))
    throw InputError(a + " and " + b +
                     ": invalid comparison of results of different kinds; expected two results of one kind");
  if (kind == Kind::state) compare_states(ranks, file_a, file_b, result);
  if (kind == Kind::checkpoint) compare_checkpoints(ranks, file_a, file_b, result);
  if (kind == Kind::history) compare_histories(file_a, file_b, 0, result);
  if (kind != Kind::folder) return result;
  const bool states = in_both(a, b, "state.h5", result), histories = in_both(a, b, "history.csv", result);
  if (!states && !histories && result.mismatches.empty())
    throw InputError(a + " and " + b + ": missing files to compare; expected state.h5 or history.csv");
  if (states) compare_states(ranks, a + "/state.h5", b + "/state.h5", result);
  const double size = states ? size_of_mesh(Hdf5File(ranks, a + "/state.h5", Hdf5File::Mode::read)) : 0;
  if (histories) compare_histories(a + "/history.csv", b + "/history.csv", size, result);
  return result;
}

std::string comparison_text(const Comparison& comparison, double tolerance) {
  std::string text = fmt::format("{:<32} {:>12} {:>12} {:>14}  {}\n", "field", "absolute", "relative", "time", "where");
  for (const FieldDifference& field : comparison.fields) {
    text += fmt::format("{:<32} {:>12.5g} {:>12.5g} ", field.field, field.absolute, field.relative);
    text += field.absolute > 0 ? fmt::format("{:>14.6g}  {}\n", field.time, field.where) : fmt::format("{:>14}\n", "-");
  }
  for (const std::string& mismatch : comparison.mismatches) text += "differs: " + mismatch + "\n";
  return text + fmt::format("{} (tolerance {})\n", comparison.within(tolerance) ? "same" : "DIFFERENT", tolerance);
}

}  // namespace brunt::io
