// SPDX-License-Identifier: Apache-2.0
// Where the moving body stands: options and files of poses.
#include "app/depth/depth_poses.hpp"

#include <catch2/catch.hpp>

#include "core/error.hpp"
#include "prepared_scene.hpp"

using namespace brunt;
using Catch::Contains;

TEST_CASE("depth_poses: a body is turned about the origin of its file, then moved") {
  const Placement pose = app::pose_of(" 1, 2 ,+3", "0,0,2,90");
  CHECK((pose(Vec3(1, 0, 0)) - Vec3(1, 3, 3)).norm() < 1e-15);
  CHECK(app::pose_of("", "").rotation == Mat3(Mat3::Identity()));
  CHECK_THROWS_WITH(app::pose_of("1,2,3,", ""), Contains("--at '1,2,3,'") && Contains("expected a point, x,y,z"));
  CHECK_THROWS_AS(app::pose_of("", "0,0,0,9"), InputError);
  CHECK_THROWS_AS(app::pose_of("1,2,inf", ""), InputError);
}

TEST_CASE("depth_poses: columns of a file stand in any order, with axis and angle or a quaternion") {
  const support::SceneFolder folder;
  const std::string axis = folder.write(
      "axis.csv",
      "# made by hand\r\n\r\ndegrees, z,y,x, axis_x,axis_y,axis_z\r\n90, 3,2,1, 0,0,5\r\n0,0,0,0,0,0,0\r\n");
  const std::string quaternion = folder.write("q.csv", "x,y,z,qw,qx,qy,qz\n1,2,3,1,0,0,1");
  const std::vector<Placement> one = app::read_poses(axis), other = app::read_poses(quaternion);
  REQUIRE(one.size() == 2);
  REQUIRE(other.size() == 1);
  CHECK((one[0].rotation - other[0].rotation).norm() < 1e-15);
  CHECK(one[0].translation == Vec3(1, 2, 3));
  CHECK(one[1].rotation == Mat3(Mat3::Identity()));
  const auto fault = [&](const std::string& text) { return folder.write("bad.csv", text); };
  CHECK_THROWS_WITH(app::read_poses(fault("x,y,z,x\n")), Contains("bad.csv:1: invalid second column 'x'"));
  CHECK_THROWS_WITH(app::read_poses(fault("x,y,z,qw\n")), Contains("missing"));
  CHECK_THROWS_WITH(app::read_poses(fault("x,y,z\n\n1,2\n")),
                    Contains("bad.csv:3: invalid row of 2 values; expected 3"));
  CHECK_THROWS_WITH(app::read_poses(fault("x,y,z,qw,qx,qy,qz\n1,2,3,0,0,0,0\n")), Contains("bad.csv:2"));
}

TEST_CASE("depth_poses: axes by name") {
  CHECK(app::axes_named("").empty());
  CHECK(app::axes_named("z, x") == std::vector<Vec3>{Vec3::UnitZ(), Vec3::UnitX()});
  CHECK_THROWS_AS(app::axes_named("x,"), InputError);
  CHECK_THROWS_AS(app::axes_named("xy"), InputError);
}
