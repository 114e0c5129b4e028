// SPDX-License-Identifier: Apache-2.0
// The part of a convex polygon in the plane that lies inside another one (Sutherland and Hodgman, Reentrant polygon
// clipping, CACM 17 (1974) 32). The corners of the result are determined once, in doubles. Each corner then has a
// recipe from which its coordinates follow in any number type, including derivatives by the corners of both polygons.
#pragma once
#include <array>
#include <cstdint>
#include <span>

namespace brunt::geometry {

/// A point of the plane [length].
template <class Number>
struct PlanePoint {
  Number x, y;
};

template <class Number>
PlanePoint<Number> operator-(const PlanePoint<Number>& a, const PlanePoint<Number>& b) {
  return {a.x - b.x, a.y - b.y};
}

/// Third component of the cross product.
template <class Number>
Number cross(const PlanePoint<Number>& a, const PlanePoint<Number>& b) {
  return a.x * b.y - a.y * b.x;
}

/// Distances below this share of the larger polygon's extent count as zero: a corner this close to a side lies on it.
/// It corresponds to 1e4 rounding errors. The area is uncertain by this share, and the derivative of a barely admitted
/// crossing by 2^-53 / 1e-12 = 1e-4.
constexpr double on_side = 1e-12;

/// A crossing that lies farther than this share of the extent from its side is replaced by the nearer end of that side:
/// the side was too short to have a direction.
constexpr double off_side = 1e-9;

/// The origin of a corner of the result.
struct ClipCorner {
  enum class Kind : std::uint8_t {
    subject,  ///< corner `first` of the subject
    clip,     ///< corner `first` of the clip
    crossing  ///< sides `first` and `second` cross: numbers over the subject's sides, then the clip's
  };
  Kind kind = Kind::subject;
  std::uint8_t first = 0, second = 0;
};

/// A convex polygon with three or four corners, counter-clockwise; side i runs from corner i to corner i + 1.
template <class Number>
using Polygon = std::span<const PlanePoint<Number>>;

struct ClippedPolygon {
  static constexpr int most_corners = 8;  ///< each of four sides adds at most one to four corners
  int corners = 0;                        ///< 0: the polygons do not overlap, or touch only
  std::array<ClipCorner, most_corners> recipe{};
  std::array<PlanePoint<double>, most_corners> point{};  ///< counter-clockwise [length]
};

/// The common part of two convex polygons of three or four corners each, both counter-clockwise. Coincident sides,
/// touching corners and sides of no length are allowed.
ClippedPolygon clip(Polygon<double> subject, Polygon<double> clip);

/// Area of a polygon, positive counter-clockwise [length^2].
double area(std::span<const PlanePoint<double>> corners);

/// A convex piece of a quadrilateral: numbers of its corners.
struct ConvexPiece {
  int corners = 0;
  std::array<int, 4> corner{};
};

struct ConvexPieces {
  int count = 0;
  std::array<ConvexPiece, 2> piece{};
};

/// A triangle or convex quadrilateral is returned unchanged; any other quadrilateral is split into two triangles along
/// the diagonal from its reflex corner. Counter-clockwise.
ConvexPieces convex_pieces(Polygon<double> corners);

/// The crossing of side i of one polygon with side j of another one (or the same), on the lines through them.
template <class Number>
PlanePoint<Number> crossing(const PlanePoint<Number>& from, const PlanePoint<Number>& to,
                            const PlanePoint<Number>& other_from, const PlanePoint<Number>& other_to) {
  const PlanePoint<Number> along = to - from, other = other_to - other_from;
  const Number at = cross(other_from - from, other) / cross(along, other);
  return {from.x + at * along.x, from.y + at * along.y};
}

/// Coordinates of a corner of the result from its recipe.
template <class Number>
PlanePoint<Number> corner_point(const ClipCorner& recipe, Polygon<Number> subject, Polygon<Number> clip) {
  const auto at = [](Polygon<Number> polygon, std::size_t i) -> const PlanePoint<Number>& {
    return polygon[i < polygon.size() ? i : 0];
  };
  const auto first = static_cast<std::size_t>(recipe.first), second = static_cast<std::size_t>(recipe.second);
  if (recipe.kind == ClipCorner::Kind::subject) return subject[first];
  if (recipe.kind == ClipCorner::Kind::clip) return clip[first];
  const std::size_t n = subject.size();
  const auto side_from = [&](std::size_t side) { return side < n ? at(subject, side) : at(clip, side - n); };
  const auto side_to = [&](std::size_t side) { return side < n ? at(subject, side + 1) : at(clip, side - n + 1); };
  return crossing(side_from(first), side_to(first), side_from(second), side_to(second));
}

}  // namespace brunt::geometry
