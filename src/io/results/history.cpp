// SPDX-License-Identifier: Apache-2.0
// Writes and reads history.csv (see the header).
#include "io/results/history.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <iterator>

#include "core/error.hpp"
#include "io/text_file.hpp"

namespace brunt::io {
namespace {

std::string header_of(const std::vector<HistoryColumn>& columns) {
  std::string header = "step";
  for (const HistoryColumn& column : columns) {
    header += "," + column.name;
    if (!column.unit.empty()) header += " [" + column.unit + "]";
  }
  return header;
}

// Whole lines only: what follows the last line end was being written when a run was killed.
std::vector<std::string> whole_lines(const std::string& text) {
  std::vector<std::string> lines;
  std::size_t first = 0;
  for (std::size_t end = text.find('\n'); end != std::string::npos; end = text.find('\n', first)) {
    lines.push_back(text.substr(first, end - first));
    if (!lines.back().empty() && lines.back().back() == '\r') lines.back().pop_back();
    first = end + 1;
  }
  return lines;
}

std::vector<std::string> cells(const std::string& line) {
  std::vector<std::string> result;
  std::size_t first = 0;
  for (std::size_t end = line.find(','); end != std::string::npos; end = line.find(',', first)) {
    result.push_back(line.substr(first, end - first));
    first = end + 1;
  }
  result.push_back(line.substr(first));
  return result;
}

std::string kept_at_restart(const std::string& path, const std::string& header, GlobalIndex restart_step) {
  const std::vector<std::string> lines = whole_lines(read_text(path));
  if (lines.empty()) return header + "\n";
  if (lines.front() != header)
    throw InputError(
        fmt::format("{}:1: invalid columns \"{}\"; expected those of this run, \"{}\"", path, lines.front(), header));
  std::string kept;
  for (const std::string& line : lines)
    if (kept.empty() || std::strtoll(line.c_str(), nullptr, 10) <= restart_step) kept += line + "\n";
  return kept;
}

double number(const std::string& cell, const std::string& path, std::size_t line) {
  char* end = nullptr;
  const double value = std::strtod(cell.c_str(), &end);
  if (cell.empty() || *end != '\0')
    throw InputError(fmt::format("{}:{}: invalid value \"{}\"; expected a number", path, line, cell));
  return value;
}

}  // namespace

HistoryFile::HistoryFile(std::string path, const std::vector<HistoryColumn>& columns,
                         std::optional<GlobalIndex> restart_step)
    : path_(std::move(path)), columns_(columns.size()) {
  const std::string header = header_of(columns);
  const bool continued = restart_step && std::filesystem::exists(path_);
  const std::string kept = continued ? kept_at_restart(path_, header, *restart_step) : header + "\n";
  rows_ = static_cast<GlobalIndex>(std::ranges::count(kept, '\n')) - 1;
  replace_text(path_, kept);
  file_ = std::fopen(path_.c_str(), "ab");
  if (file_ == nullptr) throw MachineError(path_ + ": cannot open the file: " + std::strerror(errno));
}

HistoryFile::~HistoryFile() {
  if (file_ != nullptr) std::fclose(file_);
}

void HistoryFile::write(GlobalIndex step, std::span<const double> values) {
  demand(values.size() == columns_, "a history row has one value a column");
  fmt::memory_buffer row;
  fmt::format_to(std::back_inserter(row), "{}", step);
  for (const double value : values) fmt::format_to(std::back_inserter(row), ",{}", value);
  row.push_back('\n');
  ++rows_;
  last_step_ = step;
  if (std::fwrite(row.data(), 1, row.size(), file_) != row.size() || std::fflush(file_) != 0)
    throw MachineError(path_ + ": cannot write a row: " + std::strerror(errno));
}

std::optional<HistoryGap> history_gap(const std::string& path, GlobalIndex expected, double until) {
  const std::vector<std::string> lines = whole_lines(read_text(path));
  const auto rows = static_cast<GlobalIndex>(lines.size()) - 1;
  if (rows >= expected) return std::nullopt;
  HistoryGap gap{expected - std::max(rows, GlobalIndex{0})};
  double before = 0;
  const auto widen = [&](double time) {
    if (time - before > gap.to - gap.from) gap.from = before, gap.to = time;
    before = time;
  };
  for (std::size_t i = 1; i < lines.size(); ++i)
    if (const std::vector<std::string> row = cells(lines[i]); row.size() > 1)
      widen(std::strtod(row[1].c_str(), nullptr));  // the first column is the step
  widen(until);
  return gap;
}

History read_history(const std::string& path) {
  const std::vector<std::string> lines = whole_lines(read_text(path));
  if (lines.empty() || lines.front().rfind("step", 0) != 0)
    throw InputError(path +
                     ":1: invalid first line of a history; expected the names of the columns, beginning with step");
  History history;
  for (const std::string& name : cells(lines.front())) history.names.push_back(name.substr(0, name.find(" [")));
  for (std::size_t i = 1; i < lines.size(); ++i) {
    std::vector<double> row;
    for (const std::string& cell : cells(lines[i])) row.push_back(number(cell, path, i + 1));
    if (row.size() != history.names.size())
      throw InputError(fmt::format("{}:{}: invalid row of {} values; expected one for each of {} columns", path, i + 1,
                                   row.size(), history.names.size()));
    history.rows.push_back(std::move(row));
  }
  return history;
}

}  // namespace brunt::io
