// SPDX-License-Identifier: Apache-2.0
// Common functions of the generated bodies: checks of their parameters, extrusion of a section, sets on their surfaces.
#pragma once
#include <array>
#include <functional>
#include <string>
#include <vector>

#include "mesh/mesh.hpp"
#include "mesh/round_form.hpp"
#include "section.hpp"

namespace brunt::mesh {

struct Hexahedra {
  std::vector<Vec3> coordinates;
  std::vector<LocalIndex> nodes;  ///< eight an element
};

/// Collects the faults of the parameters of one body; `finish` throws them together.
class ParameterCheck {
 public:
  explicit ParameterCheck(std::string body) : body_(std::move(body)) {}
  void positive(const char* name, double value);
  void divided(const char* name, const Division& division, int least);
  void at_least(const char* name, int value, int least);
  void holds(bool condition, const std::string& fault);
  void fits(double nodes);
  void finish() const;

 private:
  std::string body_;
  std::vector<std::string> faults_;
};

/// One block, ids from 1.
Mesh hex_body(const std::string& part, Hexahedra cells);

/// Layers of the section between these heights, ascending; the section's order within each.
Hexahedra extrude(const Section& section, const std::vector<double>& heights);

/// Adds the nodes for which `on_surface(node)` holds as a node set, and the exterior sides that have only such nodes as
/// a side set of the same name.
struct SurfaceSet {
  std::string name;
  std::function<bool(LocalIndex node)> on_surface;
};
/// The sets of the planes that halves are cut at, of a mesh as generated (its coordinates in the planes are 0).
void add_cut_planes(const Mesh& mesh, const std::string& part, const Half& half, std::vector<SurfaceSet>& sets);
void add_surface_sets(Mesh& mesh, const std::vector<SurfaceSet>& sets);

}  // namespace brunt::mesh
