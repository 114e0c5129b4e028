// SPDX-License-Identifier: Apache-2.0
#include "comm/halo.hpp"

#include <petscsf.h>

#include <map>
#include <string>

#include "comm/message_time.hpp"
#include "comm/native.hpp"
#include "core/error.hpp"

namespace brunt::comm {

namespace {

void check(PetscErrorCode code, const char* call) {
  if (code != 0) throw MachineError(std::string("PETSc: ") + call + " failed with code " + std::to_string(code));
}

}  // namespace

struct Halo::Forest {
  Communicator ranks;
  LocalIndex roots = 0;
  LocalIndex leaves = 0;
  PetscSF sf = nullptr;
  Sent to_leaves, to_roots;          // of one exchange, by direction; bytes of width 1
  std::map<int, MPI_Datatype> unit;  // `width` doubles; made once: a new type would make PETSc build new buffers

  Forest(const Communicator& on, LocalIndex root_count, LocalIndex leaf_count)
      : ranks(on), roots(root_count), leaves(leaf_count) {
    check(PetscSFCreate(native(ranks), &sf), "PetscSFCreate");
  }
  ~Forest() {
    PetscBool ended = PETSC_FALSE;
    PetscFinalized(&ended);
    if (ended == PETSC_TRUE) return;
    PetscSFDestroy(&sf);
    for (auto& [width, type] : unit) MPI_Type_free(&type);
  }
  Forest(const Forest&) = delete;
  Forest& operator=(const Forest&) = delete;

  MPI_Datatype type_of(int width) {
    auto [entry, is_new] = unit.try_emplace(width, MPI_DATATYPE_NULL);
    if (is_new) {
      MPI_Type_contiguous(width, MPI_DOUBLE, &entry->second);
      MPI_Type_commit(&entry->second);
    }
    return entry->second;
  }

  void demand_sizes(std::size_t root_values, std::size_t leaf_values, int width) const {
    demand(width > 0, "the width of a halo exchange is positive");
    demand(root_values >= static_cast<std::size_t>(roots) * static_cast<std::size_t>(width),
           "a halo exchange is given a value for each root");
    demand(leaf_values >= static_cast<std::size_t>(leaves) * static_cast<std::size_t>(width),
           "a halo exchange is given room for each leaf");
  }
};

namespace {

/// Values for other ranks: a list of ranks and the offsets of their values.
Sent sent_to_others(const Communicator& ranks, PetscInt count_of_ranks, const PetscMPIInt* rank,
                    const PetscInt* offset) {
  Sent sent;
  for (PetscInt i = 0; i < count_of_ranks; ++i)
    if (rank[i] != ranks.rank() && offset[i + 1] > offset[i])
      add_sent(sent, 1, static_cast<std::size_t>(offset[i + 1] - offset[i]) * sizeof(double));
  return sent;
}

void count_exchange(const Communicator& ranks, const Sent& of_width_one, int width) {
  add_sent(NativeAccess::sent(ranks).halo, static_cast<std::size_t>(of_width_one.messages),
           static_cast<std::size_t>(of_width_one.bytes) * static_cast<std::size_t>(width));
}

/// Each rank checks the requests for its roots, so that a wrong index is detected where it would be used. Returns their
/// layout for sending.
Sent demand_roots_exist(const Communicator& ranks, PetscSF sf, LocalIndex roots) {
  PetscInt askers = 0;
  const PetscMPIInt* rank = nullptr;
  const PetscInt* offset = nullptr;
  const PetscInt* root = nullptr;
  check(PetscSFGetLeafRanks(sf, &askers, &rank, &offset, &root), "PetscSFGetLeafRanks");
  const PetscInt wanted = askers > 0 ? offset[askers] : 0;
  for (PetscInt i = 0; i < wanted; ++i) demand(root[i] < roots, "a halo's source is a root of its rank");
  return sent_to_others(ranks, askers, rank, offset);
}

/// The layout of the leaves of this rank for sending to their roots.
Sent leaves_sent(const Communicator& ranks, PetscSF sf) {
  PetscInt owners = 0;
  const PetscMPIInt* rank = nullptr;
  const PetscInt* offset = nullptr;
  check(PetscSFGetRootRanks(sf, &owners, &rank, &offset, nullptr, nullptr), "PetscSFGetRootRanks");
  return sent_to_others(ranks, owners, rank, offset);
}

}  // namespace

Halo::Halo(const Communicator& ranks, LocalIndex roots, std::span<const RemoteSlot> source)
    : forest_(std::make_shared<Forest>(ranks, roots, static_cast<LocalIndex>(source.size()))) {
  std::vector<PetscSFNode> remote;
  remote.reserve(source.size());
  for (const RemoteSlot& slot : source) {
    demand(slot.rank >= 0 && slot.rank < ranks.size(), "a halo's source is on a rank of the communicator");
    demand(slot.index >= 0, "a halo's source is a root of its rank");
    remote.push_back({slot.rank, slot.index});
  }
  PetscSF sf = forest_->sf;
  check(PetscSFSetGraph(sf, roots, forest_->leaves, nullptr, PETSC_COPY_VALUES, remote.data(), PETSC_COPY_VALUES),
        "PetscSFSetGraph");
  check(PetscSFSetUp(sf), "PetscSFSetUp");
  forest_->to_leaves = demand_roots_exist(ranks, sf, roots);
  forest_->to_roots = leaves_sent(ranks, sf);
}

LocalIndex Halo::roots() const {
  return forest_ ? forest_->roots : 0;
}
LocalIndex Halo::leaves() const {
  return forest_ ? forest_->leaves : 0;
}

void Halo::begin(std::span<const double> roots, std::span<double> leaves, int width) const {
  if (!forest_) return;
  const MessageTime timed;
  forest_->demand_sizes(roots.size(), leaves.size(), width);
  count_exchange(forest_->ranks, forest_->to_leaves, width);
  check(PetscSFBcastBegin(forest_->sf, forest_->type_of(width), roots.data(), leaves.data(), MPI_REPLACE),
        "PetscSFBcastBegin");
}

void Halo::end(std::span<const double> roots, std::span<double> leaves, int width) const {
  if (!forest_) return;
  const MessageTime timed;
  check(PetscSFBcastEnd(forest_->sf, forest_->type_of(width), roots.data(), leaves.data(), MPI_REPLACE),
        "PetscSFBcastEnd");
}

void Halo::backward(std::span<const double> leaves, std::span<double> roots, int width) const {
  if (!forest_) return;
  const MessageTime timed;
  forest_->demand_sizes(roots.size(), leaves.size(), width);
  count_exchange(forest_->ranks, forest_->to_roots, width);
  MPI_Datatype type = forest_->type_of(width);
  check(PetscSFReduceBegin(forest_->sf, type, leaves.data(), roots.data(), MPI_REPLACE), "PetscSFReduceBegin");
  check(PetscSFReduceEnd(forest_->sf, type, leaves.data(), roots.data(), MPI_REPLACE), "PetscSFReduceEnd");
}

}  // namespace brunt::comm
