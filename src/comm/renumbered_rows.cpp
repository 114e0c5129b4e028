// SPDX-License-Identifier: Apache-2.0
// The rows of each rank after those of the lower ranks, as required by a parallel solver: the numbers depend on the
// ranks.
#include <algorithm>
#include <utility>

#include "bytes.hpp"
#include "comm/native.hpp"
#include "row_layout.hpp"

namespace brunt::comm {
namespace {

class RenumberedRows final : public RowLayout {
 public:
  RenumberedRows(const Communicator& ranks, GlobalIndex unknowns, std::span<const GlobalIndex> owned)
      : ranks_(ranks), number_of_(static_cast<std::size_t>(unknowns)) {
    std::vector<std::byte> in_order;
    for (const std::vector<std::byte>& bytes : ranks.gather(std::as_bytes(owned)))
      in_order.insert(in_order.end(), bytes.begin(), bytes.end());
    ranks.broadcast(in_order);
    SolverIndex number = 0;
    for (const GlobalIndex row : array_of<GlobalIndex>(in_order)) nth(number_of_, row) = number++;
  }

  [[nodiscard]] MPI_Comm solver_ranks() const override { return native(ranks_); }

  bool to_solver(const SparseRows& rows, RowRange& range) override {
    range.unknowns = static_cast<SolverIndex>(number_of_.size());
    range.begin.assign(rows.begin.begin(), rows.begin.end());
    std::vector<std::pair<SolverIndex, double>> entries;
    for (std::size_t i = 0; i + 1 < rows.begin.size(); ++i) {
      entries.clear();
      for (auto k = static_cast<std::size_t>(rows.begin[i]); k < static_cast<std::size_t>(rows.begin[i + 1]); ++k)
        entries.emplace_back(nth(number_of_, rows.column[k]), rows.value[k]);
      std::ranges::sort(entries, {}, &std::pair<SolverIndex, double>::first);
      for (const auto& [column, value] : entries) {
        range.column.push_back(column);
        range.value.push_back(value);
      }
    }
    const bool differs = range.begin != last_begin_ || range.column != last_column_;
    if (differs) {
      last_begin_ = range.begin;
      last_column_ = range.column;
    }
    return !ranks_.any(differs);
  }

  [[nodiscard]] std::vector<double> to_solver(std::span<const double> owned) const override {
    return {owned.begin(), owned.end()};
  }
  void from_solver(std::span<const double> values, std::span<double> owned) const override {
    std::ranges::copy(values, owned.begin());
  }

 private:
  Communicator ranks_;
  std::vector<SolverIndex> number_of_;  // the solver's, of every canonical row
  std::vector<SolverIndex> last_begin_, last_column_;
};

}  // namespace

std::unique_ptr<RowLayout> renumbered_rows(const Communicator& ranks, GlobalIndex unknowns,
                                           std::span<const GlobalIndex> owned_rows) {
  return std::make_unique<RenumberedRows>(ranks, unknowns, owned_rows);
}

}  // namespace brunt::comm
