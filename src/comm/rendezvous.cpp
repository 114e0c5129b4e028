// SPDX-License-Identifier: Apache-2.0
#include "comm/rendezvous.hpp"

#include <cstdint>
#include <limits>
#include <string>

#include "comm/message_time.hpp"
#include "comm/native.hpp"
#include "core/error.hpp"

namespace brunt::comm {

namespace {

/// Row lengths of the messages of every rank to this rank.
Ragged<std::byte> room_for_incoming(const Communicator& ranks, const std::vector<int>& out_length) {
  std::vector<int> in_length(out_length.size());
  count_collective(ranks, out_length.size() * sizeof(int));
  MPI_Alltoall(out_length.data(), 1, MPI_INT, in_length.data(), 1, MPI_INT, native(ranks));
  Ragged<std::byte> incoming;
  std::int64_t total = 0;
  for (const int length : in_length) {
    total += length;
    if (total > std::numeric_limits<LocalIndex>::max())
      throw MachineError("rank " + std::to_string(ranks.rank()) + " would receive more than 2 GiB in one exchange");
    incoming.offsets.push_back(static_cast<LocalIndex>(total));
  }
  incoming.values.resize(static_cast<std::size_t>(total));
  return incoming;
}

}  // namespace

Ragged<std::byte> exchange_bytes(const Communicator& ranks, const Ragged<std::byte>& outgoing) {
  const MessageTime timed;
  demand(outgoing.rows() == ranks.size(), "an exchange has one row for each rank");
  demand(outgoing.values.size() == static_cast<std::size_t>(outgoing.offsets.back()),
         "the rows of an exchange hold less than 2 GiB");
  std::vector<int> out_length;
  out_length.reserve(static_cast<std::size_t>(ranks.size()));
  for (Rank r = 0; r < ranks.size(); ++r) out_length.push_back(static_cast<int>(outgoing.row(r).size()));
  Ragged<std::byte> incoming = room_for_incoming(ranks, out_length);

  std::vector<MPI_Request> requests;
  for (Rank r = 0; r < ranks.size(); ++r) {
    const std::span<std::byte> row = incoming.row(r);
    if (!row.empty())
      MPI_Irecv(row.data(), static_cast<int>(row.size()), MPI_BYTE, r, 0, native(ranks), &requests.emplace_back());
  }
  for (Rank r = 0; r < ranks.size(); ++r) {
    const std::span<const std::byte> row = outgoing.row(r);
    if (!row.empty() && r != ranks.rank()) add_sent(NativeAccess::sent(ranks).exchange, 1, row.size());
    if (!row.empty())
      MPI_Isend(row.data(), static_cast<int>(row.size()), MPI_BYTE, r, 0, native(ranks), &requests.emplace_back());
  }
  MPI_Waitall(static_cast<int>(requests.size()), requests.data(), MPI_STATUSES_IGNORE);
  return incoming;
}

Rank BlockLayout::owner(GlobalIndex id) const {
  demand(id >= 0 && id < total, "an entity of a block layout lies between 0 and the total");
  const GlobalIndex longer = total % ranks;  // the first blocks have one more item
  const GlobalIndex length = total / ranks;
  const GlobalIndex in_longer = longer * (length + 1);
  return static_cast<Rank>(id < in_longer ? id / (length + 1) : longer + (id - in_longer) / length);
}

BlockRedistribution::BlockRedistribution(const Communicator& ranks, GlobalIndex total, std::span<const GlobalIndex> ids)
    : layout_{total, ranks.size()} {
  std::vector<RemoteSlot> source;
  source.reserve(ids.size());
  for (const GlobalIndex id : ids) {
    const Rank owner = layout_.owner(id);
    source.push_back({owner, static_cast<LocalIndex>(id - layout_.first(owner))});
  }
  halo_ = Halo(ranks, layout_.count(ranks.rank()), source);
}

void BlockRedistribution::to_blocks(std::span<const double> held, std::span<double> block, int width) const {
  halo_.backward(held, block, width);
}

void BlockRedistribution::from_blocks(std::span<const double> block, std::span<double> held, int width) const {
  halo_.forward(block, held, width);
}

}  // namespace brunt::comm
