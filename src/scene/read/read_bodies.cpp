// SPDX-License-Identifier: Apache-2.0
// Generated bodies.
#include <fmt/format.h>

#include <cmath>
#include <cstdlib>

#include "given_body.hpp"
#include "placement.hpp"

namespace brunt::scene {
namespace {

/// The axis, from 1, with the sign of the side that is kept.
const Choices<int> sides_of_section{{{"x", 1}, {"-x", -1}, {"y", 2}, {"-y", -2}}, {}};
const Choices<int> sides_of_sphere{{{"x", 1}, {"-x", -1}, {"y", 2}, {"-y", -2}, {"z", 3}, {"-z", -3}}, {}};
constexpr Range at_least_equal{1, infinity, true, false, "a number >= 1"};
constexpr double widest_element =
    30;  ///< [degrees] in a sector: its area is then 5 % less than that of the exact sector

/// A list of sides that are kept, at most one of an axis.
void read_sides(const Key& key, GivenBody& body, std::size_t size, std::string_view count) {
  const Choices<int>& choices = body.kind == "sphere" ? sides_of_sphere : sides_of_section;
  std::vector<std::string> words;
  for (const auto& [word, side] : choices.now) words.push_back(word);
  const std::string expected = fmt::format("a list of {}{}", count, fmt::join(words, ", "));
  const std::vector<Key> named = items(key, expected, size);
  if (is_list(key) && key.tree->children.empty() && size == 0) wrong(key, expected);
  for (const Key& one : named) {
    int side = 0;
    if (!read(one, side, choices)) continue;
    int& kept = nth(body.half, std::abs(side) - 1);
    if (kept != 0)
      fault(one, fmt::format("invalid side '{}': axis {} is named twice; expected each axis once", one.tree->text,
                             "xyz"[std::abs(side) - 1]));
    kept = side > 0 ? 1 : -1;
  }
}

void read_half(const Key& key, GivenBody& body) {
  read_sides(key, body, 0, "");
}
void read_quarter(const Key& key, GivenBody& body) {
  if (body.half != mesh::Half{})
    return fault(key, "invalid together with half; expected one of them, such as quarter: [x, y]");
  read_sides(key, body, 2, "two of ");
}

/// `sector: [from, to]`.
void read_sector(const Key& key, GivenBody& body) {
  constexpr std::string_view expected = "two angles in degrees [from, to], less than 360 apart";
  std::array<double, 2> angles{};
  if (!read(key, angles, any_number, expected)) return;
  const auto& [from, to] = angles;
  if (!(to > from && to - from < 360 && std::abs(from) <= 360))
    return fault(key, fmt::format("out of range: a sector from {} to {}; expected {}, the first from -360 to 360", from,
                                  to, expected));
  body.sector = {from, to};
}

const Choices<int> sides_of_box{{{"xmin", 0}, {"xmax", 1}, {"ymin", 2}, {"ymax", 3}, {"zmin", 4}, {"zmax", 5}}, {}};

/// Sides that a box of shells does not have.
void read_open(const Key& key, GivenBody& body) {
  if (!read(key, body.open, sides_of_box)) return;
  if (!body.shell) return fault(key, "invalid without shell: true; expected no open sides of a solid box");
  if (std::ranges::find(body.open, false) == body.open.end())
    fault(key, "invalid open: all six sides; expected at most five");
}

void read_radial(const Key& key, GivenBody& body) {
  read(key, body.elements[0].cells, at_least_one);
}

void judge_box(const Key& map, GivenBody& body) {
  const auto& [x, y, z] = body.size;
  body.body = BoxMesh{body.part, Vec3(x, y, z), body.elements, body.shell, body.open};
  const double nx = body.elements[0], ny = body.elements[1], nz = body.elements[2];
  if (body.shell) return judge_countable(map, 0, 2 * (nx * ny + ny * nz + nz * nx));
  judge_countable(map, (nx + 1) * (ny + 1) * (nz + 1), nx * ny * nz);
}

/// The thickness of a solid plate is that of its mesh, the thickness of a shell that of its part.
void judge_plate(const Key& map, GivenBody& body) {
  if (body.shell && has(map, "thickness"))
    fault(at(map, "thickness"),
          fmt::format("invalid with shell: true: the part has the thickness; expected parts.{}.thickness", body.part));
  if (!body.shell) demand(map, "thickness", positive.words);
  body.body = PlateMesh{body.part, body.plate_size, body.thickness, body.elements, body.shell};
  if (body.shell) body.elements[2] = 1;
  const double nx = body.elements[0], ny = body.elements[1], nz = body.elements[2];
  judge_countable(map, (nx + 1) * (ny + 1) * (nz + 1), nx * ny * nz);
}

void judge_cylinder(const Key& map, GivenBody& body) {
  CylinderMesh cylinder{body.part, body.radius, body.length, {}, body.half};
  for (const std::size_t i : {0, 1}) cylinder.elements[i] = body.elements[i];
  cylinder.half.nose = nose_of(map, body, body.radius, 0, 2);
  const double across = cylinder.elements[0], along = cylinder.elements[1];
  judge_countable(map, 4 * (across + 1) * (across + 1) * (along + 1), 4 * across * across * along);
  body.body = cylinder;
}

void judge_sphere(const Key& map, GivenBody& body) {
  if (body.finer > 1 && body.half[2] > 0)
    fault(at(map, has(map, "half") ? "half" : "quarter"),
          "invalid side z with finer: this half keeps the pole that is not refined; expected -z, or no half along z");
  const double across = body.elements[0];
  judge_countable(map, 8 * (across + 1) * (across + 1) * (across + 1), 8 * across * across * across);
  body.body = SphereMesh{body.part, body.radius, body.elements[0], body.finer, body.half, body.shell};
}

void judge_around(const Key& map, const GivenBody& body) {
  const Key elements = at(map, "elements");
  const int around = body.elements[1];
  const auto& [from, to] = body.sector;
  if (body.sector.cuts()) {
    const int least = static_cast<int>(std::ceil((to - from) / widest_element));
    if (around < least)
      fault(elements,
            fmt::format("out of range: {} elements around span {:g} degrees each; expected at least {} around", around,
                        (to - from) / around, least));
    return;
  }
  if (around < 3)
    return fault(elements,
                 fmt::format("out of range: {} elements around do not close a circle; expected at least 3", around));
  const int parts = (body.half[0] != 0 ? 2 : 1) * (body.half[1] != 0 ? 2 : 1);
  if (around % parts != 0)
    fault(elements,
          fmt::format(
              "invalid number of elements around: {} cannot be divided into {} equal parts; expected a multiple of {}",
              around, parts, parts));
}

/// A sector may reach the axis; it excludes half and quarter.
void judge_sector(const Key& map, const GivenBody& body) {
  if (!has(map, "sector")) {
    if (const Key inner = at(map, "inner_radius"); body.inner_radius && *body.inner_radius == 0)
      fault(inner, fmt::format("out of range: {}; expected {}", inner.tree->text, positive.words));
    return;
  }
  for (const char* other : {"half", "quarter"})
    if (has(map, other))
      return fault(at(map, "sector"), fmt::format("invalid together with {}; expected one of them", other));
}

void judge_tube(const Key& map, GivenBody& body) {
  judge_sector(map, body);
  const double inner = body.inner_radius.value_or(0), outer = body.inner_radius ? body.outer_radius : 0;
  if (outer > 0 && outer <= inner)
    fault(at(map, "outer_radius"),
          fmt::format("out of range: {} is not larger than inner_radius {}; expected a larger number", outer, inner));
  if (body.shell && has(map, "nose"))
    fault(at(map, "nose"), "invalid with shell: true; expected a tube without a nose");
  if (body.shell && body.elements[0].cells != 1)
    fault(at(map, "elements"),
          fmt::format("invalid with shell: true: {} elements through the wall; expected [1, around, along]",
                      body.elements[0].cells));
  if (body.shell && body.inner_radius && inner == 0 && has(map, "sector"))
    fault(at(map, "inner_radius"), fmt::format("out of range: 0 with shell: true; expected {}", positive.words));
  TubeMesh tube{body.part, inner, body.outer_radius, body.length, body.elements, body.half, body.shell};
  tube.half.sector = body.sector;
  judge_around(map, body);
  if (!body.shell) tube.half.nose = nose_of(map, body, outer, inner, body.elements[0]);
  const double through = body.elements[0], around = body.elements[1], along = body.elements[2];
  judge_countable(map, (through + 1) * around * (along + 1), through * around * along);
  body.body = tube;
}

void judge_torus(const Key& map, GivenBody& body) {
  const auto& [inner, outer] = body.tube;
  if (outer > 0 && outer <= inner)
    fault(at(map, "tube"),
          fmt::format(
              "out of range: the outer radius {} is not larger than the inner radius {}; expected a larger number",
              outer, inner));
  if (body.radius > 0 && outer > 0 && body.radius <= outer)
    fault(at(map, "radius"),
          fmt::format(
              "out of range: a ring of radius {} has no hole with a tube of outer radius {}; expected a number > {}",
              body.radius, outer, outer));
  const std::vector<Extent> extents = extents_of(body);
  for (const std::size_t i : {0, 1})
    if (body.elements[i] < 3)
      fault(at(map, "elements"), fmt::format("out of range: {} elements {} do not close a circle; expected at least 3",
                                             body.elements[i].cells, extents[i].what));
  const double ring = body.elements[0], around = body.elements[1], through = body.elements[2];
  judge_countable(map, ring * around * (through + 1), ring * around * through);
  body.body = TorusMesh{body.part, body.radius, body.tube, body.elements};
}

void judge_body(const Key& map, GivenBody& body) {
  if (body.kind == "box") return judge_box(map, body);
  if (body.kind == "cylinder") return judge_cylinder(map, body);
  if (body.kind == "sphere") return judge_sphere(map, body);
  if (body.kind == "tube") return judge_tube(map, body);
  if (body.kind == "torus") return judge_torus(map, body);
  judge_plate(map, body);
}

std::string_view kind_of_body(const GivenBody& body) {
  return body.kind;
}

void refuse_sector(const Key& key, GivenBody&) {
  fault(key, "invalid for a cylinder, which has half and quarter; expected a tube with inner_radius: 0 for a sector");
}

const std::string sides_words = fmt::format("list of {}, and of spheres `z`, `-z`", phrase(0, sides_of_section));

}  // namespace

const Table<GivenBody> body_keys{
    "mesh.BODY",
    "a map with the part, sizes and elements of the body",
    joined(
        std::vector<Row<GivenBody>>{
            {"part", value(&GivenBody::part, Text{"name", "a name for the part"}), "-",
             "Name of the body; it needs an entry in `parts`.", required},
            {"shell", of("box", "plate", "sphere", "tube"), value(&GivenBody::shell), "-",
             "Whether the body consists of [shells](#shells): the plate in z = 0, the sides of the box, the surface of "
             "the sphere, the middle of the tube's wall."},
            {"open", of("box"), special("list of " + phrase(0, sides_of_box), read_open), "-",
             "With `shell`: sides that the box does not have."},
            {"size", of("box"), value(&GivenBody::size, Each{positive, "three lengths > 0 [x, y, z]"}), "length",
             "Edges along x, y and z.", required},
            {"size", of("plate"), value(&GivenBody::plate_size, Each{positive, "two lengths > 0 [x, y]"}), "length",
             "Edges along x and y.", required},
            {"thickness", of("plate"), value(&GivenBody::thickness, positive), "length",
             "Extent along z; of shells it belongs to the part.", "required without `shell`"},
            {"radius", of("cylinder", "sphere", "torus"), value(&GivenBody::radius, positive), "length",
             "Radius; of a torus that of the ring, larger than its outer tube radius.", required},
            {"length", of("cylinder", "tube"), value(&GivenBody::length, positive), "length",
             "Length along z, without a nose.", required},
            {"inner_radius", of("tube"), value(&GivenBody::inner_radius, not_negative), "length",
             "Inner radius; with `sector` it may be 0.", required},
            {"outer_radius", of("tube"), value(&GivenBody::outer_radius, positive), "length",
             "Outer radius, larger than the inner one.", required},
            {"tube", of("torus"),
             value(&GivenBody::tube, Each{positive, "two lengths > 0 [inner radius, outer radius]"}), "length",
             "Inner and outer radius of the tube.", required},
            {"elements", of("box"), special("list of 3 integers >= 1", read_elements), "-",
             "Elements along x, y and z.", required},
            {"elements", of("plate"), special("list", read_elements), "-",
             "Three integers >= 1, elements along x, y and z; of shells two, along x and y.", required},
            {"elements", of("cylinder"), special("list of 2 integers >= 1", read_elements), "-",
             "Elements across the radius (at least 2) and along the axis.", required},
            {"elements", of("sphere"), special("integer >= 1", read_radial), "-",
             "Elements across the radius (at least 2).", required},
            {"elements", of("tube"), special("list of 3 integers >= 1", read_elements), "-",
             "Elements through the wall (1 of shells), around (at least 3) and along.", required},
            {"elements", of("torus"), special("list of 3 integers >= 1", read_elements), "-",
             "Elements around the ring, around the tube (at least 3 each) and through the wall.", required},
            {"bias", of("box", "plate", "cylinder", "tube", "torus"), special("list", read_bias), "-",
             "One number from 1e-6 to 1e6 for each direction: the size of the last element over the size of the first.",
             fmt::format("{} each", mesh::Division{}.bias)},
            {"half", of("cylinder", "sphere", "tube"), special(sides_words, read_half), "-",
             "Sides that are kept: `[x]` keeps x >= 0. `elements` counts the whole body."},
            {"quarter", of("cylinder", "sphere", "tube"), special("list of 2 sides", read_quarter), "-",
             "As `half`, with two sides: `[x, y]`."},
            {"finer", of("sphere"), value(&GivenBody::finer, at_least_equal), "-",
             "Grading: elements at the lowest point are so many times smaller."},
            {"sector", of("tube"), special("list of 2 angles", read_sector), "degree",
             "The part between two planes through the axis, `[from, to]`."},
            refused("sector", of("cylinder"), refuse_sector),
            {"nose", of("cylinder", "tube"), map_of(&GivenBody::nose, nose_keys), "-",
             "A tip on the upper end, see below."},
        },
        within(&GivenBody::placement, placement_rows())),
    judge_body,
    kind_of_body,
};

GivenBody::GivenBody(std::string_view kind_of_body) : kind(kind_of_body) {
  if (kind == "tube") elements = {1, 3, 1};  // rounds have three elements around at least
  if (kind == "torus") elements = {3, 3, 1};
}

}  // namespace brunt::scene
