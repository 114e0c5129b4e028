// SPDX-License-Identifier: Apache-2.0
#include "whole_scene.hpp"

#include <filesystem>

#include "app/program/failure.hpp"
#include "bodies.hpp"
#include "io/text_file.hpp"
#include "scene/build/select.hpp"
#include "scene/read/read.hpp"
#include "scene/text/fingerprint.hpp"
#include "scene/text/write.hpp"

namespace brunt::app {

scene::Input read_input(const comm::Communicator& ranks, const std::string& scene_file,
                        const std::vector<std::string>& overrides, std::string* fingerprint, std::string* values,
                        std::string* yaml) {
  std::string text;
  on_root(ranks, [&] {
    if (std::filesystem::is_directory(scene_file))
      throw InputError(scene_file + ": invalid scene: it is a folder; expected the scene file in it");
    text = io::plain_text(io::read_text(scene_file), scene_file);
  });
  ranks.broadcast(text);
  if (fingerprint) *fingerprint = scene::fingerprint(text, scene_file, overrides);
  if (values) *values = scene::decisive_values(text, scene_file, overrides);
  if (yaml) *yaml = scene::as_yaml(text, scene_file, overrides);
  return scene::read_scene(text, scene_file, overrides);
}

mesh::CanonicalMesh whole_mesh(const scene::Input& input, std::vector<std::string>& warnings, StartUp* start_up) {
  mesh::Mesh bodies = assemble(input, warnings);
  if (start_up) start_up->end(StartStage::reading);
  mesh::CanonicalMesh whole = mesh::canonical_order(std::move(bodies));
  scene::select(input, whole);
  if (start_up) start_up->end(StartStage::ordering);
  return whole;
}

}  // namespace brunt::app
