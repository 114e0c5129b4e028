// SPDX-License-Identifier: Apache-2.0
#include "comm/deal_out.hpp"

#include <mpi.h>

#include <cstdint>
#include <cstring>
#include <deque>
#include <limits>
#include <map>

#include "comm/native.hpp"
#include "core/error.hpp"

namespace brunt::comm {
namespace {

using Bytes = std::vector<std::byte>;
constexpr int result_tag = 7;

/// Counter on the root, with one-sided access: a rank that computes need not respond.
class SharedCounter {
 public:
  explicit SharedCounter(MPI_Comm comm, bool root) {
    MPI_Win_allocate(root ? sizeof(std::int64_t) : 0, sizeof(std::int64_t), MPI_INFO_NULL, comm, &value_, &window_);
    MPI_Win_lock_all(0, window_);
    if (root) {
      *value_ = 0;
      MPI_Win_sync(window_);
    }
    MPI_Barrier(comm);
  }
  ~SharedCounter() {
    MPI_Win_unlock_all(window_);
    MPI_Win_free(&window_);
  }
  SharedCounter(const SharedCounter&) = delete;
  SharedCounter& operator=(const SharedCounter&) = delete;

  GlobalIndex next() {
    const std::int64_t one = 1;
    std::int64_t before = 0;
    MPI_Fetch_and_op(&one, &before, MPI_INT64_T, 0, 0, MPI_SUM, window_);
    MPI_Win_flush(0, window_);
    return before;
  }

 private:
  std::int64_t* value_ = nullptr;
  MPI_Win window_ = MPI_WIN_NULL;
};

/// Results on the root, kept until all previous ones have arrived.
class InOrder {
 public:
  explicit InOrder(const std::function<void(GlobalIndex, std::span<const std::byte>)>& take) : take_(take) {}
  void add(GlobalIndex k, Bytes bytes) {
    waiting_.emplace(k, std::move(bytes));
    for (auto first = waiting_.begin(); first != waiting_.end() && first->first == next_; first = waiting_.begin()) {
      take_(first->first, first->second);
      waiting_.erase(first);
      ++next_;
    }
  }
  [[nodiscard]] GlobalIndex next() const { return next_; }

 private:
  const std::function<void(GlobalIndex, std::span<const std::byte>)>& take_;
  std::map<GlobalIndex, Bytes> waiting_;
  GlobalIndex next_ = 0;
};

void receive(MPI_Comm comm, const MPI_Status& status, InOrder& results) {
  int size = 0;
  MPI_Get_count(&status, MPI_BYTE, &size);
  Bytes message(static_cast<std::size_t>(size));
  MPI_Recv(message.data(), size, MPI_BYTE, status.MPI_SOURCE, result_tag, comm, MPI_STATUS_IGNORE);
  GlobalIndex k = 0;
  demand(message.size() >= sizeof k, "a result carries its number");
  std::memcpy(&k, message.data(), sizeof k);
  results.add(k, Bytes(message.begin() + sizeof k, message.end()));
}

void receive_what_came(MPI_Comm comm, InOrder& results) {
  for (int there = 1; there != 0;) {
    MPI_Status status;
    MPI_Iprobe(MPI_ANY_SOURCE, result_tag, comm, &there, &status);
    if (there != 0) receive(comm, status, results);
  }
}

/// Pending messages of this rank.
class Outbox {
 public:
  void send(MPI_Comm comm, GlobalIndex k, const Bytes& bytes) {
    Bytes message(sizeof k + bytes.size());
    std::memcpy(message.data(), &k, sizeof k);
    if (!bytes.empty()) std::memcpy(message.data() + sizeof k, bytes.data(), bytes.size());
    demand(message.size() <= static_cast<std::size_t>(std::numeric_limits<int>::max()), "a result is below 2 GiB");
    Letter& letter = letters_.emplace_back(std::move(message), MPI_REQUEST_NULL);
    MPI_Isend(letter.message.data(), static_cast<int>(letter.message.size()), MPI_BYTE, 0, result_tag, comm,
              &letter.request);
    for (int done = 1; done != 0 && !letters_.empty();) {
      MPI_Test(&letters_.front().request, &done, MPI_STATUS_IGNORE);
      if (done != 0) letters_.pop_front();
    }
  }
  void wait() {
    for (Letter& letter : letters_) MPI_Wait(&letter.request, MPI_STATUS_IGNORE);
    letters_.clear();
  }

 private:
  struct Letter {
    Bytes message;
    MPI_Request request;
    Letter(Bytes text, MPI_Request none) : message(std::move(text)), request(none) {}
  };
  std::deque<Letter> letters_;
};

}  // namespace

void deal_out(const Communicator& ranks, GlobalIndex count, const std::function<Bytes(GlobalIndex)>& work,
              const std::function<void(GlobalIndex, std::span<const std::byte>)>& take) {
  InOrder results(take);
  if (ranks.size() == 1) {
    for (GlobalIndex k = 0; k < count; ++k) results.add(k, work(k));
    return;
  }
  MPI_Comm comm = native(ranks);
  const bool root = ranks.is_root();
  SharedCounter counter(comm, root);
  Outbox outbox;
  for (GlobalIndex k = counter.next(); k < count; k = counter.next()) {
    Bytes bytes = work(k);
    if (!root) {
      outbox.send(comm, k, bytes);
      add_sent(NativeAccess::sent(ranks).exchange, 1, sizeof k + bytes.size());
      continue;
    }
    results.add(k, std::move(bytes));
    receive_what_came(comm, results);
  }
  while (root && results.next() < count) {
    MPI_Status status;
    MPI_Probe(MPI_ANY_SOURCE, result_tag, comm, &status);
    receive(comm, status, results);
  }
  outbox.wait();
  ranks.barrier();
}

}  // namespace brunt::comm
