// SPDX-License-Identifier: Apache-2.0
// The scene as typed input, and its whole mesh on the root.
#pragma once
#include <string>
#include <vector>

#include "app/program/start_up.hpp"
#include "comm/communicator.hpp"
#include "mesh/canonical.hpp"
#include "scene/input.hpp"

namespace brunt::app {

/// The typed scene, the same on every rank; `values`: what its fingerprint is made of; `yaml`: the whole scene after
/// its overrides. Collective; throws InputError on all ranks.
scene::Input read_input(const comm::Communicator& ranks, const std::string& scene_file,
                        const std::vector<std::string>& overrides, std::string* fingerprint = nullptr,
                        std::string* values = nullptr, std::string* yaml = nullptr);

/// The whole mesh of a scene, checked and in canonical order, with the scene's selections as sets. Root only.
mesh::CanonicalMesh whole_mesh(const scene::Input& input, std::vector<std::string>& warnings,
                               StartUp* start_up = nullptr);

}  // namespace brunt::app
