// SPDX-License-Identifier: Apache-2.0
// How deep bodies really are in each other, from positions alone: what contact reports is to be no more.
#pragma once
#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <set>
#include <utility>
#include <vector>

#include "brunt/mesh/mesh.hpp"
#include "brunt/mesh/topology.hpp"

namespace brunt::test {

using Triangle = std::array<Vec3, 3>;

/// The surface of one block. Distances are its own, not those of geometry/, by which contact finds what is checked.
class Skin {
 public:
  Skin(const mesh::Mesh& mesh, LocalIndex block) {
    for (const mesh::Side& side : mesh::exterior_sides(mesh)) {
      if (side.block != block) continue;
      const mesh::Block& own = mesh.blocks[static_cast<std::size_t>(block)];
      std::vector<LocalIndex> face;
      for (const LocalIndex node : mesh::face_nodes(own.shape, own.element(side.element), side.face))
        if (node != no_index) face.push_back(node);
      for (std::size_t i = 0; i < face.size(); ++i) {
        const LocalIndex a = face[i], b = face[(i + 1) % face.size()];
        nodes_.insert(a);
        edges_.insert({std::min(a, b), std::max(a, b)});
      }
      faces_.push_back(std::move(face));
    }
  }

  /// Every face as triangles about its middle.
  void move(const std::function<Vec3(LocalIndex)>& position) {
    triangles_.clear();
    for (const auto& face : faces_) {
      Vec3 middle = Vec3::Zero();
      for (const LocalIndex node : face) middle += position(node) / static_cast<double>(face.size());
      for (std::size_t i = 0; i < face.size(); ++i)
        triangles_.push_back({position(face[i]), position(face[(i + 1) % face.size()]), middle});
    }
    points_.clear();
    for (const LocalIndex node : nodes_) points_.push_back(position(node));
    constexpr int parts = 12;
    for (const auto& [a, b] : edges_)
      for (int k = 1; k < parts; ++k)
        points_.push_back(position(a) + (static_cast<double>(k) / parts) * (position(b) - position(a)));
  }

  /// Deepest of the other's nodes and points on its edges below this surface [length].
  [[nodiscard]] double depth_of(const Skin& other) const {
    double deepest = 0;
    for (const Vec3& point : other.points_) {
      if (const double below = distance(point); below > deepest && holds(point)) deepest = below;
    }
    return deepest;
  }

 private:
  /// By the solid angle of the surface as seen from the point (van Oosterom and Strackee 1983).
  [[nodiscard]] bool holds(const Vec3& point) const {
    double angle = 0;
    for (const Triangle& t : triangles_) {
      const Vec3 a = t[0] - point, b = t[1] - point, c = t[2] - point;
      const double la = a.norm(), lb = b.norm(), lc = c.norm();
      angle += 2 * std::atan2(a.dot(b.cross(c)), la * lb * lc + a.dot(b) * lc + b.dot(c) * la + a.dot(c) * lb);
    }
    return std::abs(angle) > 2 * std::numbers::pi;
  }

  [[nodiscard]] double distance(const Vec3& point) const {
    double nearest = std::numeric_limits<double>::infinity();
    for (const Triangle& t : triangles_) {
      const Vec3 normal = (t[1] - t[0]).cross(t[2] - t[0]);
      bool over = true;
      for (std::size_t i = 0; i < 3; ++i) {
        const Vec3 side = t[(i + 1) % 3] - t[i], from = point - t[i];
        over = over && normal.dot(side.cross(from)) >= 0;
        const double along = std::clamp(from.dot(side) / side.squaredNorm(), 0.0, 1.0);
        nearest = std::min(nearest, (from - along * side).norm());
      }
      if (over) nearest = std::min(nearest, std::abs(normal.dot(point - t[0])) / normal.norm());
    }
    return nearest;
  }

  std::vector<std::vector<LocalIndex>> faces_;
  std::set<LocalIndex> nodes_;
  std::set<std::pair<LocalIndex, LocalIndex>> edges_;
  std::vector<Triangle> triangles_;
  std::vector<Vec3> points_;
};

}  // namespace brunt::test
