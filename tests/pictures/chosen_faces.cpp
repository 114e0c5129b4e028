// SPDX-License-Identifier: Apache-2.0
// One node at edges and corners of a body, and the rows that detection makes of it: for each place a line
// `place TITLE`, `face x y z ...` for each face, `node x y z`, and `row` with the face's number, the point and the
// normal.
#include <fmt/core.h>

#include <string>

#include "tests/unit/contact/detection/few_faces.hpp"

using namespace brunt;
using support::FewFaces;

namespace {

std::string text(const Vec3& x) {
  return fmt::format(" {:.6g} {:.6g} {:.6g}", x[0], x[1], x[2]);
}

void show(const std::string& title, FewFaces scene, const Vec3& node) {
  fmt::print("place {}\n", title);
  for (const contact::MasterFace& face : scene.faces) {
    fmt::print("face");
    for (const LocalIndex corner : face.nodes)
      fmt::print("{}", text(scene.motion[static_cast<std::size_t>(corner)].position));
    fmt::print("\n");
  }
  fmt::print("node{}\n", text(node));
  for (const contact::Row& row : scene.rows(node)) {
    Vec3 point = Vec3::Zero();
    for (std::size_t i = 1; i < static_cast<std::size_t>(row.node_count); ++i)
      point -= row.weights[i] * scene.motion[static_cast<std::size_t>(row.nodes[i])].position;
    fmt::print("row {}{}{}\n", row.key.master, text(point), text(row.normal));
  }
}

FewFaces facing(FewFaces scene, const Vec3& area) {
  scene.facets = {area};
  return scene;
}

}  // namespace

int main() {
  show("convex edge: one normal", support::two_slopes(270), {0, 0.5, -0.005});
  show("convex corner: one normal", facing(support::cube(), Vec3(-1, -1, -1)), {0.995, 0.995, 0.995});
  show("beside a convex edge: the nearer face's", facing(support::cube(), Vec3(-1, 0, -1)), {0.99, 0.5, 0.94});
  show("groove of 60 degrees: one a face", support::two_slopes(60), {0, 0.5, -0.02});
  show("corner of a box: one a face", support::box_corner(), Vec3::Constant(-0.02));
  show("valley of 161 degrees: one normal", support::two_slopes(161), {0, 0.5, -0.02});
}
