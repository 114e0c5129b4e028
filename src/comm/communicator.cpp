// SPDX-License-Identifier: Apache-2.0
#include "comm/communicator.hpp"

#include <mpi.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <cstring>
#include <limits>

#include "comm/message_time.hpp"
#include "comm/native.hpp"
#include "core/error.hpp"

namespace brunt::comm {

namespace {

/// Data of one reduction: maxima as `ordered` keys, then sums.
struct Mixed {
  static constexpr std::size_t room = 6;
  std::array<std::int64_t, room> largest;
  std::array<std::uint64_t, room> sum;  // unsigned: overflow of a signed sum is undefined
};

void combine_mixed(void* incoming, void* result, int* count, MPI_Datatype* /*type*/) {
  const auto* in = static_cast<const Mixed*>(incoming);
  auto* out = static_cast<Mixed*>(result);
  for (int i = 0; i < *count; ++i) {
    for (std::size_t k = 0; k < Mixed::room; ++k) {
      out[i].largest[k] = std::max(out[i].largest[k], in[i].largest[k]);
      out[i].sum[k] += in[i].sum[k];
    }
  }
}

}  // namespace

struct Communicator::Native {
  MPI_Comm comm = MPI_COMM_NULL;
  MPI_Datatype mixed = MPI_DATATYPE_NULL;
  MPI_Op combine = MPI_OP_NULL;
  MPI_Request pending = MPI_REQUEST_NULL;  // of begin_max
  int rank = 0;
  int size = 1;
  Traffic sent;

  explicit Native(MPI_Comm parent) {
    MPI_Comm_dup(parent, &comm);
    MPI_Comm_rank(comm, &rank);
    MPI_Comm_size(comm, &size);
    MPI_Type_contiguous(2 * Mixed::room, MPI_INT64_T, &mixed);
    MPI_Type_commit(&mixed);
    MPI_Op_create(combine_mixed, 1, &combine);
  }
  ~Native() {
    int ended = 0;
    MPI_Finalized(&ended);
    if (ended != 0) return;
    MPI_Op_free(&combine);
    MPI_Type_free(&mixed);
    MPI_Comm_free(&comm);
  }
  Native(const Native&) = delete;
  Native& operator=(const Native&) = delete;
};

MPI_Comm NativeAccess::of(const Communicator& ranks) {
  return ranks.native_->comm;
}
Communicator NativeAccess::on(MPI_Comm ranks) {
  return Communicator(std::make_shared<Communicator::Native>(ranks));
}
Traffic& NativeAccess::sent(const Communicator& ranks) {
  return ranks.native_->sent;
}
Traffic sent_by(const Communicator& ranks) {
  return NativeAccess::sent(ranks);
}

namespace {

int count_of(std::size_t n) {
  demand(n <= static_cast<std::size_t>(std::numeric_limits<int>::max()), "a message has fewer than 2^31 items");
  return static_cast<int>(n);
}

/// Integers in the order of the doubles, with every NaN above all numbers: MPI_MAX on doubles may return different
/// results on different ranks if one operand is NaN.
std::int64_t ordered(double value) {
  if (value != value) return std::numeric_limits<std::int64_t>::max();
  const auto bits = std::bit_cast<std::int64_t>(value);
  return bits >= 0 ? bits : bits ^ std::numeric_limits<std::int64_t>::max();
}
double from_ordered(std::int64_t key) {
  return std::bit_cast<double>(key >= 0 ? key : key ^ std::numeric_limits<std::int64_t>::max());
}

void to_keys(std::span<double> values) {
  static_assert(sizeof(double) == sizeof(std::int64_t));
  for (double& value : values) {
    const std::int64_t key = ordered(value);
    std::memcpy(&value, &key, sizeof key);  // not a double: some keys are NaNs, whose bits copies may change
  }
}
void from_keys(std::span<double> values) {
  for (double& value : values) {
    std::int64_t key = 0;
    std::memcpy(&key, &value, sizeof key);
    value = from_ordered(key);
  }
}

// MPI counts are 32-bit: longer byte strings are sent in pieces.
constexpr std::size_t piece = std::size_t{1} << 30;

template <class Move>
void in_pieces(std::size_t size, Move&& move) {
  for (std::size_t at = 0; at < size; at += piece) move(at, static_cast<int>(std::min(piece, size - at)));
}

void send_bytes(const Communicator& ranks, std::span<const std::byte> bytes, Rank to) {
  const std::uint64_t size = bytes.size();
  Sent& sent = NativeAccess::sent(ranks).exchange;
  MPI_Send(&size, 1, MPI_UINT64_T, to, 0, native(ranks));
  add_sent(sent, 1, sizeof size);
  in_pieces(bytes.size(), [&](std::size_t at, int n) {
    MPI_Send(bytes.data() + at, n, MPI_BYTE, to, 0, native(ranks));
    add_sent(sent, 1, static_cast<std::size_t>(n));
  });
}

std::vector<std::byte> receive_bytes(MPI_Comm comm, Rank from) {
  std::uint64_t size = 0;
  MPI_Recv(&size, 1, MPI_UINT64_T, from, 0, comm, MPI_STATUS_IGNORE);
  std::vector<std::byte> bytes(size);
  in_pieces(size,
            [&](std::size_t at, int n) { MPI_Recv(bytes.data() + at, n, MPI_BYTE, from, 0, comm, MPI_STATUS_IGNORE); });
  return bytes;
}

}  // namespace

Communicator::Communicator(std::shared_ptr<Native> native) : native_(std::move(native)) {}
Communicator Communicator::world() {
  return Communicator(std::make_shared<Native>(MPI_COMM_WORLD));
}
Communicator Communicator::self() {
  return Communicator(std::make_shared<Native>(MPI_COMM_SELF));
}
Rank Communicator::rank() const {
  return native_->rank;
}
int Communicator::size() const {
  return native_->size;
}

void Communicator::barrier() const {
  count_collective(*this, 0);
  MPI_Barrier(native_->comm);
}

double Communicator::max(double value) const {
  max(std::span<double>(&value, 1));
  return value;
}

double Communicator::min(double value) const {
  return -max(-value);
}

void Communicator::max(std::span<double> values) const {
  count_collective(*this, values.size_bytes());
  const MessageTime timed;
  to_keys(values);
  MPI_Allreduce(MPI_IN_PLACE, values.data(), count_of(values.size()), MPI_INT64_T, MPI_MAX, native_->comm);
  from_keys(values);
}

void Communicator::begin_max(std::span<double> values) const {
  count_collective(*this, values.size_bytes());
  demand(native_->pending == MPI_REQUEST_NULL, "one reduction travels at a time");
  to_keys(values);
  MPI_Iallreduce(MPI_IN_PLACE, values.data(), count_of(values.size()), MPI_INT64_T, MPI_MAX, native_->comm,
                 &native_->pending);
}

void Communicator::end_max(std::span<double> values) const {
  const MessageTime timed;
  MPI_Wait(&native_->pending, MPI_STATUS_IGNORE);  // NOLINT(clang-analyzer-optin.mpi.MPI-Checker): of begin_max
  from_keys(values);
}

GlobalIndex Communicator::sum(GlobalIndex value) const {
  sum(std::span<GlobalIndex>(&value, 1));
  return value;
}

void Communicator::sum(std::span<GlobalIndex> values) const {
  count_collective(*this, values.size_bytes());
  const MessageTime timed;
  // unsigned: overflow of a signed sum is undefined
  MPI_Allreduce(MPI_IN_PLACE, values.data(), count_of(values.size()), MPI_UINT64_T, MPI_SUM, native_->comm);
}

void Communicator::max_and_sum(std::span<double> largest, std::span<GlobalIndex> sums) const {
  demand(largest.size() <= Mixed::room && sums.size() <= Mixed::room, "a reduction carries six maxima and six sums");
  const MessageTime timed;
  Mixed mixed{};
  for (std::size_t k = 0; k < largest.size(); ++k) mixed.largest[k] = ordered(largest[k]);
  for (std::size_t k = 0; k < sums.size(); ++k) mixed.sum[k] = static_cast<std::uint64_t>(sums[k]);
  count_collective(*this, sizeof mixed);
  MPI_Allreduce(MPI_IN_PLACE, &mixed, 1, native_->mixed, native_->combine, native_->comm);
  for (std::size_t k = 0; k < largest.size(); ++k) largest[k] = from_ordered(mixed.largest[k]);
  for (std::size_t k = 0; k < sums.size(); ++k) sums[k] = static_cast<GlobalIndex>(mixed.sum[k]);
}

GlobalIndex Communicator::max(GlobalIndex value) const {
  count_collective(*this, sizeof value);
  const MessageTime timed;
  MPI_Allreduce(MPI_IN_PLACE, &value, 1, MPI_INT64_T, MPI_MAX, native_->comm);
  return value;
}

bool Communicator::any(bool value) const {
  return max(GlobalIndex{value ? 1 : 0}) != 0;
}

GlobalIndex Communicator::sum_before(GlobalIndex value) const {
  const MessageTime timed;
  GlobalIndex before = 0;
  count_collective(*this, sizeof value);
  MPI_Exscan(&value, &before, 1, MPI_INT64_T, MPI_SUM, native_->comm);
  return rank() == 0 ? 0 : before;
}

void Communicator::broadcast(std::vector<std::byte>& bytes, Rank root) const {
  std::uint64_t size = bytes.size();
  count_collective(*this, rank() == root ? sizeof size + bytes.size() : 0);
  MPI_Bcast(&size, 1, MPI_UINT64_T, root, native_->comm);
  bytes.resize(size);
  in_pieces(size, [&](std::size_t at, int n) { MPI_Bcast(bytes.data() + at, n, MPI_BYTE, root, native_->comm); });
}

void Communicator::broadcast(std::string& text, Rank root) const {
  const auto* first = reinterpret_cast<const std::byte*>(text.data());
  std::vector<std::byte> bytes(first, first + text.size());
  broadcast(bytes, root);
  text.assign(reinterpret_cast<const char*>(bytes.data()), bytes.size());
}

std::vector<std::vector<std::byte>> Communicator::gather(std::span<const std::byte> bytes, Rank root) const {
  if (rank() != root) {
    send_bytes(*this, bytes, root);
    return {};
  }
  std::vector<std::vector<std::byte>> of_rank;
  of_rank.reserve(static_cast<std::size_t>(size()));
  for (Rank r = 0; r < size(); ++r)
    of_rank.push_back(r == root ? std::vector<std::byte>(bytes.begin(), bytes.end()) : receive_bytes(native_->comm, r));
  return of_rank;
}

std::vector<std::byte> Communicator::scatter(const std::function<std::vector<std::byte>(Rank)>& for_rank,
                                             Rank root) const {
  if (rank() != root) return receive_bytes(native_->comm, root);
  for (Rank r = 0; r < size(); ++r)
    if (r != root) send_bytes(*this, for_rank(r), r);
  return for_rank(root);
}

std::vector<double> Communicator::gather_all(double value) const {
  std::vector<double> values(static_cast<std::size_t>(size()));
  count_collective(*this, sizeof value);
  MPI_Allgather(&value, 1, MPI_DOUBLE, values.data(), 1, MPI_DOUBLE, native_->comm);
  return values;
}

}  // namespace brunt::comm
