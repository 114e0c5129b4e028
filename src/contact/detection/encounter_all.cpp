// SPDX-License-Identifier: Apache-2.0
// `encounter` for a pack of pairs at a time. Where bodies touch over whole faces, most of the time is spent here.
#include <algorithm>
#include <cstdint>
#include <cstring>

#include "contact/detection/encounter.hpp"
#include "geometry/closest_place.hpp"
#include "motion_quads.hpp"
#include "standing.hpp"

namespace brunt::contact {
namespace {

using geometry::PackVec;
using geometry::Region;

constexpr std::size_t lanes = pack_width;

/// A node and a face a lane; the last pair is repeated in unused lanes.
struct Batch {
  const NodeMotion* slave[lanes];
  const NodeMotion* corner[4][lanes];
  Pack side, dt;
};

/// motion(lane): pointer to the NodeMotion of a lane.
template <class MotionOfLane>
BRUNT_INLINE PackVec positions(const MotionOfLane& motion) {
  PackVec result;
  components_of([&](int lane) { return position_quad(*motion(lane)); }, result.x, result.y, result.z);
  return result;
}

template <class MotionOfLane>
BRUNT_INLINE PackVec predictions(const MotionOfLane& motion) {
  PackVec result;
  components_of([&](int lane) { return predicted_quad(*motion(lane)); }, result.x, result.y, result.z);
  return result;
}

/// The quantities of `encounter`, lane by lane.
struct Result {
  alignas(64) double over_middle[lanes], beside[lanes], moved[lanes], risen[lanes], edge[lanes], along[lanes];
  alignas(64) double normal[3][lanes], point[3][lanes], weights[4][lanes];
  alignas(64) std::int64_t known[lanes], on_face[lanes];
};

BRUNT_INLINE void keep(const Pack& from, double (&to)[lanes]) {
  std::memcpy(to, &from, sizeof from);
}

BRUNT_INLINE void keep(const PackVec& from, double (&to)[3][lanes]) {
  keep(from.x, to[0]);
  keep(from.y, to[1]);
  keep(from.z, to[2]);
}

void measure(const Batch& batch, Result& result) {
  const auto slave = [&](int lane) { return batch.slave[lane]; };
  const PackVec x = positions(slave);
  geometry::PackQuad quad;
  for (int i = 0; i < 4; ++i) quad.corner[i] = positions([&](int lane) { return batch.corner[i][lane]; });
  const geometry::PackPlace place = geometry::closest_place(x, quad);

  const geometry::PackWeights weights = geometry::quad_weights(place.xi, place.eta);
  const PackVec point = geometry::combine(quad, weights);
  const geometry::PackTangents t = geometry::tangents(quad, place.xi, place.eta);
  const PackVec across = geometry::cross(t.xi, t.eta);
  const Pack length2 = geometry::dot(across, across), scale = geometry::dot(t.xi, t.xi) + geometry::dot(t.eta, t.eta);
  const PackMask regular = length2 > 1e-24 * scale * scale;  // else the face has no normal here
  const PackVec normal = (batch.side / pack_sqrt(length2)) * across;

  PackVec relative = predictions(slave);
  for (int i = 0; i < 4; ++i)
    relative = relative - weights.of[i] * predictions([&](int lane) { return batch.corner[i][lane]; });

  const Standing<Pack> at = stand(x, point, normal, relative, batch.dt);
  keep(at.over_middle, result.over_middle);
  keep(at.beside, result.beside);
  keep(at.moved, result.moved);
  keep(at.risen, result.risen);
  keep(place.edge, result.edge);
  keep(place.along, result.along);
  keep(normal, result.normal);
  keep(point, result.point);
  for (int i = 0; i < 4; ++i) keep(weights.of[i], result.weights[i]);
  const PackMask known = place.known & regular;
  std::memcpy(result.known, &known, sizeof known);
  std::memcpy(result.on_face, &place.on_face, sizeof place.on_face);
}

Region region_at(const Result& from, std::size_t lane) {
  if (from.on_face[lane] != 0) return Region::face;
  const int edge = static_cast<int>(from.edge[lane]);
  if (from.along[lane] <= 0) return static_cast<Region>(static_cast<int>(Region::vertex0) + edge);
  if (from.along[lane] >= 1) return static_cast<Region>(static_cast<int>(Region::vertex0) + (edge + 1) % 4);
  return static_cast<Region>(static_cast<int>(Region::edge0) + edge);
}

void take(const Result& from, std::size_t lane, const MasterFace& face, const Tolerances& tolerances, Encounter& met) {
  met.region = region_at(from, lane);
  for (int c = 0; c < 3; ++c) {
    met.normal[c] = from.normal[c][lane];
    met.point[c] = from.point[c][lane];
  }
  for (std::size_t i = 0; i < 4; ++i) met.weights[i] = from.weights[i][lane];
  classify({from.over_middle[lane], from.beside[lane], from.moved[lane], from.risen[lane]}, tolerances,
           face.element_depth, met);
}

}  // namespace

void encounter_all(const FacesInMotion& scene, std::span<const NodeMotion* const> slave, std::span<Encounter> met) {
  Batch batch{};
  batch.dt = broadcast(scene.dt);
  Result result;
  for (std::size_t first = 0; first < met.size(); first += lanes) {
    const std::size_t count = std::min(lanes, met.size() - first);
    for (std::size_t lane = 0; lane < lanes; ++lane) {
      const std::size_t k = first + std::min(lane, count - 1);
      const MasterFace& face = scene.face(met[k]);
      batch.slave[lane] = slave[k];
      batch.side[lane] = met[k].approach.side;
      for (std::size_t i = 0; i < 4; ++i)  // of a triangle the last one is arbitrary: its lane is not used
        batch.corner[i][lane] = &scene.corner(face, i);
    }
    measure(batch, result);
    for (std::size_t lane = 0; lane < count; ++lane) {
      Encounter& e = met[first + lane];
      const MasterFace& face = scene.face(e);
      if (face.corner_count != 4 || result.known[lane] == 0) {
        e = encounter(scene, *slave[first + lane], e.face, e.approach);
        continue;
      }
      e.size = nth(scene.reach, e.face).size;
      take(result, lane, face, scene.tolerances, e);
    }
  }
}

}  // namespace brunt::contact
