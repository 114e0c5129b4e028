// SPDX-License-Identifier: Apache-2.0
// All rows on the root, in canonical order: the factorised matrix depends on the problem, not on the ranks.
#include <algorithm>
#include <cstdint>

#include "bytes.hpp"
#include "core/error.hpp"
#include "row_layout.hpp"

namespace brunt::comm {
namespace {

class GatheredRows final : public RowLayout {
 public:
  GatheredRows(const Communicator& ranks, GlobalIndex unknowns, std::span<const GlobalIndex> owned)
      : ranks_(ranks), unknowns_(unknowns) {
    for (const std::vector<std::byte>& bytes : ranks.gather(std::as_bytes(owned)))
      row_of_rank_.push_back(array_of<GlobalIndex>(bytes));
  }

  [[nodiscard]] MPI_Comm solver_ranks() const override { return ranks_.is_root() ? MPI_COMM_SELF : MPI_COMM_NULL; }

  bool to_solver(const SparseRows& rows, RowRange& range) override {
    const auto lengths = ranks_.gather(std::as_bytes(std::span(rows.begin)));
    const auto columns = ranks_.gather(std::as_bytes(std::span(rows.column)));
    const auto values = ranks_.gather(std::as_bytes(std::span(rows.value)));
    if (!ranks_.is_root()) return true;
    lay_begins(lengths, range);
    range.column.resize(static_cast<std::size_t>(range.begin.back()));
    range.value.resize(range.column.size());
    for (std::size_t r = 0; r < row_of_rank_.size(); ++r)
      lay_rows(row_of_rank_[r], array_of<std::int64_t>(lengths[r]), columns[r], values[r], range);
    const bool same = range.begin == last_begin_ && range.column == last_column_;
    if (!same) {
      last_begin_ = range.begin;
      last_column_ = range.column;
    }
    return same;
  }

  [[nodiscard]] std::vector<double> to_solver(std::span<const double> owned) const override {
    const auto of_rank = ranks_.gather(std::as_bytes(owned));
    std::vector<double> all(ranks_.is_root() ? static_cast<std::size_t>(unknowns_) : 0);
    for (std::size_t r = 0; r < of_rank.size(); ++r) {
      const std::vector<double> values = array_of<double>(of_rank[r]);
      for (std::size_t i = 0; i < values.size(); ++i) nth(all, row_of_rank_[r][i]) = values[i];
    }
    return all;
  }

  void from_solver(std::span<const double> values, std::span<double> owned) const override {
    const auto bytes = ranks_.scatter([&](Rank r) {
      std::vector<double> of_rank;
      for (const GlobalIndex row : nth(row_of_rank_, r)) of_rank.push_back(nth(values, row));
      const auto raw = std::as_bytes(std::span(of_rank));
      return std::vector<std::byte>(raw.begin(), raw.end());
    });
    std::ranges::copy(array_of<double>(bytes), owned.begin());
  }

 private:
  void lay_begins(const std::vector<std::vector<std::byte>>& lengths, RowRange& range) const {
    range.unknowns = static_cast<SolverIndex>(unknowns_);
    range.begin.assign(static_cast<std::size_t>(unknowns_) + 1, 0);
    for (std::size_t r = 0; r < row_of_rank_.size(); ++r) {
      const auto begin = array_of<std::int64_t>(lengths[r]);
      for (std::size_t i = 0; i < row_of_rank_[r].size(); ++i)
        range.begin[static_cast<std::size_t>(row_of_rank_[r][i]) + 1] =
            static_cast<SolverIndex>(begin[i + 1] - begin[i]);
    }
    for (std::size_t i = 1; i < range.begin.size(); ++i) range.begin[i] += range.begin[i - 1];
  }

  static void lay_rows(std::span<const GlobalIndex> row, std::span<const std::int64_t> begin,
                       std::span<const std::byte> columns, std::span<const std::byte> values, RowRange& range) {
    for (std::size_t i = 0; i < row.size(); ++i) {
      auto at = static_cast<std::size_t>(nth(range.begin, row[i]));
      for (auto k = static_cast<std::size_t>(begin[i]); k < static_cast<std::size_t>(begin[i + 1]); ++k, ++at) {
        GlobalIndex column = 0;
        std::memcpy(&column, columns.data() + k * sizeof(column), sizeof(column));
        range.column[at] = static_cast<SolverIndex>(column);
        std::memcpy(&range.value[at], values.data() + k * sizeof(double), sizeof(double));
      }
    }
  }

  Communicator ranks_;
  GlobalIndex unknowns_;
  std::vector<std::vector<GlobalIndex>> row_of_rank_;  // on the root
  std::vector<SolverIndex> last_begin_, last_column_;
};

}  // namespace

std::unique_ptr<RowLayout> gathered_rows(const Communicator& ranks, GlobalIndex unknowns,
                                         std::span<const GlobalIndex> owned_rows) {
  return std::make_unique<GatheredRows>(ranks, unknowns, owned_rows);
}

}  // namespace brunt::comm
