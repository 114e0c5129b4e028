// SPDX-License-Identifier: Apache-2.0
// Means, maxima and imbalance over ranks, and what a run on one rank reports of them.
#include "app/report/parallel_report.hpp"

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>
#include <vector>

#include "app/report/recording.hpp"
#include "prepared_scene.hpp"

using namespace brunt;

TEST_CASE("parallel report: mean, largest and their ratio") {
  const std::vector<double> values{1, 2, 6};
  const app::MeanAndMax figure = app::mean_and_max(values);
  CHECK(figure.mean == 3);
  CHECK(figure.max == 6);
  CHECK(figure.imbalance() == 2);
  CHECK(app::mean_and_max({}).mean == 0);
  CHECK(app::mean_and_max({}).imbalance() == 1);  // nothing is balanced
}

TEST_CASE("parallel report: neighbours are the ranks that hold a node of this one, each once") {
  mesh::LocalMesh mesh;
  CHECK(app::neighbours_of(mesh) == 0);
  for (const std::vector<Rank>& holders : {std::vector<Rank>{3}, {3, 5}, {1, 3}}) {
    mesh.sharers.values.insert(mesh.sharers.values.end(), holders.begin(), holders.end());
    mesh.sharers.close_row();
  }
  CHECK(app::neighbours_of(mesh) == 3);
}

TEST_CASE("parallel report: messages a step, of a step that one rank takes") {
  support::PreparedScene scene{support::two_bodies};
  const comm::Communicator& ranks = scene.run->links.ranks;
  const comm::Traffic before = sent_by(ranks);
  comm::Traffic output;
  scene.evaluate();
  {
    const app::Recording recording(scene.run->links, output);
    ranks.barrier();
  }
  const comm::Traffic sent = sent_by(ranks) - before;
  CHECK(sent.halo.messages == 0);
  CHECK(output.collective.messages == 1);
  CHECK(sent.collective.messages > output.collective.messages);

  const nlohmann::json report =
      app::parallel_summary(ranks, scene.run->model, {2, sent - output, scene.run->links.timers});
  CHECK(report["neighbours"]["max"] == 0);
  CHECK(report["imbalance"]["elements"] == 1);
  CHECK(report["halo"]["bytes"]["mean"] == 0);
  CHECK(report["collective"]["messages"]["mean"] == 0.5 * static_cast<double>(sent.collective.messages - 1));
  CHECK(report["peak_memory"]["mean"] > 1e6);  // a process with MPI
  CHECK(report["peak_memory"]["mean"] == report["peak_memory"]["max"]);
}
