// SPDX-License-Identifier: Apache-2.0
// Initial velocities, supports and prescribed motions.
#include <algorithm>
#include <array>

#include "mesh/assemble.hpp"
#include "placement.hpp"
#include "scene/read/sections.hpp"
#include "selection.hpp"

namespace brunt::scene {
namespace {

const Choices<int> directions{{{"x", 0}, {"y", 1}, {"z", 2}, {"rx", 3}, {"ry", 4}, {"rz", 5}}, {}};

const Table<InitialMotion> spin_keys{
    "initial.rotation",
    "a map {axis: [x, y, z], point: [x, y, z], rate: number}",
    {
        {"axis", value(&InitialMotion::spin_axis, Vector::direction), "-", "Axis of the rotation.", required},
        {"point", value(&InitialMotion::spin_point, Vector::any), "length", "A point of the axis."},
        {"rate", value(&InitialMotion::spin_rate, any_number), "1/time", "Angular velocity in radians.", required},
    },
};

void judge_initial(const Key& map, InitialMotion&) {
  judge_selection(map);
  if (!has(map, "velocity") && !has(map, "rotation"))
    lacking(map, {"velocity", "rotation"}, "missing velocity or rotation; expected one of them, or both");
}

/// Translations and rotations.
void read_dofs(const Key& key, Fixed& fixed) {
  std::array<bool, 6> marked{};
  if (!read(key, marked, directions)) return;
  for (std::size_t c = 0; c < 3; ++c) {
    fixed.dofs[c] = marked[c];
    fixed.turns[c] = marked[c + 3];
  }
}

const Table<Rotation> turn_keys{
    "symmetry.rotate",
    "a map {axis: [x, y, z], degrees: number}",
    rotation_rows(),
};

/// The normal has been read.
void turn_normal(const Key& key, Symmetry& plane) {
  Rotation turn;
  turn_keys.read(key, turn);
  plane.normal = mesh::rotation(turn.axis, turn.degrees) * plane.normal;
}

using Gives = Prescribed::Gives;

/// The name of a curve, or a number, which is a constant.
template <Gives gives>
void read_motion(const Key& key, Prescribed& motion) {
  motion.gives = gives;
  const bool plain = !key.tree->quoted && !key.tree->text.empty();
  const bool numeric =
      plain && std::string_view("+-.0123456789").find(key.tree->text.front()) != std::string_view::npos;
  double constant = 0;
  if (!numeric)
    read(key, motion.curve, Named::curve);
  else if (gives == Gives::displacement)
    wrong(key, "the name of a curve that is 0 at t = 0");
  else if (read(key, constant, any_number))
    motion.scale *= constant;
}

void judge_prescribed(const Key& map, Prescribed&) {
  judge_selection(map);
  const auto given = std::ranges::count_if(std::array{"velocity", "displacement", "acceleration"},
                                           [&](const char* name) { return has(map, name); });
  if (given > 1)
    fault(map, "invalid entry: more than one kind of motion; expected one of velocity, displacement, acceleration");
  if (given == 0) demand(map, "velocity", "the name of a curve, or a number for a constant velocity");
}

}  // namespace

const Table<InitialMotion> initial_keys{
    "initial",
    "{part: name, velocity: [x, y, z]}",
    joined(
        selection(&InitialMotion::where),
        {
            {"velocity", value(&InitialMotion::velocity, Vector::any), "velocity",
             "Initial velocity. The last entry that selects a node counts."},
            {"rotation", map_of(spin_keys), "-", "Rotation that is added to `velocity`; one of the two is required."},
        }),
    judge_initial,
};

const Table<Fixed> fixed_keys{
    "fixed",
    "{set: name, dofs: [x, y, z]}",
    joined(selection(&Fixed::where),
           {
               {"dofs", special("list of " + phrase(0, directions), read_dofs), "-",
                "Fixed directions; rotations of rigid parts and of nodes of [shells](#shells) only.", required},
           }),
    [](const Key& map, Fixed&) { judge_selection(map); },
};

const Table<Symmetry> symmetry_keys{
    "symmetry",
    "{point: [x, y, z], normal: [x, y, z]}",
    {
        {"point", value(&Symmetry::point, Vector::any), "length",
         "A point of the plane. All nodes in the plane stay in it.", required},
        {"normal", value(&Symmetry::normal, Vector::direction), "-", "Normal of the plane.", required},
        {"rotate", special("map", turn_normal, {&turn_keys}), "-",
         "Rotation of the normal: `{axis: [0, 0, 1], degrees: 4}`."},
    },
};

const Table<Prescribed> prescribed_keys{
    "prescribed",
    "{set: name, dof: x, y or z, velocity: curve}",
    joined(selection(&Prescribed::where),
           {
               {"dof", value(&Prescribed::dof, directions), "-",
                "Direction; rotations, in radians, of rigid parts and of nodes of [shells](#shells) only.", required},
               {"scale", value(&Prescribed::scale, any_number), "-", "Factor on the curve."},
               {"velocity", special("name or number", read_motion<Gives::velocity>), "velocity", "Curve, or constant.",
                "required, or another motion"},
               {"displacement", special("name", read_motion<Gives::displacement>), "length",
                "Curve that is 0 at t = 0; exact at the times of the steps."},
               {"acceleration", special("name or number", read_motion<Gives::acceleration>), "length/time^2",
                "Curve, or constant; the velocity starts from its initial value."},
           }),
    judge_prescribed,
};

}  // namespace brunt::scene
