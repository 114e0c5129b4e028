// SPDX-License-Identifier: Apache-2.0
// The program `brunt`: its commands and their options.
#include <fmt/core.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <exception>
#include <functional>
#include <string>
#include <vector>

#include "app/program/commands.hpp"
#include "app/program/failure.hpp"
#include "app/run/run.hpp"
#include "comm/communicator.hpp"
#include "comm/session.hpp"
#include "core/error.hpp"
#include "core/excerpt.hpp"

namespace {

using namespace brunt;
using Command = std::function<int(const comm::Communicator&)>;

/// One value each, so that a scene may follow.
void add_overrides(CLI::App& command, std::vector<std::string>& overrides) {
  command.add_option("--set", overrides, "Change a value of the scene, such as run.end=1.0e-5 (repeatable)")
      ->type_name("KEY.PATH=VALUE")
      ->allow_extra_args(false)
      ->expected(1)
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
}

/// `--out "$FOLDER"` with an unset variable.
std::string no_path(const std::string& text) {
  return text.empty() ? "invalid empty path; expected a file or folder" : std::string{};
}

void add_run(CLI::App& program, app::RunOptions& options, Command& chosen) {
  CLI::App* run = program.add_subcommand("run", "Run a scene");
  run->add_option("scene", options.scene, "Scene file (YAML)")->required();
  run->footer("Reference: results src/io/README.md, keys of a scene src/scene/README.md");
  run->add_option("--out", options.out, "Result folder (default SCENE.out)")->type_name("FOLDER")->check(no_path);
  add_overrides(*run, options.overrides);
  run->add_option("--restart", options.restart, "Continue from a checkpoint, or from the latest one of a result folder")
      ->type_name("PATH")
      ->check(no_path);
  run->add_option("--partition", options.partition, "Use the partition in a folder written by brunt partition --write")
      ->type_name("DIR")
      ->check(no_path);
  run->add_flag("--force", options.force, "Replace the results of an earlier run");
  run->add_flag("--quiet", options.quiet, "Print errors only; log.txt is written as usual");
  run->callback([&] { chosen = [&](const comm::Communicator& ranks) { return app::run(ranks, options); }; });
}

void add_check(CLI::App& program, app::CheckOptions& options, Command& chosen) {
  CLI::App* check = program.add_subcommand("check", "Read and validate a scene and list its contents, without a run");
  check->add_option("scene", options.scene, "Scene file (YAML)")->required();
  add_overrides(*check, options.overrides);
  check->add_flag("--all", options.all,
                  "List every node that overlaps initially (default: the ten deepest of each pair of parts)");
  check->callback([&] { chosen = [&](const comm::Communicator& ranks) { return app::check(ranks, options); }; });
}

/// CLI11 reads -np 2 as -n p, and its own message would not say what is expected.
std::string no_count_of_parts(const std::string& text) {
  constexpr int most = 1000000;
  int parts = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), parts);
  if (error == std::errc{} && end == text.data() + text.size() && parts >= 1 && parts <= most) return {};
  return fmt::format("invalid number of parts '{}'; expected an integer from 1 to {}, as in -n 4", excerpt(text), most);
}

void add_partition(CLI::App& program, app::PartitionOptions& options, Command& chosen) {
  CLI::App* partition =
      program.add_subcommand("partition", "Partition the mesh of a scene and report the quality of the partition");
  partition->add_option("scene", options.scene, "Scene file (YAML)")->required();
  partition->add_option("-n", options.parts, "Number of parts")->required()->check(no_count_of_parts);
  partition
      ->add_option("--from", options.from,
                   "Weight elements and contact by the times measured in a run: a checkpoint, or the latest one of a "
                   "result folder")
      ->type_name("CHECKPOINT")
      ->check(no_path);
  partition->add_option("--write", options.write, "Write the partition to this new folder, for brunt run --partition")
      ->type_name("DIR")
      ->check(no_path);
  add_overrides(*partition, options.overrides);
  partition->callback(
      [&] { chosen = [&](const comm::Communicator& ranks) { return app::partition(ranks, options); }; });
}

/// CLI11's own range check prints the largest double with all its digits.
std::string no_tolerance(const std::string& text) {
  double tolerance = -1;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), tolerance);
  if (error == std::errc{} && end == text.data() + text.size() && std::isfinite(tolerance) && tolerance >= 0) return {};
  return fmt::format("invalid --tol '{}': expected a number >= 0, as in --tol 1e-9", excerpt(text));
}

void add_compare(CLI::App& program, app::CompareOptions& options, Command& chosen) {
  CLI::App* compare = program.add_subcommand("compare", "Report the largest difference of two results, field by field");
  compare->add_option("a", options.a, "Result folder, state.h5, checkpoint or history.csv")->required();
  compare->add_option("b", options.b, "The same kind of result of another run")->required();
  compare->add_option("--tol", options.tolerance, "Largest admissible relative difference (default 0)")
      ->check(no_tolerance);
  compare->callback([&] { chosen = [&](const comm::Communicator& ranks) { return app::compare(ranks, options); }; });
}

void add_search(CLI::App& program, app::SearchOptions& options, Command& chosen) {
  CLI::App* search =
      program.add_subcommand("search", "Run the contact search alone, on a text scene of nodes and boxes or of facets");
  search
      ->add_option("file", options.file,
                   "Text scene: scene1 NAME n m, then nodes and boxes; or facets1 NAME n m d, then nodes and facets")
      ->required();
  search
      ->add_option("--method", options.method,
                   "blocks: the method of brunt run; bucket, binary: the methods of the paper; kdop: trees of 18-DOPs, "
                   "the only one for facets")
      ->check(CLI::IsMember({"blocks", "bucket", "binary", "kdop"}));
  search->add_option("--repeat", options.repeat, "Number of repetitions; the shortest time is reported")
      ->check(CLI::Range(1, 1000));
  search->add_flag("--list", options.list, "Print the pairs, one a line: `face node`, or `slave master` for facets");
  search->callback([&] { chosen = [&](const comm::Communicator& ranks) { return app::search(ranks, options); }; });
}

/// A number >= 0; CLI11's own range check prints the largest double with all its digits.
std::string no_number(const std::string& text) {
  double value = -1;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error == std::errc{} && end == text.data() + text.size() && std::isfinite(value) && value >= 0) return {};
  return fmt::format("invalid number '{}'; expected a finite number >= 0", excerpt(text));
}

/// (depth - bound) / depth.
std::string no_gap(const std::string& text) {
  if (no_number(text).empty() && std::stod(text) > 0 && std::stod(text) < 1) return {};
  return fmt::format("invalid gap '{}'; expected a number between 0 and 1, as in --certify 0.05", excerpt(text));
}

/// "10s": seconds, with or without the unit.
std::string no_time(std::string& text) {
  if (text.ends_with('s')) text.pop_back();
  return no_number(text).empty() ? std::string{}
                                 : fmt::format("invalid time '{}'; expected seconds, as in 10s", excerpt(text));
}

void add_depth(CLI::App& program, app::DepthOptions& options, Command& chosen) {
  CLI::App* depth = program.add_subcommand(
      "depth", "Penetration depth of two closed surfaces: the smallest rigid motion of A that separates it from B");
  depth->footer(
      "Surfaces: STL, OBJ, PLY. A is rotated about the origin of its file, then translated. Reference: "
      "src/depth/README.md");
  depth->add_option("a", options.a, "Surface of the moving body, or a scene (YAML): all its overlapping parts")
      ->required();
  depth->add_option("b", options.b, "Surface of the fixed body");
  depth->add_option("--at", options.at, "Translation of A (default 0,0,0)")->type_name("X,Y,Z");
  depth->add_option("--turn", options.turn, "Rotation of A, before the translation")->type_name("X,Y,Z,DEGREES");
  depth->add_option("--poses", options.poses, "Poses of A: x,y,z and axis_x,axis_y,axis_z,degrees or qw,qx,qy,qz")
      ->type_name("FILE.csv")
      ->check(no_path)
      ->excludes("--at")
      ->excludes("--turn");
  depth
      ->add_option("--metric", options.metrics,
                   "Norm of a motion: displacement (the largest of all points, default), object_norm (root mean "
                   "square), translation (without rotation); repeatable")
      ->check(CLI::IsMember({"displacement", "object_norm", "translation"}))
      ->allow_extra_args(false)
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
  depth->add_option("--along", options.along, "Axes along which translations are admissible, such as x,y")
      ->type_name("AXES");
  depth->add_option("--clearance", options.clearance, "Gap to leave between the surfaces [length]")->check(no_number);
  depth->add_flag("--careful", options.careful, "Use more starting points: a better result in more time");
  depth
      ->add_option("--certify", options.certify, "Search all motions until (depth - bound) / depth is at most this gap")
      ->type_name("GAP")
      ->check(no_gap);
  depth->add_option("--boxes", options.boxes, "End the certified search after this number of boxes (reproducible)")
      ->check(CLI::Range(std::int64_t{1}, std::int64_t{1} << 40));
  depth->add_option("--limit", options.limit, "End the certified search after this time in seconds (not reproducible)")
      ->type_name("TIME")
      ->transform(CLI::Validator(no_time, "TIME"));
  depth->add_option("--pieces", options.pieces, "Convex pieces inside A and B (YAML), for better bounds")
      ->type_name("FILE")
      ->check(no_path);
  depth->add_option("--merge", options.merge, "Merge points that are closer to each other than this [length]")
      ->check(no_number);
  depth->add_flag("--sequence", options.sequence,
                  "Start each pose also from the result of the previous one, in chains of 32 poses");
  depth
      ->add_option("--samples", options.samples,
                   "Sample this number of placements in contact first, and start each pose also from the nearest ones")
      ->type_name("N")
      ->needs("--poses")
      ->check(CLI::Range(std::int64_t{1}, std::int64_t{10'000'000}));
  depth->add_flag("--json", options.json, "Print JSON instead of text");
  depth
      ->add_option("--out", options.out,
                   "Folder for depth.csv, depth.json and the surfaces before and after the motion (PLY)")
      ->type_name("FOLDER")
      ->check(no_path);
  depth->add_flag("--force", options.force, "Replace the results of an earlier run");
  add_overrides(*depth, options.overrides);
  depth->callback(
      [&] { chosen = [&](const comm::Communicator& ranks) { return app::depth_command(ranks, options); }; });
}

void add_info(CLI::App& program, app::InfoOptions& options, Command& chosen) {
  CLI::App* info = program.add_subcommand("info", "Print version, libraries, limits, elements and materials");
  CLI::Option* keys = info->add_flag("--keys", options.keys,
                                     "Print every key of a scene instead: type and range, unit, default and meaning");
  info->add_flag("--json", options.json, "With --keys: print JSON, for programs")->needs(keys);
  info->callback([&] { chosen = [&](const comm::Communicator& ranks) { return app::info(ranks, options); }; });
}

/// CLI11 would only report that a command is missing.
bool names_unknown_command(const CLI::App& program, int argc, char** argv) {
  if (argc < 2 || argv[1][0] == '-') return false;
  const auto commands = program.get_subcommands([](const CLI::App*) { return true; });
  return std::ranges::none_of(commands, [&](const CLI::App* command) { return command->get_name() == argv[1]; });
}

/// CLI11 quotes arguments, or what follows their equals sign, without a bound.
std::string with_excerpts(std::string text, int argc, char** argv) {
  for (int k = 1; k < argc; ++k) {
    const std::string word = argv[k];
    for (const std::string& quoted : {word, word.substr(word.find('=') + 1)})
      if (const std::string brief = excerpt(quoted); brief != quoted)
        for (auto at = text.find(quoted); at != std::string::npos; at = text.find(quoted, at + brief.size()))
          text.replace(at, quoted.size(), brief);
  }
  return text;
}

/// CLI11 prints on every rank; the output of one is sufficient.
int parse_failure(const CLI::App& program, const CLI::ParseError& error, bool root, int argc, char** argv) {
  if (!root) return error.get_exit_code() == 0 ? 0 : 2;
  if (error.get_exit_code() == 0) return program.exit(error);
  const std::string what = with_excerpts(error.what(), argc, argv);
  if (dynamic_cast<const CLI::RequiredError*>(&error))
    fmt::print(stderr, "brunt: missing argument: {}; expected all required arguments, see brunt --help\n", what);
  else
    fmt::print(stderr, "brunt: invalid arguments: {}; expected known arguments and values, see brunt --help\n", what);
  return 2;
}

int run_command(const comm::Communicator& ranks, int argc, char** argv) {
  CLI::App program("Brunt: explicit and implicit finite elements for contact, crash and penetration");
  program.require_subcommand(1);
  program.set_version_flag("--version", app::version());
  Command chosen;
  app::RunOptions run;
  app::CheckOptions check;
  app::PartitionOptions partition;
  app::CompareOptions compare;
  app::SearchOptions search;
  app::DepthOptions depth;
  app::InfoOptions info;
  add_run(program, run, chosen);
  add_check(program, check, chosen);
  add_partition(program, partition, chosen);
  add_compare(program, compare, chosen);
  add_search(program, search, chosen);
  add_depth(program, depth, chosen);
  add_info(program, info, chosen);
  if (names_unknown_command(program, argc, argv)) {
    if (ranks.is_root()) fmt::print(stderr, "brunt: unknown command '{}'; see brunt --help\n", excerpt(argv[1]));
    return 2;
  }
  try {
    program.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return parse_failure(program, error, ranks.is_root(), argc, argv);
  }
  const int code = chosen(ranks);
  const bool shows_results = !program.got_subcommand("run");  // a run has them in its folder, this text in log.txt too
  if (shows_results && ranks.is_root() && (std::fflush(stdout) != 0 || std::ferror(stdout) != 0))
    throw MachineError("standard output: cannot write the results");
  return code;
}

}  // namespace

int main(int argc, char** argv) {
  try {
    const comm::Session session(argc, argv);
    const comm::Communicator ranks = comm::Communicator::world();
    return app::guarded(ranks, [&] { return run_command(ranks, argc, argv); });
  } catch (const std::exception& error) {  // MPI or PETSc itself did not start
    std::fputs("brunt: ", stderr);
    std::fputs(error.what(), stderr);
    std::fputs("\n", stderr);
    return 4;
  }
}
