// SPDX-License-Identifier: Apache-2.0
// Loads on the bodies, mass damping, and the phase that finds a static state before t = 0.
#include <fmt/format.h>

#include "scene/read/sections.hpp"
#include "selection.hpp"

namespace brunt::scene {
namespace {

constexpr Text side_set{"name", "the name of a side set"};

void judge_force(const Key& map, DeadLoad& load) {
  judge_selection(map);
  if (has(map, "moment") && has(map, "total"))
    return fault(at(map, "moment"),
                 "invalid together with total; expected moment: on each node, alone or beside force");
  if (!has(map, "moment") || has(map, "force"))
    demand_one(map, {"force", "total"}, "missing force; expected force: for each node, or total: for all together",
               "invalid entry: force and total are both given; expected one of force: for each node, or total: for all "
               "together");
  load.kind = has(map, "total") ? DeadLoad::Kind::total : DeadLoad::Kind::each_node;
}

void judge_damping(const Key& map, model::Damping& damping) {
  if (damping.to <= damping.from)
    fault(at(map, "to"),
          fmt::format("invalid time {}: not later than from, {}; expected a later time", damping.to, damping.from));
}

}  // namespace

const Table<Pressure> pressure_keys{
    "pressure",
    "{set: name, value: number, curve: name}",
    {
        {"set", value(&Pressure::where, side_set), "-", "Name of a side set.", required},
        {"value", value(&Pressure::value, any_number), "stress",
         "Pressure on the current faces; positive values push inwards.", required},
        {"curve", value(&Pressure::curve, Named::curve), "-", "Factor over time.", "constant 1"},
    },
};

const Table<DeadLoad> forces_keys{
    "forces",
    "{set: name, force: [x, y, z]}",
    joined(
        selection(&DeadLoad::where),
        {
            {"force", inherited<DeadLoad>(&DeadLoad::value, Vector::any), "force",
             "Force on each selected node. Its direction is constant (dead load).", "required, or `total` or `moment`"},
            {"total", inherited<DeadLoad>(&DeadLoad::value, Vector::any), "force",
             "Force on the whole selection, distributed over its exterior faces by area.",
             "required, or `force` or `moment`"},
            {"moment", inherited<DeadLoad>(&DeadLoad::moment, Vector::any), "force length",
             "Moment on each selected node of [shells](#shells), about axes of constant direction."},
            {"curve", value(&DeadLoad::curve, Named::curve), "-", "Factor over time.", "constant 1"},
        }),
    judge_force,
};

const Table<DeadLoad> traction_keys{
    "traction",
    "{set: name, value: [x, y, z]}",
    {
        {"set", value(&DeadLoad::where, side_set), "-", "Name of a side set.", required},
        {"value", inherited<DeadLoad>(&DeadLoad::value, Vector::any), "stress",
         "Force by area of the initial configuration, of constant direction.", required},
        {"curve", value(&DeadLoad::curve, Named::curve), "-", "Factor over time.", "constant 1"},
    },
    [](const Key&, DeadLoad& load) { load.kind = DeadLoad::Kind::traction; },
};

const Table<Gravity> gravity_keys{
    "gravity",
    "a map {vector: [x, y, z], curve: name}",
    {
        {"vector", value(&Gravity::vector, Vector::any), "length/time^2", "Acceleration on all nodes.", required},
        {"curve", value(&Gravity::curve, Named::curve), "-", "Factor over time.", "constant 1"},
    },
};

const Table<model::Damping> damping_keys{
    "damping",
    "a map {alpha: number, from: time, to: time}",
    {
        {"alpha", value(&model::Damping::alpha, not_negative), "1/time",
         "Drag -alpha m v on every node; a free velocity decays with exp(-alpha t).", required},
        {"from", value(&model::Damping::from, not_negative), "time", "Begin."},
        {"to", value(&model::Damping::to, not_negative), "time", "End, later than `from`.", "end of the run"},
    },
    judge_damping,
};

const Table<Relaxation> relaxation_keys{
    "relaxation",
    "a map {tolerance: number, max_steps: count}",
    {
        {"tolerance", value(&Relaxation::tolerance, below_one), "-",
         "Unbalanced force over the loads, and relative error in the energy norm."},
        {"max_steps", value(&Relaxation::max_steps, Count{1, 1'000'000'000'000}), "-",
         "Steps after which the program stops with exit code 3."},
    },
};

}  // namespace brunt::scene
