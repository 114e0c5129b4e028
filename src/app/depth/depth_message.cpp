// SPDX-License-Identifier: Apache-2.0
#include "depth_message.hpp"

#include <cstring>
#include <string>
#include <type_traits>

#include "core/error.hpp"

namespace brunt::app {
namespace {

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
    demand(at_ + sizeof value <= bytes_.size(), "a message contains what was packed into it");
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
  visit(row.least_turn);
  visit(row.seconds);
  auto& answer = row.answer;
  visit(answer.overlap);
  visit(answer.found);
  visit(answer.depth);
  visit(answer.bound);
  visit(answer.proven);
  visit(answer.distance);
  visit(answer.overlaps);
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

}  // namespace brunt::app
