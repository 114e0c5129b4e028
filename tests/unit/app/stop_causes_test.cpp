// SPDX-License-Identifier: Apache-2.0
// Causes in messages: only those that the model can have.
#include "app/watch/stop_causes.hpp"

#include <catch2/catch.hpp>

using namespace brunt;
using Catch::Contains;

namespace {

std::string cause(const std::vector<material::Law>& laws, GlobalIndex folded = 0) {
  model::Model model;
  for (const material::Law& law : laws) model.blocks.emplace_back().law = law;
  return app::cause_of_given_work(model, folded);
}

}  // namespace

TEST_CASE("cause of a negative internal energy: folds, rates and equations of state only where they are") {
  material::Metal fluid, metal;
  fluid.eos = material::EquationOfState{};
  CHECK_THAT(cause({fluid}),
             Contains("equation of state") && Contains("run.cfl") && !Contains("folded") && !Contains("neo_hookean"));
  CHECK_THAT(cause({metal}), Contains("rate form") && !Contains("equation of state") && !Contains("folded"));
  CHECK_THAT(cause({material::Elastic{}, fluid}),
             Contains("equation of state") && Contains("; or ") && Contains("rate form"));
  CHECK_THAT(cause({fluid}, 3), Contains("3 folded hex8 elements; or ") && Contains("equation of state"));
  CHECK_THAT(cause({material::NeoHookean{}}, 1), Contains("1 folded hex8 element") && !Contains("rate form"));
  CHECK_THAT(cause({material::NeoHookean{}, material::Rigid{}}),
             Contains("step that is too long") && !Contains("rate form"));
}

TEST_CASE("cause among rigid bodies: contact, supports and walls only where they are") {
  using app::cause_among_rigid_bodies;
  CHECK(cause_among_rigid_bodies({.contact = true}) == "contact that was not satisfied, or bodies inside each other");
  CHECK_THAT(cause_among_rigid_bodies({.contact = true, .at_limit = true}), Contains("max_iterations"));
  CHECK(cause_among_rigid_bodies({.walls = true}) == "contact with rigid walls that was not satisfied");
  CHECK_THAT(cause_among_rigid_bodies({.contact = true, .drives = true}),
             Contains("prescribed motions that drive") && !Contains("walls"));
  CHECK_THAT(cause_among_rigid_bodies({.walls = true, .moving_walls = true}),
             Contains("moving walls that drive") && !Contains("prescribed") && !Contains("inside each other"));
}
