// SPDX-License-Identifier: Apache-2.0
// Parts: what a block of the mesh is made of.
#include <fmt/format.h>

#include <Eigen/Eigenvalues>

#include "read_erosion.hpp"
#include "scene/read/sections.hpp"

namespace brunt::scene {
namespace {

const Choices<ElementKind> element_kinds{{{"hex8", ElementKind::hex8},
                                          {"hex8_full", ElementKind::hex8_full},
                                          {"hex8_bbar", ElementKind::hex8_bbar},
                                          {"tet4", ElementKind::tet4},
                                          {"shell4", ElementKind::shell4},
                                          {"shell4_full", ElementKind::shell4_full},
                                          {"shell3", ElementKind::shell3}},
                                         {"quad4"}};
const Choices<HourglassKind> hourglass_kinds{{{"none", HourglassKind::none},
                                              {"viscous", HourglassKind::viscous},
                                              {"stiffness", HourglassKind::stiffness},
                                              {"elastic", HourglassKind::elastic}},
                                             {}};

constexpr double default_viscous = 0.1;
constexpr double default_stiffness = Hourglass{}.coefficient;

/// The default of the coefficient depends on the kind.
void judge_hourglass(const Key& map, Hourglass& hourglass) {
  if (has(map, "coefficient")) return;
  hourglass.coefficient = hourglass.kind == HourglassKind::viscous ? default_viscous : default_stiffness;
  if (hourglass.kind == HourglassKind::none) hourglass.coefficient = 0;
}

const Table<Hourglass> hourglass_keys{
    "parts.hourglass",
    "a map {kind: none, viscous, stiffness or elastic, coefficient: number}",
    {
        {"kind", value(&Hourglass::kind, hourglass_kinds), "-",
         "Damper, spring whose force plastic flow reduces, or elastic spring."},
        {"coefficient", value(&Hourglass::coefficient, share), "-", "Strength of the control.",
         fmt::format("{}; viscous {}", default_stiffness, default_viscous)},
    },
    judge_hourglass,
};

const Table<BulkViscosity> bulk_keys{
    "parts.bulk",
    "a map {linear: number, quadratic: number}",
    {
        {"linear", value(&BulkViscosity::linear, not_negative), "-",
         "Linear coefficient; 0 for foam, whose crushing front it would overload."},
        {"quadratic", value(&BulkViscosity::quadratic, not_negative), "-", "Quadratic coefficient."},
    },
};

/// The tensor of [xx, yy, zz, xy, yz, zx]. Principal moments of a mass distribution are not negative, and none exceeds
/// the sum of the others. A zero moment would allow no rotation about its axis.
void read_inertia(const Key& key, RigidGiven& given) {
  constexpr std::string_view expected = "[xx, yy, zz, xy, yz, zx] about the centre";
  std::array<double, 6> value{};
  if (!read(key, value, any_number, expected)) return;
  Mat3 tensor;
  tensor << value[0], value[3], value[5],  //
      value[3], value[1], value[4],        //
      value[5], value[4], value[2];
  const Vec3 moments = Eigen::SelfAdjointEigenSolver<Mat3>(tensor, Eigen::EigenvaluesOnly).eigenvalues();
  constexpr double rounding = 1e-9;
  const bool positive_moments = moments[0] > rounding * moments[2];
  const bool of_masses = moments[0] + moments[1] >= (1 - rounding) * moments[2];
  if (positive_moments && of_masses)
    given.inertia = tensor;
  else
    fault(key, fmt::format("invalid inertia: the principal moments are {:g}, {:g}, {:g}; expected moments > 0, each at "
                           "most the sum of the other two",
                           moments[0], moments[1], moments[2]));
}

const Table<RigidGiven> rigid_keys{
    "parts.rigid",
    "a map {mass: number, centre: [x, y, z], inertia: [xx, yy, zz, xy, yz, zx]}, or {joins: part}",
    {
        {"mass", value(&RigidGiven::mass, positive), "mass", "Mass of the body.", "of the elements"},
        {"centre", value(&RigidGiven::centre, Vector::any), "length",
         "Centre of mass at the start; the inertia of the elements follows it by the parallel axis theorem.",
         "of the elements"},
        {"inertia", special("list of 6 numbers", read_inertia), "mass length^2",
         "`[xx, yy, zz, xy, yz, zx]` about the centre in the scene's axes, with xy = -sum of m x y.",
         "of the elements"},
        {"reference", value(&RigidGiven::reference, Vector::any), "length",
         "Point at the start that `fixed` and `prescribed` hold and drive, and that probes of motion follow.",
         "centre of mass"},
        {"joins", value(&RigidGiven::joins, Named::part), "-",
         "The part is one body with this rigid part, whose mass properties count; no other key of `rigid` beside it."},
    },
};

using element::ShellSection;
using element::ThicknessRule;
const Choices<ThicknessRule> thickness_rules{{{"gauss", ThicknessRule::gauss}, {"lobatto", ThicknessRule::lobatto}},
                                             {}};
constexpr Range within_thickness{-0.5, 0.5, true, true, "a number from -0.5 to 0.5"};

const std::vector<Row<ShellSection>> shell_rows{
    {"thickness", value(&ShellSection::thickness, positive), "length", "Thickness of a [shell](#shells) at the start.",
     "none, but shells need it"},
    {"points", value(&ShellSection::points, Count{1, ShellSection::most_points}), "-",
     "Of shells: points through the thickness; one has no resistance to bending."},
    {"rule", value(&ShellSection::rule, thickness_rules), "-",
     "Of shells: places of the points; `lobatto` has points on both faces, at least 2."},
    {"offset", value(&ShellSection::offset, within_thickness), "-",
     "Of shells: distance of the middle from the surface of the nodes along the normal, over the thickness."},
    {"thinning", value(&ShellSection::thinning), "-",
     "Of shells: whether the thickness follows the strain across the shell."},
    {"warping", value(&ShellSection::warping), "-",
     "Of `shell4`: whether its fibres follow the warped surface, by which rigid motions give no force."},
};

/// Keys of shells on a part of solid elements, and a shell without a thickness. The mesh decides where the scene names
/// no element.
void judge_shell(const Key& map, Part& part) {
  std::string first;
  for (const Row<ShellSection>& row : shell_rows)
    if (first.empty() && has(map, row.said.key)) first = row.said.key;
  const bool wrong_thickness = has(map, "thickness") && part.section.thickness == 0;  // a fault of its own
  if (part.element && !is_shell(part)) {
    if (!first.empty())
      fault(at(map, first), fmt::format("invalid for element {}: only shells have this key; expected shell4, "
                                        "shell4_full or shell3, or no {}",
                                        element::name_of(*part.element), first));
  } else if (part.section.thickness == 0 && !wrong_thickness && (part.element || !first.empty())) {
    lacking(map, {"thickness"},
            part.element
                ? "missing thickness of shells; expected thickness: a length > 0"
                : fmt::format("missing thickness beside {}, a key of shells; expected thickness: a length > 0, "
                              "or no {} of solid elements",
                              first, first));
  }
  if (part.section.rule == ThicknessRule::lobatto && part.section.points < 2)
    fault(at(map, "points"),
          "out of range: 1 point with rule: lobatto, which has points on both faces; expected at least 2");
}

const std::vector<Row<Part>> part_rows{
    {"block", value(&Part::block, Text{"name", "the name or number of a block of the mesh"}), "-",
     "Name or number of a block of the mesh; a number that blocks of two files have is refused.", "name of the part"},
    {"material", value(&Part::material, Named::material), "-", "Name of a material.", required},
    {"element", value(&Part::element, element_kinds), "-",
     "One-point, fully integrated or B-bar hexahedron, or linear tetrahedron, [which "
     "one](../../cases/LIMITS.md#materials-and-elements); or [shells](#shells).",
     "`hex8`; of quadrilaterals `shell4`, of triangles `shell3`"},
    {"hourglass", map_of(&Part::hourglass, hourglass_keys), "-",
     "[Hourglass control](../element/README.md#hourglass-control-and-folded-elements) of `hex8` and `shell4`.",
     "see below"},
    {"bulk", map_of(&Part::bulk, bulk_keys), "-", "[Bulk viscosity](../element/README.md#bulk-viscosity).",
     "see below"},
    {"rigid", map_of(&Part::rigid, rigid_keys), "-", "Mass properties of a [rigid part](#rigid-parts)."},
    {"erosion", map_of(&Part::erosion, erosion_keys), "-", "Criteria for the [deletion of elements](#erosion)."},
};

const Table<Part> part_keys{
    "parts",
    "a map {material: name, ...}",
    joined(part_rows, within(&Part::section, shell_rows)),
    judge_shell,
};

/// Materials have been read.
void read_part_map(const Key& map, Input& input) {
  for (const auto& [name, key] : entries(map, "a map of names, each {material: name, ...}")) {
    Part& part = input.parts.emplace_back();
    part.name = part.block = name;
    part_keys.read(key, part);
    judge_erosion_of_part(at(key, "erosion"), part, input.materials);
  }
}

}  // namespace

Value<Input> parts_value() {
  return special("map", read_part_map, {&part_keys});
}

}  // namespace brunt::scene
