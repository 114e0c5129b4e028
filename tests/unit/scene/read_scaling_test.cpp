// SPDX-License-Identifier: Apache-2.0
// The section `scaling`: what it may name, and what is said where it names something else.
#include <fmt/format.h>

#include <catch2/catch.hpp>

#include "core/error.hpp"
#include "scene/read/read.hpp"
#include "scene/text/fingerprint.hpp"
#include "unit/scene/good_scene.hpp"

using namespace brunt;
using namespace brunt::scene;

namespace {

std::string with(const std::string& scaling) {
  return fmt::format("{}\nscaling: {}\n", small_scene, scaling);
}

std::vector<std::string> faults_of(const std::string& scaling) {
  try {
    read_scene(with(scaling), "bar.yaml", {});
  } catch (const InputError& error) {
    return error.faults();
  }
  return {};
}

void check_message(const std::string& scaling, const std::string& key, const std::string& phrase) {
  const std::vector<std::string> faults = faults_of(scaling);
  INFO(scaling << "\n" << InputError(faults).what());
  REQUIRE(faults.size() == 1);
  CHECK_THAT(faults[0], Catch::StartsWith("bar.yaml:"));
  CHECK_THAT(faults[0], Catch::Contains(": " + key + ": "));
  CHECK_THAT(faults[0], Catch::Contains(phrase));
  CHECK_THAT(faults[0], Catch::Contains("expected"));
}

}  // namespace

TEST_CASE("scaling: counts and lengths of one to three directions, one by one or all entries of a list", "[scene]") {
  CHECK(faults_of("{weak: [{counts: [mesh.0.box.elements.0], lengths: [mesh.0.box.size.0]}]}").empty());
  CHECK(faults_of("{weak: [{counts: [mesh.*.box.elements.2], lengths: [mesh.*.box.at.0, mesh.1.box.at.2]}]}").empty());
  CHECK(faults_of("{weak: [{counts: [mesh.0.box.elements.0]}, {counts: [mesh.0.box.elements.1]}]}").empty());
}

TEST_CASE("scaling: a wrong entry is one line that names it", "[scene]") {
  check_message("{weak: [{counts: [mesh.0.box.elements.0, mesh.5.box.elements.0]}]}", "scaling.weak.0.counts.1",
                "unknown path 'mesh.5.box.elements.0'");
  check_message("{weak: [{counts: [mesh.0.box.part]}]}", "scaling.weak.0.counts.0",
                "invalid path 'mesh.0.box.part': not a number of elements");
  check_message("{weak: [{counts: [mesh.1.box.at.1]}]}", "scaling.weak.0.counts.0",
                "invalid path 'mesh.1.box.at.1': not a number of elements");
  check_message("{weak: [{counts: [mesh.0.box.size.0]}]}", "scaling.weak.0.counts.0",
                "invalid path 'mesh.0.box.size.0': not a number of elements");
  check_message("{weak: [{counts: []}]}", "scaling.weak.0.counts", "missing entries; expected a list of paths");
  check_message("{weak: [{counts: [mesh.0.box.elements]}]}", "scaling.weak.0.counts.0", "leads to no value");
  check_message("{weak: [{counts: [mesh.*.box.elements.0], lengths: [mesh.0.box.part]}]}", "scaling.weak.0.lengths.0",
                "paths of numbers");
  check_message("{weak: [{count: [mesh.0.box.elements.0]}]}", "scaling.weak.0.count", "did you mean 'counts'");
  check_message("{weak: [{lengths: [mesh.0.box.size.0]}]}", "scaling.weak.0.counts",
                "missing; expected a list of paths");
  check_message("{weak: []}", "scaling.weak", "0 directions");
  check_message("{weak: 2}", "scaling.weak", "one to three directions");
  check_message("{weka: []}", "scaling.weka", "did you mean 'weak'");
}

TEST_CASE("scaling says nothing of the bodies: a checkpoint fits the scene with and without it", "[scene]") {
  const std::string text(small_scene);
  CHECK(fingerprint(text, "bar.yaml", {}) ==
        fingerprint(with("{weak: [{counts: [mesh.0.box.elements.0]}]}"), "bar.yaml", {}));
}
