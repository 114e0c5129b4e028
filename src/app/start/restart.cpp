// SPDX-License-Identifier: Apache-2.0
#include "restart.hpp"

#include <fmt/format.h>

#include <filesystem>

#include "app/program/failure.hpp"
#include "app/whole/same_scene.hpp"
#include "core/error.hpp"
#include "implicit/solver.hpp"

namespace brunt::app {
namespace {

/// A checkpoint that is more than a step past the end asked for belongs to a longer run.
void refuse_past_end(const Prepared& run, const std::string& checkpoint) {
  const scene::Run& limits = run.input.run;
  const model::State& state = run.state;
  if (limits.end && state.time_before >= *limits.end)
    throw InputError(fmt::format("{}: out of range: {:g} has passed: {} is at t = {:g}; expected a later time",
                                 run.input.at("run.end"), *limits.end, checkpoint, state.time));
  if (limits.steps && state.step > static_cast<double>(*limits.steps))
    throw InputError(
        fmt::format("{}: out of range: {}: {} is at step {}; expected more than {}, since the steps before "
                    "the restart count",
                    run.input.at("run.steps"), *limits.steps, checkpoint, static_cast<GlobalIndex>(state.step),
                    static_cast<GlobalIndex>(state.step)));
}

/// A file of a program that did not save the step is continued only with the same one.
void refuse_other_step(const Prepared& run, const std::string& checkpoint) {
  if (!run.implicit) return;
  const model::ImplicitSolver& settings = run.implicit->settings;
  if (implicit::time_of(settings, run.implicit->memory.length) == run.state.time) return;
  throw InputError(
      fmt::format("{}: invalid for this scene: at t = {:g}, which is no multiple of solver.step {:g}, and an "
                  "earlier version did not save its step; expected run.end of the earlier run",
                  checkpoint, run.state.time, settings.step));
}

/// The last one before a checkpoint that can be read and is of this scene; empty where there is none. Collective.
std::string whole_before(Prepared& run, const std::string& checkpoint) {
  const comm::Communicator& ranks = run.links.ranks;
  std::string joined;  // as the root sees the folder
  if (ranks.is_root())
    for (const std::string& path : io::checkpoints_before(checkpoint)) joined += path + '\n';
  ranks.broadcast(joined);
  for (std::size_t first = 0, end = joined.find('\n'); end != std::string::npos;
       first = end + 1, end = joined.find('\n', first)) {
    std::string path = joined.substr(first, end - first);
    try {
      (void)io::read_checkpoint(ranks, path, run.fingerprint, run.registry());
      return path;
    } catch (const InputError&) {  // damaged as well
    }
  }
  return {};
}

}  // namespace

std::string checkpoint_of(const comm::Communicator& ranks, const std::string& restart) {
  std::string path = restart;
  on_root(ranks, [&] {
    if (!std::filesystem::exists(restart))
      throw InputError(restart +
                       ": cannot read the restart: no such file or folder; expected a checkpoint or a result folder");
    if (!std::filesystem::is_directory(restart)) return;
    const std::optional<std::string> latest = io::latest_checkpoint(restart);
    if (!latest) throw InputError(restart + ": missing checkpoint_*.h5; expected a checkpoint in the folder");
    path = *latest;
  });
  ranks.broadcast(path);
  return path;
}

io::CheckpointHeader restart_from(Prepared& run, const std::string& checkpoint) {
  const comm::Communicator& ranks = run.links.ranks;
  io::CheckpointHeader header;
  std::vector<std::string> faults;
  try {
    header = io::read_checkpoint_header(ranks, checkpoint);
    refuse_other_scene(checkpoint, {header.fingerprint, header.scene}, {run.fingerprint, run.scene_values});
    // one of a program that did not save it begins anew
    run.assembled = time::AssembledStep{.baseline = std::move(run.assembled.baseline)};
    header = io::read_checkpoint(ranks, checkpoint, expected_of(header.fingerprint, run.fingerprint), run.registry());
  } catch (const InputError& error) {
    faults = error.faults();
  }
  if (!faults.empty()) {
    if (const std::string before = whole_before(run, checkpoint); !before.empty())
      faults.back() += fmt::format("; the previous checkpoint is intact and of this scene: --restart {}", before);
    throw InputError(std::move(faults));
  }
  run.after_restart();
  refuse_other_step(run, checkpoint);
  refuse_past_end(run, checkpoint);
  return header;
}

}  // namespace brunt::app
