// SPDX-License-Identifier: Apache-2.0
// Meshes with straight edges are smaller than round bodies: the difference, and sufficient numbers of elements.
#include "mesh/round_bodies.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "bodies.hpp"

namespace brunt::app {
namespace {

/// Share of the volume, and of the radius for the centre, above which a warning is given: the accuracy required of the
/// cases.
constexpr double worth_a_warning = 0.01;

struct Difference {
  double volume = 0, centre = 0;  ///< of the exact volume, of the outer radius
  [[nodiscard]] double largest() const { return std::max(std::abs(volume), centre); }
};

Difference difference(const mesh::Mesh& mesh, const mesh::Moments& exact, double radius) {
  const mesh::Moments found = mesh::moments(mesh);
  return {found.volume / exact.volume - 1, (found.centre - exact.centre).norm() / radius};
}

/// Both errors fall with the square of the element size, which gives a first estimate. The number of elements around is
/// rounded to a multiple of 8, so the numbers beside the estimate are tried (`difference_of`) while they are small.
template <class DifferenceOf>
int enough_elements(int elements, const Difference& found, DifferenceOf difference_of) {
  constexpr int most_tried = 20;
  int enough = static_cast<int>(std::ceil(elements * std::sqrt(found.largest() / worth_a_warning)));
  while (enough <= most_tried && difference_of(enough).largest() > worth_a_warning) ++enough;
  while (enough <= most_tried && enough - 1 > elements && difference_of(enough - 1).largest() <= worth_a_warning)
    --enough;
  return enough;
}

std::string help(const scene::SphereMesh& body, const Difference& found) {
  const auto with = [&](int elements, double finer) {
    return difference(mesh::sphere(body.part, body.radius, elements, {finer, body.half}),
                      mesh::exact_sphere(body.radius, body.half), body.radius);
  };
  std::string text = fmt::format("about {} elements across the radius would suffice",
                                 enough_elements(body.elements, found, [&](int n) { return with(n, body.finer); }));
  for (double finer = body.finer; finer > 1.2;) {
    finer = std::max(1.0, 0.8 * finer);
    if (with(body.elements, finer).largest() <= worth_a_warning) return text + fmt::format(", or finer: {:.2g}", finer);
  }
  return text;
}

std::string help(const scene::CylinderMesh& body, const Difference& found) {
  const auto with = [&](int elements) {
    return difference(mesh::cylinder(body.part, body.radius, body.length, {elements, 1}, body.half),
                      mesh::exact_tube(0, body.radius, body.length, body.half), body.radius);
  };
  return fmt::format("about {} elements across the radius would suffice",
                     enough_elements(body.elements[0], found, with));
}

std::string help(const scene::TubeMesh& body, const Difference& found) {
  const auto with = [&](int quarter) {  // a multiple of 4 around, as halves and quarters need
    return difference(
        mesh::tube(body.part, body.inner_radius, body.outer_radius, body.length, {1, 4 * quarter, 1}, body.half),
        mesh::exact_tube(body.inner_radius, body.outer_radius, body.length, body.half), body.outer_radius);
  };
  const int enough = 4 * enough_elements((body.elements[1] + 3) / 4, found, with);
  return fmt::format("about {} elements around would suffice", enough);
}

std::string help(const scene::TorusMesh& body, const Difference& found) {
  const int ring = body.elements[0], tube = body.elements[1];
  const auto around_ring = [&](int around_tube) { return (ring * around_tube + tube - 1) / tube; };
  const auto with = [&](int around_tube) {
    return difference(
        mesh::torus(body.part, body.radius, body.tube[0], body.tube[1], {around_ring(around_tube), around_tube, 1}),
        mesh::exact_torus(body.radius, body.tube[0], body.tube[1]), body.radius + body.tube[1]);
  };
  const int enough = enough_elements(tube, found, with);
  return fmt::format("about {} elements around the ring and {} around the tube would suffice", around_ring(enough),
                     enough);
}

template <class Body>
void compare(const scene::Input& input, const scene::MeshEntry& entry, const Body& body, double radius,
             const mesh::Mesh& mesh, const mesh::Moments& exact, RoundBodies& result) {
  const Difference found = difference(mesh, exact, radius);
  const std::string text = fmt::format("{:.2f} % of the exact volume, and a centre off by {:.2g} of the radius",
                                       100 * (1 + found.volume), found.centre < 1e-12 ? 0.0 : found.centre);
  result.lines.push_back(fmt::format("{}: {}", body.part, text));
  if (found.largest() <= worth_a_warning) return;
  result.warnings.push_back(
      fmt::format("{}: the mesh of {} has {}; {}", input.at(entry.key), body.part, text, help(body, found)));
}

}  // namespace

RoundBodies round_bodies(const scene::Input& input) {
  RoundBodies result;
  for (const scene::MeshEntry& entry : input.mesh) {
    if (const auto* body = std::get_if<scene::SphereMesh>(&entry.body); body != nullptr && !body->shell)
      compare(input, entry, *body, body->radius,
              mesh::sphere(body->part, body->radius, body->elements, {body->finer, body->half}),
              mesh::exact_sphere(body->radius, body->half), result);
    if (const auto* body = std::get_if<scene::CylinderMesh>(&entry.body))
      compare(input, entry, *body, body->radius,
              mesh::cylinder(body->part, body->radius, body->length, body->elements, body->half),
              mesh::exact_tube(0, body->radius, body->length, body->half), result);
    if (const auto* body = std::get_if<scene::TubeMesh>(&entry.body); body != nullptr && !body->shell)
      compare(input, entry, *body, body->outer_radius,
              mesh::tube(body->part, body->inner_radius, body->outer_radius, body->length, body->elements, body->half),
              mesh::exact_tube(body->inner_radius, body->outer_radius, body->length, body->half), result);
    if (const auto* body = std::get_if<scene::TorusMesh>(&entry.body))
      compare(input, entry, *body, body->radius + body->tube[1],
              mesh::torus(body->part, body->radius, body->tube[0], body->tube[1], body->elements),
              mesh::exact_torus(body->radius, body->tube[0], body->tube[1]), result);
  }
  return result;
}

}  // namespace brunt::app
