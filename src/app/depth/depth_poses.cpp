// SPDX-License-Identifier: Apache-2.0
#include "depth_poses.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <numbers>
#include <optional>
#include <string_view>

#include "core/error.hpp"
#include "core/excerpt.hpp"
#include "io/csv.hpp"
#include "io/text_file.hpp"

namespace brunt::app {
namespace {

std::optional<double> number(std::string_view text) {
  double value = 0;
  if (text.starts_with('+')) text.remove_prefix(1);
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || end != text.data() + text.size() || !std::isfinite(value)) return std::nullopt;
  return value;
}

std::vector<double> numbers_of_option(const char* option, const std::string& text, std::size_t count,
                                      const char* expected) {
  std::vector<double> values;
  for (const std::string_view field : io::comma_fields(text))
    if (const auto value = number(field)) values.push_back(*value);
  if (values.size() != count || io::comma_fields(text).size() != count)
    throw InputError(fmt::format("invalid {} '{}': expected {}", option, excerpt(text), expected));
  return values;
}

Mat3 turned(const Vec3& axis, double degrees) {
  return Eigen::AngleAxisd(degrees * std::numbers::pi / 180, axis.normalized()).toRotationMatrix();
}

constexpr std::array<std::string_view, 11> known = {"x",       "y",  "z",  "axis_x", "axis_y", "axis_z",
                                                    "degrees", "qw", "qx", "qy",     "qz"};

/// Which column holds each of `known`; npos: none.
struct Columns {
  std::array<std::size_t, known.size()> at{};
  std::size_t count = 0;
  [[nodiscard]] bool has(std::size_t first, std::size_t last) const {
    return std::all_of(at.begin() + static_cast<std::ptrdiff_t>(first), at.begin() + static_cast<std::ptrdiff_t>(last),
                       [](std::size_t k) { return k != std::string_view::npos; });
  }
  [[nodiscard]] bool has_any(std::size_t first, std::size_t last) const {
    return std::any_of(at.begin() + static_cast<std::ptrdiff_t>(first), at.begin() + static_cast<std::ptrdiff_t>(last),
                       [](std::size_t k) { return k != std::string_view::npos; });
  }
};

Columns columns_of(std::string_view header, const std::string& place) {
  constexpr const char* expected =
      "; expected columns x, y, z and, for a rotation, axis_x, axis_y, axis_z, degrees or qw, qx, qy, qz";
  Columns columns;
  columns.at.fill(std::string_view::npos);
  for (const std::string_view name : io::comma_fields(header)) {
    const auto found = std::ranges::find(known, name);
    if (found == known.end())
      throw InputError(fmt::format("{}: unknown column '{}'{}", place, excerpt(name), expected));
    std::size_t& at = nth(columns.at, found - known.begin());
    if (at != std::string_view::npos)
      throw InputError(fmt::format("{}: invalid second column '{}'{}", place, excerpt(name), expected));
    at = columns.count++;
  }
  const bool axis = columns.has_any(3, 7), quaternion = columns.has_any(7, 11);
  if (!columns.has(0, 3) || (axis && !columns.has(3, 7)) || (quaternion && !columns.has(7, 11)) || (axis && quaternion))
    throw InputError(fmt::format("{}: missing or conflicting columns{}", place, expected));
  return columns;
}

Placement pose_of_row(const Columns& columns, const std::vector<double>& row, const std::string& place) {
  const auto value = [&](std::size_t k) { return row[columns.at[k]]; };
  Placement pose{.translation = {value(0), value(1), value(2)}};
  if (columns.has(3, 7)) {
    const Vec3 axis(value(3), value(4), value(5));
    if (!(axis.norm() > 0) && value(6) != 0)
      throw InputError(fmt::format("{}: invalid axis [0, 0, 0]; expected an axis that is not zero", place));
    if (axis.norm() > 0) pose.rotation = turned(axis, value(6));
  } else if (columns.has(7, 11)) {
    const Eigen::Quaterniond turn(value(7), value(8), value(9), value(10));
    if (!(turn.norm() > 0))
      throw InputError(fmt::format("{}: invalid quaternion [0, 0, 0, 0]; expected one that is not zero", place));
    pose.rotation = turn.normalized().toRotationMatrix();
  }
  return pose;
}

}  // namespace

Placement pose_of(const std::string& at, const std::string& turn) {
  Placement pose;
  if (!turn.empty()) {
    const std::vector<double> t = numbers_of_option("--turn", turn, 4, "an axis and an angle, x,y,z,degrees");
    const Vec3 axis(t[0], t[1], t[2]);
    if (!(axis.norm() > 0))
      throw InputError("invalid --turn '" + excerpt(turn) + "': expected an axis that is not zero");
    pose.rotation = turned(axis, t[3]);
  }
  if (!at.empty()) {
    const std::vector<double> x = numbers_of_option("--at", at, 3, "a point, x,y,z");
    pose.translation = {x[0], x[1], x[2]};
  }
  return pose;
}

std::vector<Placement> read_poses(const std::string& path) {
  const std::string text = io::plain_text(io::read_text(path), path);
  std::vector<Placement> poses;
  std::optional<Columns> columns;
  std::size_t line_number = 0;
  for (std::size_t from = 0; from < text.size();) {
    const std::size_t end = std::min(text.find('\n', from), text.size());
    const std::string_view line = io::trimmed(std::string_view(text).substr(from, end - from));
    from = end + 1;
    const std::string place = fmt::format("{}:{}", path, ++line_number);
    if (line.empty() || line.starts_with('#')) continue;
    if (!columns) {
      columns = columns_of(line, place);
      continue;
    }
    std::vector<double> row;
    for (const std::string_view field : io::comma_fields(line)) {
      const auto value = number(field);
      if (!value)
        throw InputError(fmt::format("{}: invalid number '{}'; expected a finite number", place, excerpt(field)));
      row.push_back(*value);
    }
    if (row.size() != columns->count)
      throw InputError(fmt::format("{}: invalid row of {} values; expected {}, one for each column", place, row.size(),
                                   columns->count));
    poses.push_back(pose_of_row(*columns, row, place));
  }
  if (poses.empty()) throw InputError(path + ": missing poses; expected a header line and one line for each pose");
  return poses;
}

std::vector<Vec3> axes_named(const std::string& text) {
  std::vector<Vec3> axes;
  if (text.empty()) return axes;
  for (const std::string_view name : io::comma_fields(text)) {
    const std::size_t axis = std::string_view("xyz").find(name);
    if (name.size() != 1 || axis == std::string_view::npos)
      throw InputError("invalid --along '" + excerpt(text) + "': expected one or more of x, y, z, as in --along x,z");
    axes.push_back(Vec3::Unit(static_cast<Eigen::Index>(axis)));
  }
  return axes;
}

}  // namespace brunt::app
