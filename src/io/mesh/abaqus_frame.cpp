// SPDX-License-Identifier: Apache-2.0
#include "abaqus_frame.hpp"

#include <fmt/core.h>

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

#include "core/excerpt.hpp"

namespace brunt::io {
namespace {

/// 3 or 6 coordinates, each of them given.
std::vector<double> points(const AbaqusDeck& deck, const DeckLine& line, bool two) {
  const auto fields = deck.fields(line);
  if (fields.size() != 3 && !(two && fields.size() == 6))
    deck.fail(line.number, fmt::format("invalid line of {} coordinates in *SYSTEM; expected {}", fields.size(),
                                       two ? "3 or 6" : "3"));
  std::vector<double> values;
  for (const std::string_view field : fields) {
    if (field.empty()) deck.fail(line.number, "missing coordinate in *SYSTEM; expected a number in each field");
    values.push_back(deck.real(line, field, "a coordinate"));
  }
  return values;
}

/// A direction; its length must not be rounding of the points' coordinates.
Vec3 direction(const AbaqusDeck& deck, const DeckLine& line, const Vec3& vector, double scale) {
  constexpr double rounding = 1e-12;  // some thousand units in the last place of the coordinates
  if (!(vector.norm() > rounding * scale))
    deck.fail(line.number,
              "invalid points in *SYSTEM: they do not define the axes; expected points apart from each "
              "other, and not on one line");
  return vector.normalized();
}

}  // namespace

DeckFrame frame_of(const AbaqusDeck& deck, const DeckCard& card) {
  DeckFrame frame;
  if (card.data.empty()) return frame;
  if (card.data.size() > 2)
    deck.fail(card.data[2].number, "invalid data of *SYSTEM: more than two lines; expected at most two");
  const DeckLine& first = card.data[0];
  const auto a = points(deck, first, true);
  frame.origin = Vec3(a[0], a[1], a[2]);
  if (a.size() == 3 && card.data.size() == 1) return frame;
  if (a.size() == 3) deck.fail(first.number, "missing point on the x axis in *SYSTEM; expected 6 coordinates");
  const Vec3 b(a[3], a[4], a[5]);
  double scale = frame.origin.norm() + b.norm();
  Vec3 x = b - frame.origin, z = Vec3::UnitZ();
  if (card.data.size() == 2) {
    const auto last = points(deck, card.data[1], false);
    const Vec3 c(last[0], last[1], last[2]);
    scale += c.norm();
    x = direction(deck, first, x, scale);
    z = direction(deck, card.data[1], x.cross(c - frame.origin), scale);
  } else {
    x[2] = 0;
    x = direction(deck, first, x, scale);
  }
  frame.axes = {x, z.cross(x), z};
  return frame;
}

NodeSystem node_system_of(const AbaqusDeck& deck, const DeckCard& card) {
  if (!card.has("SYSTEM")) return NodeSystem::cartesian;
  const std::string system = compact(card.value("SYSTEM"));
  if (system == "R") return NodeSystem::cartesian;
  if (system == "C") return NodeSystem::cylindrical;
  if (system == "S") return NodeSystem::spherical;
  deck.fail(card.line, fmt::format("invalid SYSTEM={} of *NODE; expected R, C or S", excerpt(card.value("SYSTEM"))));
}

Vec3 cartesian(NodeSystem system, const Vec3& given) {
  if (system == NodeSystem::cartesian) return given;
  constexpr double degree = std::numbers::pi / 180;
  const double r = given[0], theta = given[1] * degree, phi = given[2] * degree;
  if (system == NodeSystem::cylindrical) return {r * std::cos(theta), r * std::sin(theta), given[2]};
  return {r * std::cos(theta) * std::cos(phi), r * std::sin(theta) * std::cos(phi), r * std::sin(phi)};
}

}  // namespace brunt::io
