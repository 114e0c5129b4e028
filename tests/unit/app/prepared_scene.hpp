// SPDX-License-Identifier: Apache-2.0
// A scene written to a folder of its own and made ready to run, for tests of the program's parts.
#pragma once
#include <filesystem>
#include <fstream>
#include <memory>
#include <string>
#include <vector>

#include "app/start/prepare.hpp"
#include "time/step.hpp"

namespace brunt::support {

/// The folder goes when this goes.
struct SceneFolder {
  std::filesystem::path path;

  SceneFolder() {
    std::string name = (std::filesystem::temp_directory_path() / "brunt_test_XXXXXX").string();
    if (!mkdtemp(name.data())) throw std::runtime_error("no folder for the test");
    path = name;
  }
  ~SceneFolder() { std::filesystem::remove_all(path); }
  SceneFolder(const SceneFolder&) = delete;
  SceneFolder& operator=(const SceneFolder&) = delete;

  [[nodiscard]] std::string file(const std::string& name) const { return (path / name).string(); }
  [[nodiscard]] std::string write(const std::string& name, const std::string& text) const {
    std::ofstream(file(name)) << text;
    return file(name);
  }
};

/// A block `low` of 2 x 2 x 1 unit elements at rest and a cube `top` of one element that touches it at z = 1 and falls
/// at 2 and moves along x at 1; density 3, so that the masses are 12 and 3.
const std::string two_bodies =
    "units: none\n"
    "mesh:\n"
    "  - {box: {part: low, size: [2, 2, 1], elements: [2, 2, 1]}}\n"
    "  - {box: {part: top, size: [1, 1, 1], elements: [1, 1, 1], at: [0.5, 0.5, 1]}}\n"
    "materials: {m: {model: elastic, density: 3, young: 100, poisson: 0}}\n"
    "parts: {low: {material: m}, top: {material: m}}\n"
    "initial: [{part: top, velocity: [1, 0, -2]}]\n"
    "run: {end: 1}\n";

struct PreparedScene {
  SceneFolder folder;
  std::unique_ptr<app::Prepared> run;
  time::StepReport report{};

  explicit PreparedScene(const std::string& text)
      : run(app::prepare(comm::Communicator::self(), folder.write("scene.yaml", text), {})) {}
  /// With a file beside the scene, which it names.
  PreparedScene(const std::string& text, const std::string& name, const std::string& content) {
    (void)folder.write(name, content);
    run = app::prepare(comm::Communicator::self(), folder.write("scene.yaml", text), {});
  }

  void evaluate() {
    report = time::evaluate(run->model, run->state, run->scratch, run->links, time::StepControl{0.9, 1.02});
  }
  void advance() { time::advance(run->model, run->state, run->scratch, run->links, run->contact.get(), report); }
};

}  // namespace brunt::support
