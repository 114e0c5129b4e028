// SPDX-License-Identifier: Apache-2.0
#include "depth_report.hpp"

#include <fmt/format.h>

#include <cstring>
#include <numbers>
#include <span>

#include "brunt/core/error.hpp"
#include "depth_options.hpp"

namespace brunt::app {
namespace {

/// The screw of a motion, in the coordinates of B.
struct PlacedScrew {
  Vec3 axis, point;
  double degrees, slide;
};

PlacedScrew placed_screw(const DepthRow& row) {
  const depth::Screw screw = depth::screw_of(row.answer.motion);
  return {row.start.rotation * screw.axis, row.start(row.centroid + screw.point), screw.angle * 180 / std::numbers::pi,
          screw.slide};
}

std::string text_of(const Vec3& x) {
  return fmt::format("({:.6g}, {:.6g}, {:.6g})", x[0], x[1], x[2]);
}

nlohmann::ordered_json list(const Vec3& x) {
  return nlohmann::ordered_json::array({x[0], x[1], x[2]});
}

nlohmann::ordered_json matrix(const Placement& placement) {
  auto rows = nlohmann::ordered_json::array();
  for (int r = 0; r < 3; ++r)
    rows.push_back(
        {placement.rotation(r, 0), placement.rotation(r, 1), placement.rotation(r, 2), placement.translation[r]});
  rows.push_back({0.0, 0.0, 0.0, 1.0});
  return rows;
}

class Writer {
 public:
  template <class T>
  void put(const T& value) {
    static_assert(std::is_trivially_copyable_v<T>);
    const auto* from = reinterpret_cast<const std::byte*>(&value);
    bytes_.insert(bytes_.end(), from, from + sizeof value);
  }
  void put(const Vec3& x) {
    for (int c = 0; c < 3; ++c) put(x[c]);
  }
  void put(const Placement& p) {
    for (int c = 0; c < 3; ++c) put(Vec3(p.rotation.col(c)));
    put(p.translation);
  }
  void put(const std::string& text) {
    put(text.size());
    for (const char c : text) put(c);
  }
  [[nodiscard]] std::vector<std::byte> bytes() && { return std::move(bytes_); }

 private:
  std::vector<std::byte> bytes_;
};

class Reader {
 public:
  explicit Reader(std::span<const std::byte> bytes) : bytes_(bytes) {}
  template <class T>
  void get(T& value) {
    demand(at_ + sizeof value <= bytes_.size(), "a message holds what was put into it");
    std::memcpy(&value, bytes_.data() + at_, sizeof value);
    at_ += sizeof value;
  }
  void get(Vec3& x) {
    for (int c = 0; c < 3; ++c) get(x[c]);
  }
  void get(Placement& p) {
    for (int c = 0; c < 3; ++c) {
      Vec3 column;
      get(column);
      p.rotation.col(c) = column;
    }
    get(p.translation);
  }
  void get(std::string& text) {
    std::size_t size = 0;
    get(size);
    text.resize(size);
    for (char& c : text) get(c);
  }

 private:
  std::span<const std::byte> bytes_;
  std::size_t at_ = 0;
};

/// Visits everything of a row but its contacts.
template <class Row, class Visit>
void visit_row(Row& row, Visit&& visit) {
  visit(row.pose);
  visit(row.a);
  visit(row.b);
  visit(row.metric);
  visit(row.centroid);
  visit(row.start);
  visit(row.seconds);
  auto& answer = row.answer;
  visit(answer.overlap);
  visit(answer.found);
  visit(answer.depth);
  visit(answer.bound);
  visit(answer.distance);
  visit(answer.placement);
  visit(answer.motion.shift);
  visit(answer.walks);
  visit(answer.steps);
  visit(answer.queries);
}

}  // namespace

std::vector<std::byte> packed(const std::vector<DepthRow>& rows) {
  Writer out;
  out.put(rows.size());
  for (const DepthRow& row : rows) {
    visit_row(row, [&](const auto& value) { out.put(value); });
    const depth::Turn& turn = row.answer.motion.turn;
    for (const double q : {turn.w(), turn.x(), turn.y(), turn.z()}) out.put(q);
    out.put(row.answer.contacts.size());
    for (const depth::ContactPoint& contact : row.answer.contacts) {
      out.put(contact.point);
      out.put(contact.normal);
      out.put(contact.gap);
    }
  }
  return std::move(out).bytes();
}

std::vector<DepthRow> unpacked(std::span<const std::byte> bytes) {
  Reader in(bytes);
  std::size_t count = 0;
  in.get(count);
  std::vector<DepthRow> rows(count);
  for (DepthRow& row : rows) {
    visit_row(row, [&](auto& value) { in.get(value); });
    double w = 1, x = 0, y = 0, z = 0;
    for (double* q : {&w, &x, &y, &z}) in.get(*q);
    row.answer.motion.turn = depth::Turn(w, x, y, z);
    std::size_t contacts = 0;
    in.get(contacts);
    row.answer.contacts.resize(contacts);
    for (depth::ContactPoint& contact : row.answer.contacts) {
      in.get(contact.point);
      in.get(contact.normal);
      in.get(contact.gap);
    }
  }
  return rows;
}

std::string described(const DepthRow& row) {
  const depth::Answer& answer = row.answer;
  if (!answer.overlap) return fmt::format("{} and {} do not overlap: distance {:.6g}\n", row.a, row.b, answer.distance);
  std::string text = fmt::format("{} in {}, {}: ", row.a, row.b, name_of(row.metric));
  if (!answer.found)
    return text + fmt::format("no admitted motion separates them; no shorter one than {:.6g} can\n", answer.bound);
  text += fmt::format("depth {:.9g}, bound {:.6g} (no motion shorter than it separates them)\n", answer.depth,
                      answer.bound);
  const PlacedScrew screw = placed_screw(row);
  if (screw.degrees > 0)
    text += fmt::format("  turn {:.6g} degrees about the axis {} through {}, slide {:.6g} along it\n", screw.degrees,
                        text_of(screw.axis), text_of(screw.point), screw.slide);
  else
    text += fmt::format("  move {:.6g} along {}\n", screw.slide, text_of(screw.axis));
  text += "  placement after it, rows of the matrix (rotation, translation):\n";
  for (int r = 0; r < 3; ++r)
    text +=
        fmt::format("    {:12.9f} {:12.9f} {:12.9f}  {:.9g}\n", answer.placement.rotation(r, 0),
                    answer.placement.rotation(r, 1), answer.placement.rotation(r, 2), answer.placement.translation[r]);
  text += fmt::format("  {} contact point{}:\n", answer.contacts.size(), answer.contacts.size() == 1 ? "" : "s");
  constexpr std::size_t most_listed = 8;
  for (std::size_t k = 0; k < answer.contacts.size() && k < most_listed; ++k)
    text += fmt::format("    {} normal {}\n", text_of(answer.contacts[k].point), text_of(answer.contacts[k].normal));
  if (answer.contacts.size() > most_listed) text += "    ...\n";
  return text + fmt::format("  {} walks, {} steps, {} collision queries, {:.3g} ms\n", answer.walks, answer.steps,
                            answer.queries, 1e3 * row.seconds);
}

std::string csv_header() {
  return "pose,a,b,metric,overlap,found,depth,bound,distance,axis_x,axis_y,axis_z,point_x,point_y,point_z,degrees,"
         "slide,"
         "x,y,z,qw,qx,qy,qz,contacts,walks,steps,queries,time_ms\n";
}

std::string csv_row(const DepthRow& row) {
  const depth::Answer& answer = row.answer;
  const PlacedScrew screw = placed_screw(row);
  const Eigen::Quaterniond turn(answer.placement.rotation);
  const Vec3& x = answer.placement.translation;
  return fmt::format("{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{:.3f}\n",
                     row.pose, row.a, row.b, name_of(row.metric), answer.overlap ? 1 : 0, answer.found ? 1 : 0,
                     answer.depth, answer.bound, answer.distance, screw.axis[0], screw.axis[1], screw.axis[2],
                     screw.point[0], screw.point[1], screw.point[2], screw.degrees, screw.slide, x[0], x[1], x[2],
                     turn.w(), turn.x(), turn.y(), turn.z(), answer.contacts.size(), answer.walks, answer.steps,
                     answer.queries, 1e3 * row.seconds);
}

nlohmann::ordered_json as_json(const DepthRow& row) {
  const depth::Answer& answer = row.answer;
  nlohmann::ordered_json json;
  json["pose"] = row.pose;
  json["a"] = row.a;
  json["b"] = row.b;
  json["metric"] = name_of(row.metric);
  json["overlap"] = answer.overlap;
  json["depth"] = answer.depth;
  json["bound"] = answer.bound;
  json["distance"] = answer.distance;
  json["found"] = answer.found;
  if (answer.overlap && answer.found) {
    const PlacedScrew screw = placed_screw(row);
    json["screw"] = {
        {"axis", list(screw.axis)}, {"point", list(screw.point)}, {"degrees", screw.degrees}, {"slide", screw.slide}};
    json["placement"] = matrix(answer.placement);
    json["contacts"] = nlohmann::ordered_json::array();
    for (const depth::ContactPoint& contact : answer.contacts)
      json["contacts"].push_back(
          {{"point", list(contact.point)}, {"normal", list(contact.normal)}, {"gap", contact.gap}});
  }
  json["walks"] = answer.walks;
  json["steps"] = answer.steps;
  json["queries"] = answer.queries;
  json["time_s"] = row.seconds;
  return json;
}

}  // namespace brunt::app
