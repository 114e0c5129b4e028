// SPDX-License-Identifier: Apache-2.0
// The result folder: a killed run is gone on with, results and other questions are left alone.
#include "app/depth/depth_folder.hpp"

#include <catch2/catch.hpp>

#include "core/error.hpp"
#include "depth_rows.hpp"
#include "io/text_file.hpp"
#include "prepared_scene.hpp"

using namespace brunt;
using Catch::Contains;

namespace {

app::DepthOptions options_of(const support::SceneFolder& folder, bool force = false) {
  app::DepthOptions options;
  options.out = folder.file("out");
  options.force = force;
  return options;
}

}  // namespace

TEST_CASE("depth_folder: whole rows of a killed run are kept, one that is cut off is written again") {
  const support::SceneFolder folder;
  const app::DepthOptions options = options_of(folder);
  const std::string table = options.out + "/depth.csv";
  {
    app::DepthFolder first(options, "question");
    CHECK(first.earlier().empty());
    first.add(support::depth_row());
    first.add(support::depth_row());
  }
  const std::string whole = io::read_text(table);
  io::replace_text(table, whole.substr(0, whole.size() - 1));
  {
    app::DepthFolder again(options, "question");
    REQUIRE(again.earlier().size() == 1);
    CHECK(again.earlier()[0].row.a == support::depth_row().a);
    again.add(support::depth_row());
    again.finish({{"answers", 2}});
  }
  CHECK(io::read_text(table) == whole);
  CHECK_THAT(io::read_text(options.out + "/depth.json"), Contains("\"answers\": 2"));
}

TEST_CASE("depth_folder: results and unfinished results of another question are refused, unless forced") {
  const support::SceneFolder folder;
  const app::DepthOptions options = options_of(folder);
  app::DepthFolder(options, "one").add(support::depth_row());
  CHECK_THROWS_WITH(app::DepthFolder(options, "two"), Contains("another query"));
  app::DepthFolder(options, "one").finish({});
  CHECK_THROWS_WITH(app::DepthFolder(options, "one"), Contains("--force"));
  CHECK(app::DepthFolder(options_of(folder, true), "two").earlier().empty());
  CHECK(io::read_text(options.out + "/depth.csv") == app::csv_header());
}

TEST_CASE("depth_folder: without --out nothing is written") {
  app::DepthFolder none(app::DepthOptions{}, "question");
  CHECK_NOTHROW(none.add(support::depth_row()));
  CHECK_NOTHROW(none.finish({}));
  CHECK(none.earlier().empty());
}
