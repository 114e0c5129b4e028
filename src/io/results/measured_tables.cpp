// SPDX-License-Identifier: Apache-2.0
#include "measured_tables.hpp"

#include <fmt/format.h>

#include <cmath>
#include <cstdint>

#include "core/error.hpp"

namespace brunt::io {
namespace {

const std::string of_ranks = "/measured/ranks", of_elements = "/measured/elements";

[[noreturn]] void refuse(const std::string& path, const std::string& what) {
  throw InputError(fmt::format("{}: {}", path, what));
}

}  // namespace

void write_measured(Hdf5File& file, const RankWork& work, const model::Registry& registry, const TableLayout& layout) {
  const comm::Communicator& ranks = file.ranks();
  GlobalIndex elements = 0;
  for (const GlobalIndex count : registry.block_count) elements += count;
  file.create_doubles(of_ranks, ranks.size(), 2);
  const double seconds[2] = {work.element_seconds, work.contact_seconds};
  file.write(of_ranks, ranks.rank(), std::span<const double>(seconds));
  file.create_integers(of_elements, elements, 2);
  for (std::size_t b = 0; b < registry.block_count.size(); ++b) {
    std::vector<double> values;
    values.reserve(2 * work.pairs[b].size());
    for (const double pairs : work.pairs[b]) values.insert(values.end(), {static_cast<double>(ranks.rank()), pairs});
    const model::StateArray array{"",
                                  model::StateArray::Entity::element,
                                  static_cast<std::int32_t>(b),
                                  static_cast<LocalIndex>(work.pairs[b].size()),
                                  2,
                                  values.data(),
                                  1,
                                  2,
                                  1,
                                  0};
    const SavedTable table{of_elements, &array, registry.block_count[b]};
    std::vector<std::int64_t> rows;
    for (const double value : layout.to_blocks(table)) rows.push_back(std::llround(value));
    file.write(of_elements, registry.block_first[b] + layout.rows(table).first, std::span<const std::int64_t>(rows));
  }
}

std::vector<std::string> state_tables(const Hdf5File& file) {
  std::vector<std::string> tables = file.datasets("/");
  std::erase_if(tables, [](const std::string& name) { return name.starts_with("measured/"); });
  return tables;
}

MeasuredWork read_measured_work(const std::string& checkpoint) {
  const Hdf5File file(comm::Communicator::self(), checkpoint, Hdf5File::Mode::read);
  if (!file.has_attribute("/", "fingerprint"))
    refuse(checkpoint, "invalid checkpoint; expected a file checkpoint_*.h5 of a result folder");
  if (!file.contains("/measured") || !file.contains(of_ranks) || !file.contains(of_elements))
    refuse(checkpoint, "missing measured times; expected a checkpoint of an explicit run of several steps");
  const Hdf5File::Extent ranks = file.extent(of_ranks), elements = file.extent(of_elements);
  if (ranks.width != 2 || elements.width != 2 || ranks.rows < 1)
    refuse(checkpoint, "invalid measured times; expected an undamaged file");
  std::vector<double> seconds(2 * static_cast<std::size_t>(ranks.rows));
  std::vector<std::int64_t> rows(2 * static_cast<std::size_t>(elements.rows));
  file.read(of_ranks, 0, std::span<double>(seconds));
  file.read(of_elements, 0, std::span<std::int64_t>(rows));
  MeasuredWork work;
  for (std::size_t r = 0; r < seconds.size(); r += 2) {
    if (!std::isfinite(seconds[r]) || !std::isfinite(seconds[r + 1]) || seconds[r] < 0 || seconds[r + 1] < 0)
      refuse(checkpoint, "invalid measured times; expected an undamaged file");
    work.element_seconds.push_back(seconds[r]);
    work.contact_seconds.push_back(seconds[r + 1]);
  }
  for (std::size_t e = 0; e < rows.size(); e += 2) {
    if (rows[e] < 0 || rows[e] >= ranks.rows || rows[e + 1] < 0)
      refuse(checkpoint, "invalid measured times; expected an undamaged file");
    work.rank.push_back(static_cast<Rank>(rows[e]));
    work.pairs.push_back(static_cast<double>(rows[e + 1]));
  }
  return work;
}

}  // namespace brunt::io
