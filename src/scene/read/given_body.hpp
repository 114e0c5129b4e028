// SPDX-License-Identifier: Apache-2.0
// A generated body as a scene gives it, of any kind: what the readers of its keys and the judges of its form share.
#pragma once
#include <array>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "mesh/division.hpp"
#include "mesh/round_form.hpp"
#include "scene/input.hpp"
#include "scene/keys/table.hpp"

namespace brunt::scene {

constexpr Count at_least_one{1};

/// The map `nose`. Lengths in the unit of the scene.
struct GivenNose {
  std::optional<mesh::Nose::Shape> shape;  ///< none: blunt
  std::optional<double> half_angle;        ///< [degrees]
  std::optional<double> length, crh, chamfer, tip_radius;
  std::optional<int> elements;
};

/// Lengths that are 0, or without a value, are missing or wrong, and that has been reported.
struct GivenBody {
  GivenBody() = default;
  explicit GivenBody(std::string_view kind_of_body);

  std::string kind{};  ///< the key of its map: box, cylinder, ...
  std::string part{};
  std::array<double, 3> size{1, 1, 1};  ///< of a box
  std::array<double, 2> plate_size{1, 1};
  double thickness = 0, radius = 0, length = 0, outer_radius = 0;
  std::optional<double> inner_radius{};
  std::array<double, 2> tube{};          ///< of a torus: inner and outer radius of its tube
  mesh::Divisions<3> elements{1, 1, 1};  ///< of a cylinder the first two, of a sphere the first
  double finer = 1;
  mesh::Half half{};
  mesh::Sector sector{};
  std::optional<GivenNose> nose{};
  bool shell = false;
  mesh::BoxSides open{};
  Placement placement{};

  decltype(MeshEntry::body) body{};  ///< the result
};

/// A direction of a body that is divided into elements. Sizes are not used if `high` is not above `low`.
struct Extent {
  double low = 0, high = 0;
  std::string_view what;   ///< the name of the direction, for messages
  bool even_only = false;  ///< no bias and no sizes
};
std::vector<Extent> extents_of(const GivenBody& body);

/// Reads `elements` of all bodies but the sphere; after a fault the division remains uniform.
void read_elements(const Key& key, GivenBody& body);
/// Reads `bias`, after the elements.
void read_bias(const Key& key, GivenBody& body);

/// A mesh has 32-bit indices, so its numbers of nodes and corners are limited.
void judge_countable(const Key& map, double nodes, double elements);

extern const Table<GivenNose> nose_keys;
/// The nose of a body of outer radius `radius` and inner radius `inner`, with `through` elements across its wall. None
/// where the radii are missing.
mesh::Nose nose_of(const Key& map_of_body, const GivenBody& body, double radius, double inner, int through);

extern const Table<GivenBody> body_keys;

}  // namespace brunt::scene
