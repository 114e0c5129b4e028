// SPDX-License-Identifier: Apache-2.0
// For tests/input/abaqus_mutants.py: reads the mesh files that are named on standard input, one a line, and prints each
// mesh, or why it is refused, as a line of JSON. With --keywords it prints the table of keywords instead.
#include <exception>
#include <iostream>
#include <nlohmann/json.hpp>
#include <string>

#include "core/error.hpp"
#include "io/mesh/abaqus_keywords.hpp"
#include "io/mesh/mesh_file.hpp"
#include "mesh/topology.hpp"

using namespace brunt;
using nlohmann::json;

namespace {

json blocks_of(const mesh::Mesh& mesh) {
  json blocks = json::array();
  for (const mesh::Block& block : mesh.blocks) {
    json elements = json::array();
    const int corners = mesh::nodes_per_element(block.shape);
    for (LocalIndex e = 0; e < block.count(); ++e)
      elements.push_back(std::vector<LocalIndex>(block.element(e), block.element(e) + corners));
    blocks.push_back({{"name", block.name}, {"elements", std::move(elements)}, {"ids", block.element_id}});
  }
  return blocks;
}

/// Of each side set the nodes of its faces.
json sides_of(const mesh::Mesh& mesh) {
  json sets = json::object();
  for (const auto& [name, sides] : mesh.side_sets) {
    json faces = json::array();
    for (const mesh::Side& side : sides) {
      const mesh::Block& block = mesh.blocks[static_cast<std::size_t>(side.block)];
      json face = json::array();
      for (const LocalIndex node : mesh::face_nodes(block.shape, block.element(side.element), side.face))
        if (node != no_index) face.push_back(node);
      faces.push_back(std::move(face));
    }
    sets[name] = std::move(faces);
  }
  return sets;
}

json shown(const mesh::Mesh& mesh) {
  json nodes = json::array(), left_out = json::array();
  for (const Vec3& x : mesh.coordinates) nodes.push_back({x[0], x[1], x[2]});
  for (const mesh::LeftOut& block : mesh.left_out) left_out.push_back({block.name, block.type, block.count});
  return {{"nodes", std::move(nodes)},   {"node_ids", mesh.node_id},    {"blocks", blocks_of(mesh)},
          {"node_sets", mesh.node_sets}, {"side_sets", sides_of(mesh)}, {"left_out", std::move(left_out)},
          {"notes", mesh.notes}};
}

json keywords() {
  const auto name_of = [](io::DeckEffect effect) {
    if (effect == io::DeckEffect::read) return "read";
    return effect == io::DeckEffect::none ? "none" : "refused";
  };
  json all = json::object();
  for (const io::DeckKeyword& one : io::deck_keywords()) {
    json parameters = json::object();
    for (const io::DeckParameter& parameter : one.parameters)
      parameters[std::string(parameter.name)] = name_of(parameter.effect);
    all[std::string(one.name)] = {{"effect", name_of(one.effect)}, {"parameters", std::move(parameters)}};
  }
  return all;
}

}  // namespace

int main(int count, char** words) {
  if (count > 1 && std::string(words[1]) == "--keywords") {
    std::cout << keywords() << "\n";
    return 0;
  }
  for (std::string path; std::getline(std::cin, path);) {
    json answer;
    try {
      answer = shown(io::read_mesh(path));
    } catch (const InputError& error) {
      answer = {{"refused", error.what()}};
    } catch (const std::exception& error) {
      answer = {{"failed", error.what()}};
    }
    std::cout << answer.dump(-1, ' ', false, json::error_handler_t::replace) << std::endl;
  }
}
