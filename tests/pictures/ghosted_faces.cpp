// SPDX-License-Identifier: Apache-2.0
// Which faces of a scene are on which rank when contact searches for the first time. Usage, under mpirun:
// ghosted_faces FOLDER SCENE.yaml [key.path=value ...]. Rank r writes FOLDER/faces_r.txt: `own KEY x y z ...` and
// `ghost KEY`.
#include <algorithm>
#include <fstream>
#include <string>
#include <vector>

#include "app/program/failure.hpp"
#include "app/start/prepare.hpp"
#include "app/state/contact_setup.hpp"
#include "comm/session.hpp"
#include "contact/lists/candidate_pairs.hpp"

using namespace brunt;

namespace {

void write_faces(const comm::Communicator& ranks, const std::string& folder, const std::string& scene,
                 const std::vector<std::string>& overrides) {
  const std::unique_ptr<app::Prepared> run = app::prepare(ranks, scene, overrides);
  const contact::Surface& surface = run->contact->surface;
  const contact::Specification& specification = run->model.touching.contact;
  const contact::Roles roles = contact::roles_of(surface.bodies, specification);
  const contact::ContactSettings settings;
  const contact::ListSettings reach{.tolerances = settings.detection.tolerances,
                                    .motion = settings.motion_share * surface.mean_element_depth};
  std::vector<Vec3> positions;
  for (const LocalIndex node : surface.model_node)
    positions.push_back(run->model.mesh.coordinates[static_cast<std::size_t>(node)]);
  contact::ListScratch scratch;
  const auto found = contact::find_face_pairs({ranks, surface, specification, roles, positions, reach, scratch});

  std::ofstream out(folder + "/faces_" + std::to_string(ranks.rank()) + ".txt");
  std::size_t own = 0;
  for (const contact::SurfaceFace& face : surface.faces) {
    own += roles.master[static_cast<std::size_t>(face.body)] != 0 ? 1 : 0;
    out << "own " << face.key;
    for (const LocalIndex node : face.nodes) out << ' ' << positions[static_cast<std::size_t>(node)].transpose();
    out << '\n';
  }
  for (std::size_t m = own; m < found.masters.size(); ++m) out << "ghost " << found.masters[m].key << '\n';
}

}  // namespace

int main(int argc, char** argv) {
  const comm::Session session(argc, argv);
  const comm::Communicator ranks = comm::Communicator::world();
  return app::guarded(ranks, [&] {
    if (argc < 3) throw InputError("usage: ghosted_faces FOLDER SCENE.yaml [key.path=value ...]");
    write_faces(ranks, argv[1], argv[2], {argv + 3, argv + argc});
    return 0;
  });
}
