// SPDX-License-Identifier: Apache-2.0
#include "support/true_depth.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <set>

#include "mesh/topology.hpp"

namespace brunt::test {
namespace {

constexpr double signs[8][3] = {{-1, -1, -1}, {1, -1, -1}, {1, 1, -1}, {-1, 1, -1},
                                {-1, -1, 1},  {1, -1, 1},  {1, 1, 1},  {-1, 1, 1}};

// A point on the border between two elements is in one of them, whatever rounding says [share of the element].
constexpr double border = 1e-9;

/// Newton on the trilinear map from the middle; elements that contact leaves in one piece are far from folded.
bool in_hexahedron(const std::array<Vec3, 8>& corners, const Vec3& point) {
  Vec3 xi = Vec3::Zero();
  for (int iteration = 0; iteration < 30; ++iteration) {
    Vec3 residual = -point;
    Mat3 slope = Mat3::Zero();
    for (std::size_t a = 0; a < 8; ++a) {
      const double x = 1 + signs[a][0] * xi[0], y = 1 + signs[a][1] * xi[1], z = 1 + signs[a][2] * xi[2];
      residual += x * y * z / 8 * corners[a];
      slope.col(0) += signs[a][0] * y * z / 8 * corners[a];
      slope.col(1) += signs[a][1] * x * z / 8 * corners[a];
      slope.col(2) += signs[a][2] * x * y / 8 * corners[a];
    }
    const Vec3 change = slope.inverse() * residual;
    xi -= change;
    if (!xi.allFinite() || xi.cwiseAbs().maxCoeff() > 10) return false;
    if (change.cwiseAbs().maxCoeff() < 1e-13) break;
  }
  return xi.cwiseAbs().maxCoeff() <= 1 + border;
}

bool in_tetrahedron(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d, const Vec3& point) {
  Mat3 edges;
  edges << b - a, c - a, d - a;
  const Vec3 weights = edges.inverse() * (point - a);
  return weights.minCoeff() >= -border && weights.sum() <= 1 + border;
}

struct Nearest {
  double distance = std::numeric_limits<double>::infinity();
  double in_face = 0;
  Vec3 point = Vec3::Zero();
};

/// The nearest point of a triangle or of a bilinear quadrilateral, by a lattice of its parameters that closes in on the
/// nearest of its points: no case is told apart.
Nearest nearest_on(const std::vector<Vec3>& face, const Vec3& point) {
  const bool quad = face.size() == 4;
  const auto at = [&](double r, double s) -> Vec3 {
    if (!quad) return face[0] + r * (face[1] - face[0]) + s * (1 - r) * (face[2] - face[0]);
    return (1 - r) * (1 - s) * face[0] + r * (1 - s) * face[1] + r * s * face[2] + (1 - r) * s * face[3];
  };
  Nearest best;
  double r = 0.5, s = 0.5;
  for (double window = 0.5; window > 1e-9; window *= 0.6) {
    const double middle_r = r, middle_s = s;
    for (int i = -2; i <= 2; ++i)
      for (int j = -2; j <= 2; ++j) {
        const double to_r = std::clamp(middle_r + i * window / 2, 0.0, 1.0);
        const double to_s = std::clamp(middle_s + j * window / 2, 0.0, 1.0);
        const Vec3 x = at(to_r, to_s);
        if (const double distance = (x - point).norm(); distance < best.distance) {
          best = {distance, 0, x};
          r = to_r, s = to_s;
        }
      }
  }
  best.in_face = quad ? 2 * std::min({r, 1 - r, s, 1 - s}) : std::min({r, s * (1 - r), (1 - s) * (1 - r)});
  return best;
}

template <class Points>
Depth deepest(const Points& each_point, const Solid& other) {
  Depth found;
  each_point([&](const Vec3& point) {
    if (const Depth here = other.depth(point); here.depth > found.depth) found = here;
  });
  return found;
}

}  // namespace

Solid::Solid(const mesh::Mesh& mesh, LocalIndex block) : position_(mesh.coordinates) {
  const mesh::Block& own = mesh.blocks[static_cast<std::size_t>(block)];
  for (LocalIndex e = 0; e < own.count(); ++e)
    elements_.push_back({{own.element(e), own.element(e) + mesh::nodes_per_element(own.shape)}});
  std::set<LocalIndex> nodes;
  std::set<std::pair<LocalIndex, LocalIndex>> edges;
  for (const mesh::Side& side : mesh::exterior_sides(mesh)) {
    if (side.block != block) continue;
    std::vector<LocalIndex> face;
    for (const LocalIndex node : mesh::face_nodes(own.shape, own.element(side.element), side.face))
      if (node != no_index) face.push_back(node);
    for (std::size_t i = 0; i < face.size(); ++i) edges.insert(std::minmax(face[i], face[(i + 1) % face.size()]));
    nodes.insert(face.begin(), face.end());
    faces_.push_back({std::move(face)});
  }
  nodes_.assign(nodes.begin(), nodes.end());
  edges_.assign(edges.begin(), edges.end());
  move([&](LocalIndex node) { return mesh.coordinates[static_cast<std::size_t>(node)]; });
}

Solid::Box Solid::box_of(const std::vector<LocalIndex>& nodes) const {
  Box box{position(nodes[0]), position(nodes[0])};
  for (const LocalIndex node : nodes) {
    box.low = box.low.cwiseMin(position(node));
    box.high = box.high.cwiseMax(position(node));
  }
  return box;
}

void Solid::move(const std::function<Vec3(LocalIndex)>& position) {
  for (const Cell& element : elements_)
    for (const LocalIndex node : element.nodes) position_[static_cast<std::size_t>(node)] = position(node);
  for (Cell& element : elements_) element.box = box_of(element.nodes);
  for (Cell& face : faces_) face.box = box_of(face.nodes);
  whole_ = box_of(nodes_);
}

bool Solid::holds(const Cell& element, const Vec3& point) const {
  if (!element.box.holds(point)) return false;
  const auto& n = element.nodes;
  if (n.size() == 4) return in_tetrahedron(position(n[0]), position(n[1]), position(n[2]), position(n[3]), point);
  std::array<Vec3, 8> corners;
  for (std::size_t a = 0; a < 8; ++a) corners[a] = position(n[a]);
  return in_hexahedron(corners, point);
}

Depth Solid::depth(const Vec3& point) const {
  if (!whole_.holds(point)) return {};
  if (std::ranges::none_of(elements_, [&](const Cell& element) { return holds(element, point); })) return {};
  Depth found;
  found.depth = std::numeric_limits<double>::infinity();
  std::vector<Vec3> corners;
  for (std::size_t f = 0; f < faces_.size(); ++f) {
    if (faces_[f].box.distance(point) >= found.depth) continue;
    corners.clear();
    for (const LocalIndex node : faces_[f].nodes) corners.push_back(position(node));
    const Nearest nearest = nearest_on(corners, point);
    if (nearest.distance >= found.depth) continue;
    double edges = 0;
    for (std::size_t i = 0; i < corners.size(); ++i) edges += (corners[(i + 1) % corners.size()] - corners[i]).norm();
    found = {nearest.distance, edges / static_cast<double>(corners.size()), nearest.in_face, f, nearest.point};
  }
  return found;
}

Depth deepest_node(const Solid& one, const Solid& other) {
  return deepest(
      [&](const auto& take) {
        for (const LocalIndex node : one.nodes()) take(one.position(node));
      },
      other);
}

Depth deepest_on_edges(const Solid& one, const Solid& other) {
  constexpr int parts = 12;
  return deepest(
      [&](const auto& take) {
        for (const auto& [a, b] : one.edges())
          for (int k = 1; k < parts; ++k)
            take(one.position(a) + static_cast<double>(k) / parts * (one.position(b) - one.position(a)));
      },
      other);
}

}  // namespace brunt::test
