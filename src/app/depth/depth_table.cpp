// SPDX-License-Identifier: Apache-2.0
#include "depth_table.hpp"

#include <fmt/format.h>

#include <charconv>

#include "app/program/depth_options.hpp"
#include "core/error.hpp"
#include "core/excerpt.hpp"
#include "depth_report.hpp"
#include "io/csv.hpp"

namespace brunt::app {
namespace {

/// Columns of csv_header; a vector's are those of its first component.
namespace column {
enum : std::size_t {
  pose,
  a,
  b,
  metric,
  overlap,
  found,
  depth,
  bound,
  distance,
  axis,
  point = axis + 3,
  degrees = point + 3,
  slide,
  shift,
  turn = shift + 3,
  contacts = turn + 4,
  walks,
  steps,
  queries,
  time_ms,
  overlaps,
  proven,
  count
};
}  // namespace column

/// The fields of one row as values.
class Record {
 public:
  Record(std::span<const std::string> fields, const std::string& place) : fields_(fields), place_(place) {
    if (fields.size() != column::count)
      fail(fmt::format("invalid row of {} fields; expected {}", fields.size(), std::size_t{column::count}));
  }
  [[nodiscard]] const std::string& text(std::size_t k) const { return fields_[k]; }
  template <class T>
  [[nodiscard]] T number(std::size_t k) const {
    T value{};
    const std::string& field = fields_[k];
    const auto [end, error] = std::from_chars(field.data(), field.data() + field.size(), value);
    if (error != std::errc{} || end != field.data() + field.size())
      fail(fmt::format("invalid number '{}'; expected a row of brunt depth", excerpt(field)));
    return value;
  }
  [[nodiscard]] bool flag(std::size_t k) const { return fields_[k] == "1"; }
  [[nodiscard]] Vec3 vector(std::size_t k) const {
    return {number<double>(k), number<double>(k + 1), number<double>(k + 2)};
  }
  [[nodiscard]] Placement placement() const {
    const Vec3 v = vector(column::turn + 1);
    return {Eigen::Quaterniond(number<double>(column::turn), v[0], v[1], v[2]).normalized().toRotationMatrix(),
            vector(column::shift)};
  }

 private:
  [[noreturn]] void fail(const std::string& what) const { throw InputError(fmt::format("{}: {}", place_, what)); }
  std::span<const std::string> fields_;
  const std::string& place_;
};

}  // namespace

std::string csv_header() {
  return "pose,a,b,metric,overlap,found,depth,bound,distance,axis_x,axis_y,axis_z,point_x,point_y,point_z,degrees,"
         "slide,"
         "x,y,z,qw,qx,qy,qz,contacts,walks,steps,queries,time_ms,overlaps,proven\n";
}

std::string csv_row(const DepthRow& row) {
  const depth::Answer& answer = row.answer;
  const PlacedScrew screw = placed_screw(row);
  const Eigen::Quaterniond turn(answer.placement.rotation);
  const Vec3& x = answer.placement.translation;
  return fmt::format(
      "{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{:.3f},{},{}\n", row.pose,
      io::csv_field(row.a), io::csv_field(row.b), name_of(row.metric), answer.overlap ? 1 : 0, answer.found ? 1 : 0,
      answer.depth, answer.bound, answer.distance, screw.axis[0], screw.axis[1], screw.axis[2], screw.point[0],
      screw.point[1], screw.point[2], screw.degrees, screw.slide, x[0], x[1], x[2], turn.w(), turn.x(), turn.y(),
      turn.z(), answer.contacts.size(), answer.walks, answer.steps, answer.queries, 1e3 * row.seconds, answer.overlaps,
      answer.proven ? 1 : 0);
}

EarlierRow row_of_record(std::span<const std::string> fields, const std::string& place) {
  const Record record(fields, place);
  EarlierRow earlier;
  DepthRow& row = earlier.row;
  row.pose = record.number<std::int64_t>(column::pose);
  row.a = record.text(column::a);
  row.b = record.text(column::b);
  row.metric = metric_named(record.text(column::metric));
  row.seconds = 1e-3 * record.number<double>(column::time_ms);
  depth::Answer& answer = row.answer;
  answer.overlap = record.flag(column::overlap);
  answer.found = record.flag(column::found);
  answer.depth = record.number<double>(column::depth);
  answer.bound = record.number<double>(column::bound);
  answer.distance = record.number<double>(column::distance);
  answer.placement = record.placement();
  answer.overlaps = record.number<double>(column::overlaps);
  answer.proven = record.flag(column::proven);
  answer.walks = record.number<int>(column::walks);
  answer.steps = record.number<int>(column::steps);
  answer.queries = record.number<std::int64_t>(column::queries);
  earlier.screw = {record.vector(column::axis), record.vector(column::point), record.number<double>(column::degrees),
                   record.number<double>(column::slide)};
  earlier.contacts = record.number<std::size_t>(column::contacts);
  return earlier;
}

}  // namespace brunt::app
