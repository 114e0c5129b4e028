// SPDX-License-Identifier: Apache-2.0
#include <embree3/rtcore.h>

#include "search_peers.hpp"

namespace brunt::bench {
namespace {

struct Query {
  const SearchScene& scene;
  std::vector<BoxNode>& pairs;
  LocalIndex node;
};

void bounds_of_box(const RTCBoundsFunctionArguments* arguments) {
  const auto& scene = *static_cast<const SearchScene*>(arguments->geometryUserPtr);
  const geometry::Box& box = scene.boxes[arguments->primID];
  RTCBounds& bounds = *arguments->bounds_o;
  bounds.lower_x = static_cast<float>(box.low[0]);
  bounds.lower_y = static_cast<float>(box.low[1]);
  bounds.lower_z = static_cast<float>(box.low[2]);
  bounds.upper_x = static_cast<float>(box.high[0]);
  bounds.upper_y = static_cast<float>(box.high[1]);
  bounds.upper_z = static_cast<float>(box.high[2]);
}

bool take_box(RTCPointQueryFunctionArguments* arguments) {
  auto& query = *static_cast<Query*>(arguments->userPtr);
  if (geometry::contains(query.scene.boxes[arguments->primID], query.scene.nodes[static_cast<std::size_t>(query.node)]))
    query.pairs.push_back({static_cast<LocalIndex>(arguments->primID), query.node});
  return false;  // the radius stays as it is
}

}  // namespace

void search_embree(const SearchScene& scene, std::vector<BoxNode>& pairs) {
  RTCDevice device = rtcNewDevice("threads=1");
  RTCScene tree = rtcNewScene(device);
  RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_USER);
  rtcSetGeometryUserPrimitiveCount(geometry, static_cast<unsigned>(scene.boxes.size()));
  rtcSetGeometryUserData(geometry, const_cast<SearchScene*>(&scene));
  rtcSetGeometryBoundsFunction(geometry, &bounds_of_box, nullptr);
  rtcCommitGeometry(geometry);
  rtcAttachGeometry(tree, geometry);
  rtcReleaseGeometry(geometry);
  rtcCommitScene(tree);
  Query query{scene, pairs, 0};
  for (const Vec3& x : scene.nodes) {
    RTCPointQuery ball{};
    ball.x = static_cast<float>(x[0]);
    ball.y = static_cast<float>(x[1]);
    ball.z = static_cast<float>(x[2]);
    RTCPointQueryContext context;
    rtcInitPointQueryContext(&context);
    rtcPointQuery(tree, &ball, &context, &take_box, &query);
    ++query.node;
  }
  rtcReleaseScene(tree);
  rtcReleaseDevice(device);
}

}  // namespace brunt::bench
