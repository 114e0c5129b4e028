// SPDX-License-Identifier: Apache-2.0
#include "prepare.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cstring>
#include <span>
#include <type_traits>

#include "app/program/failure.hpp"
#include "app/state/contact_setup.hpp"
#include "app/watch/driven_apart.hpp"
#include "app/watch/implicit_watch.hpp"
#include "app/whole/bodies.hpp"
#include "app/whole/coarse_slave_warnings.hpp"
#include "app/whole/same_scene.hpp"
#include "app/whole/weights.hpp"
#include "app/whole/whole_scene.hpp"
#include "driven_starts.hpp"
#include "implicit/tied_velocities.hpp"
#include "implicit_rules.hpp"
#include "io/results/partition_file.hpp"
#include "joint_starts.hpp"
#include "partition/distribute.hpp"
#include "partition/dual_graph.hpp"
#include "partition/split.hpp"
#include "rotation_rules.hpp"
#include "scene/build/build.hpp"
#include "scene/build/select.hpp"
#include "scene/text/units.hpp"
#include "time/initialise.hpp"

namespace brunt::app {
namespace {

/// What the root has found goes to all ranks.
template <class T>
void share(const comm::Communicator& ranks, std::vector<T>& values) {
  static_assert(std::is_trivially_copyable_v<T>);
  const auto raw = std::as_bytes(std::span(values));
  std::vector<std::byte> bytes(raw.begin(), raw.end());
  ranks.broadcast(bytes);
  values.resize(bytes.size() / sizeof(T));
  if (!bytes.empty()) std::memcpy(values.data(), bytes.data(), bytes.size());
}

/// The parts of the elements as a file gives them. Root only; throws InputError.
std::vector<Rank> given_partition(const Prepared& run, const mesh::CanonicalMesh& whole, const std::string& path) {
  io::PartitionFile given = io::read_partition(path);
  refuse_other_scene(path, {given.fingerprint, given.scene}, {run.fingerprint, run.scene_values});
  const int ranks = run.links.ranks.size();
  if (given.parts != ranks)
    throw InputError(fmt::format("{}: invalid partition of {} parts for a run of {} rank{}; expected one of -n {}",
                                 path, given.parts, ranks, ranks == 1 ? "" : "s", ranks));
  const auto elements = static_cast<std::size_t>(partition::first_of_block(whole.mesh).back());
  if (given.part.size() != elements)
    throw InputError(fmt::format("{}: invalid partition of {} elements; expected {} as in the scene", path,
                                 given.part.size(), elements));
  return std::move(given.part);
}

/// Refuses what implicit scenes cannot do, and sizes what their steps need. Collective.
void make_implicit(Prepared& run) {
  if (std::vector<std::string> faults = faults_of_implicit(run.input, run.model); !faults.empty())
    throw InputError(std::move(faults));
  if (!run.input.implicit) return;
  if (run.links.ranks.is_root())
    for (std::string& line : warnings_of_implicit(run.input, run.model)) run.warnings.push_back(std::move(line));
  run.implicit =
      implicit::SolverOwner(new implicit::Solver(implicit::make_solver(implicit_scene(run), *run.input.implicit)));
  for (std::string& line : implicit::warnings_of_tied_velocities(implicit_scene(run), *run.implicit,
                                                                 scene::find_unit_system(run.input.units)->velocity))
    if (run.links.ranks.is_root()) run.warnings.push_back(std::move(line));
  if (run.input.run.end) run.implicit->stability.last_time = *run.input.run.end;
  if (run.input.run.steps) run.implicit->stability.last_step = static_cast<double>(*run.input.run.steps);
  if (run.links.ranks.is_root())
    for (const std::string& note : run.implicit->contact.notes) run.overlaps.report.notes.push_back(note);
  if (run.links.ranks.is_root())
    for (const std::string& warning : run.implicit->contact.warnings) run.warnings.push_back(warning);
  if (run.links.ranks.is_root() && run.overlaps.recovered)
    for (std::string& note : notes_of_overlaps(run.input)) run.overlaps.report.notes.push_back(std::move(note));
  refuse_driven_apart(run);
  watch_implicit(run);
}

}  // namespace

void refuse_overlaps(Prepared& run) {
  const OverlapReport& report = run.overlaps.report;
  on_root(run.links.ranks, [&] {
    if (!report.faults.empty()) throw InputError(report.faults);
    run.warnings.insert(run.warnings.end(), report.warnings.begin(), report.warnings.end());
  });
}

std::unique_ptr<Prepared> prepare(const comm::Communicator& ranks, const std::string& scene_file,
                                  const std::vector<std::string>& overrides, const std::string& partition) {
  auto prepared = std::make_unique<Prepared>(Prepared{.links = {.ranks = ranks}});
  prepared->input =
      read_input(ranks, scene_file, overrides, &prepared->fingerprint, &prepared->scene_values, &prepared->scene_yaml);
  mesh::CanonicalMesh whole;
  std::vector<Rank> part;
  std::vector<std::size_t> part_of_block;
  on_root(ranks, [&] {
    prepared->warnings = prepared->input.warnings;
    whole = whole_mesh(prepared->input, prepared->warnings, &prepared->start_up);
    prepared->fingerprint = with_mesh(prepared->fingerprint, whole);
    prepared->left_out = left_out_lines(whole.mesh);
    prepared->overlaps = treat_overlaps(prepared->input, whole);
    for (std::string& line : scene::nearest_nodes(prepared->input, whole))
      prepared->overlaps.report.notes.push_back(std::move(line));
    for (std::string& line : warn_of_coarse_slaves(prepared->input, whole))
      prepared->warnings.push_back(std::move(line));
    part_of_block = scene::parts_of_blocks(prepared->input, whole.mesh);
    prepared->start_up.end(StartStage::checking);
    part = partition.empty()
               ? partition::split(partition::dual_graph(whole.mesh), weigh(prepared->input, whole), ranks.size())
               : given_partition(*prepared, whole, partition);
  });
  ranks.broadcast(prepared->fingerprint);
  prepared->start_up.end(StartStage::partitioning);
  share(ranks, prepared->overlaps.accepted);
  share(ranks, part_of_block);
  prepared->overlaps.recovered = ranks.any(prepared->overlaps.recovered);
  mesh::LocalMesh local = partition::distribute(ranks, whole, part);
  whole = {};
  release_freed_memory();
  prepared->start_up.end(StartStage::distributing);

  std::vector<std::string> faults;
  try {
    prepared->model = scene::build_model(prepared->input, part_of_block, std::move(local));
  } catch (const InputError& error) {
    faults = error.faults();
  }
  // a fault may show on one rank only: the first rank that has one speaks for all
  for (Rank r = 0; r < ranks.size(); ++r) share_faults(ranks, faults, r);
  prepared->links = time::link_ranks(ranks, prepared->model);
  const std::vector<Vec3> velocities = scene::initial_velocities(prepared->input, prepared->model);
  time::initialise(prepared->model, prepared->state, prepared->scratch, prepared->links, velocities,
                   scene::initial_rates(prepared->input, prepared->model));
  check_joints(*prepared);
  check_rotation_probes(*prepared);
  for (std::string& line : driven_starts(*prepared, velocities)) prepared->warnings.push_back(std::move(line));
  if (bounded_by_mesh(prepared->input)) prepared->assembled.baseline = force::sized_baseline(prepared->model);
  make_implicit(*prepared);
  prepared->erosion = {
      prepared->model.any_erosion(), std::vector<time::ErosionCount>(prepared->model.blocks.size()), {}, 0};
  make_contact(*prepared);
  prepared->driven.prepare(prepared->contact.get());
  prepared->force_memory.assign(4 * prepared->input.probes.size(), 0.0);
  if (std::ranges::find(prepared->input.probes, scene::Probe::Kind::contact, &scene::Probe::kind) !=
      prepared->input.probes.end())
    prepared->contact_memory.assign(contact_memory_width * prepared->input.probes.size(), 0.0);
  release_freed_memory();
  prepared->start_up.end(StartStage::building);
  return prepared;
}

}  // namespace brunt::app
