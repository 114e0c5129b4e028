// SPDX-License-Identifier: Apache-2.0
#include "depth_report.hpp"

#include <fmt/format.h>

#include "app/program/depth_options.hpp"

namespace brunt::app {
namespace {

constexpr const char* unproven = "not proven: a surface crosses itself";

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

nlohmann::ordered_json json_of(const DepthRow& row, const PlacedScrew& screw, std::size_t contacts) {
  const depth::Answer& answer = row.answer;
  nlohmann::ordered_json json;
  json["pose"] = row.pose;
  json["a"] = row.a;
  json["b"] = row.b;
  json["metric"] = name_of(row.metric);
  json["overlap"] = answer.overlap;
  json["depth"] = answer.depth;
  json["bound"] = answer.bound;
  json["proven"] = answer.proven;
  json["distance"] = answer.distance;
  json["overlaps"] = answer.overlaps;
  json["found"] = answer.found;
  if (answer.overlap && answer.found) {
    json["screw"] = {
        {"axis", list(screw.axis)}, {"point", list(screw.point)}, {"degrees", screw.degrees}, {"slide", screw.slide}};
    json["placement"] = matrix(answer.placement);
    json["contact_count"] = contacts;
  }
  json["walks"] = answer.walks;
  json["steps"] = answer.steps;
  json["queries"] = answer.queries;
  json["time_s"] = row.seconds;
  return json;
}

}  // namespace

std::string described(const DepthRow& row) {
  const depth::Answer& answer = row.answer;
  if (!answer.overlap) return fmt::format("{} and {} do not overlap: distance {:.6g}\n", row.a, row.b, answer.distance);
  std::string text = fmt::format("{} in {}, {}: ", row.a, row.b, name_of(row.metric));
  if (!answer.found)
    return text +
           (answer.proven
                ? fmt::format("no admissible motion separates them; none shorter than {:.6g} exists\n", answer.bound)
                : fmt::format("no admissible motion was found that separates them; bound {:.6g} ({})\n", answer.bound,
                              unproven));
  text += fmt::format("depth {:.9g}, bound {:.6g} ({})\n", answer.depth, answer.bound,
                      answer.proven ? "no motion shorter than it separates them" : unproven);
  const PlacedScrew screw = placed_screw(row);
  if (screw.degrees > 0)
    text += fmt::format("  turn {:.6g} degrees about the axis {} through {}, slide {:.6g} along it\n", screw.degrees,
                        text_of(screw.axis), text_of(screw.point), screw.slide);
  else
    text += fmt::format("  move {:.6g} along {}\n", screw.slide, text_of(screw.axis));
  text += "  placement after the motion, rows of the matrix (rotation, translation):\n";
  for (int r = 0; r < 3; ++r)
    text +=
        fmt::format("    {:12.9f} {:12.9f} {:12.9f}  {:.9g}\n", answer.placement.rotation(r, 0),
                    answer.placement.rotation(r, 1), answer.placement.rotation(r, 2), answer.placement.translation[r]);
  text += fmt::format("  {} contact point{}:\n", answer.contacts.size(), answer.contacts.size() == 1 ? "" : "s");
  constexpr std::size_t most_listed = 8;
  for (std::size_t k = 0; k < answer.contacts.size() && k < most_listed; ++k)
    text += fmt::format("    {} normal {}\n", text_of(answer.contacts[k].point), text_of(answer.contacts[k].normal));
  if (answer.contacts.size() > most_listed) text += "    ...\n";
  return text + fmt::format("  {} descents, {} steps, {} collision queries, {:.3g} ms\n", answer.walks, answer.steps,
                            answer.queries, 1e3 * row.seconds);
}

std::string warning_of(const DepthRow& row, bool careful) {
  const depth::Answer& answer = row.answer;
  if (!far_above_overlaps(answer)) return {};
  return fmt::format(
      "warning: pose {}, {} in {}, {}: depth {:.6g} is more than the overlaps together, {:.6g}: a shorter motion may "
      "have been missed ({}{})\n",
      row.pose, row.a, row.b, name_of(row.metric), answer.depth, answer.overlaps,
      careful ? "the search with B moving may find it" : "--careful searches longer",
      answer.proven ? ", --certify proves" : "");
}

nlohmann::ordered_json as_json(const DepthRow& row) {
  nlohmann::ordered_json json = json_of(row, placed_screw(row), row.answer.contacts.size());
  if (!json.contains("contact_count")) return json;
  auto& contacts = json["contacts"] = nlohmann::ordered_json::array();
  for (const depth::ContactPoint& contact : row.answer.contacts)
    contacts.push_back({{"point", list(contact.point)}, {"normal", list(contact.normal)}, {"gap", contact.gap}});
  return json;
}

nlohmann::ordered_json as_json(const EarlierRow& earlier) {
  return json_of(earlier.row, earlier.screw, earlier.contacts);
}

}  // namespace brunt::app
