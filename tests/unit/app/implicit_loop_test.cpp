// SPDX-License-Identifier: Apache-2.0
// Names of schemes, steps with contact, energy that walls at rest have given.
#include "app/run/implicit_loop.hpp"

#include <catch2/catch.hpp>

#include "app/report/implicit_report.hpp"
#include "scene/read/read.hpp"
#include "unit/app/prepared_scene.hpp"

using namespace brunt;

namespace {

std::string at_wall(const std::string& scheme, const std::string& wall) {
  return "units: none\nmesh: {box: {part: a, size: [1, 1, 1], elements: [1, 1, 1]}}\n"
         "materials: {m: {model: neo_hookean, density: 1, young: 100, poisson: 0.3}}\n"
         "parts: {a: {material: m, element: hex8_full}}\ncurves: {still: [[0, 0]]}\n"
         "initial: [{part: a, velocity: [0, 0, -1]}]\n"
         "rigid_walls: [{point: [0, 0, -0.15], normal: [0, 0, 1]" +
         wall + "}]\nsolver: {scheme: " + scheme + ", step: 0.1}\nrun: {end: 1}\n";
}

}  // namespace

TEST_CASE("schemes have the names of a scene") {
  for (const char* name : {"static", "contact_implicit", "hht", "newmark"}) {
    const auto read = scene::read_scene(at_wall(name, ""), "scene.yaml");
    CHECK(std::string(app::name_of(read.implicit->scheme)) == name);
  }
}

TEST_CASE("steps with contact are counted") {
  support::PreparedScene prepared(at_wall("contact_implicit", ""));
  app::Prepared& run = *prepared.run;
  app::implicit_step(run);  // down to -.1: nothing touches
  CHECK(run.implicit->work.contact_steps == 0);
  app::implicit_step(run);
  CHECK(run.implicit->work.contact_steps == 1);
}

TEST_CASE("walls at rest make energy where they have given a hundredth, moving ones never") {
  time::Ledger ledger{};
  const auto told = [&](const std::string& text, double given) {
    ledger.walls = -given;
    const support::PreparedScene prepared(text);
    return app::walls_make_energy(*prepared.run, ledger, 1.0);
  };
  CHECK(told(at_wall("newmark", ""), 0.02));
  CHECK_FALSE(told(at_wall("newmark", ""), 0.005));
  CHECK_FALSE(told(at_wall("newmark", ", motion: still"), 0.02));
}
