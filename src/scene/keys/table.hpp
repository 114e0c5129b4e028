// SPDX-License-Identifier: Apache-2.0
// The keys of a map as a table: one row a key. A map is read by its table, and the reference is written from it.
#pragma once
#include <algorithm>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "scene/keys/described.hpp"
#include "scene/keys/phrase.hpp"
#include "scene/text/reader.hpp"

namespace brunt::scene {

/// How a value is read into an object of type T, and what is said of it.
template <class T>
struct Value {
  std::string type{};
  std::function<void(const Key&, T&)> read{};
  std::function<std::string(const T&)> shown{};  ///< the value that the object has; empty: none
  std::vector<const Described*> inner{};         ///< tables of the maps in it
};

/// A member that is read by `how`: a Range, Count, Choices, Named, Vector, Text or Each; nothing for a bool.
template <class T, class M, class... How>
Value<T> value(M T::*member, How... how) {
  return {.type = phrase(M{}, how...),
          .read = [=](const Key& key, T& target) { read(key, target.*member, how...); },
          .shown = [=](const T& target) { return shown(target.*member, how...); }};
}

/// Likewise a member that T inherits.
template <class T, class M, class Base, class... How>
Value<T> inherited(M Base::*member, How... how) {
  return value(static_cast<M T::*>(member), how...);
}

/// A value with a reader of its own. `read` meets a missing key (`key.tree` is null) only if the key is required.
template <class T>
Value<T> special(const std::string& type, void (*read)(const Key&, T&),
                 const std::vector<const Described*>& inner = {}) {
  return {.type = type, .read = read, .inner = inner};
}

/// The kinds or models that have a key.
struct Of {
  std::vector<std::string> names;
};
template <class... Name>
Of of(Name... names) {
  return {{names...}};
}

/// Default of a key that must be given.
constexpr const char* required = "required";

template <class T>
struct Row {
  /// fallback: what the reference says of a missing key, if it is not the value of the member.
  Row(std::string name, Value<T> how, std::string dimension, std::string sentence, std::string missing = "")
      : Row(std::move(name), {}, std::move(how), std::move(dimension), std::move(sentence), std::move(missing)) {}
  Row(std::string name, Of kinds, Value<T> how, std::string dimension, std::string sentence, std::string missing = "")
      : value(std::move(how)), said{std::move(name),      std::move(kinds.names), value.type,
                                    std::move(dimension), std::move(missing),     std::move(sentence)} {}

  [[nodiscard]] bool is_of(std::string_view kind) const {
    return said.of.empty() || std::find(said.of.begin(), said.of.end(), kind) != said.of.end();
  }

  Value<T> value;
  Said said;
};

/// A key that only has a message: it is refused, and the reference does not list it.
template <class T>
Row<T> refused(std::string name, Of kinds, void (*refuse)(const Key&, T&)) {
  return {std::move(name), std::move(kinds), special<T>("", refuse), "", ""};
}

/// The same key for an object that has the object of the row as a member.
template <class Whole, class T>
Row<Whole> within(T Whole::*member, const Row<T>& row) {
  const auto shown = row.value.shown;
  Value<Whole> value{.type = row.value.type,
                     .read = [=, read = row.value.read](const Key& key, Whole& whole) { read(key, whole.*member); },
                     .inner = row.value.inner};
  if (shown) value.shown = [=](const Whole& whole) { return shown(whole.*member); };
  const Said& said = row.said;
  return {said.key, Of{said.of}, std::move(value), said.unit, said.meaning, said.fallback};
}

template <class Whole, class T>
std::vector<Row<Whole>> within(T Whole::*member, const std::vector<Row<T>>& rows) {
  std::vector<Row<Whole>> all;
  all.reserve(rows.size());
  for (const Row<T>& row : rows) all.push_back(within(member, row));
  return all;
}

/// The rows of two tables, one after the other.
template <class T>
std::vector<Row<T>> joined(std::vector<Row<T>> first, const std::vector<Row<T>>& second) {
  first.insert(first.end(), second.begin(), second.end());
  return first;
}

template <class T>
class Table : public Described {
 public:
  /// Judges keys that depend on each other, and completes the object; after all rows have been read.
  using Judge = void (*)(const Key& map, T& target);
  /// The kind or model of an object, for the column `of`; empty as long as it is unknown.
  using Kind = std::string_view (*)(const T& target);

  /// expected: what messages expect where no map is given.
  Table(const std::string& map, std::string expected, std::vector<Row<T>> keys, Judge judge = nullptr,
        Kind kind = nullptr)
      : expected_(std::move(expected)), keys_(std::move(keys)), judge_(judge), kind_(kind) {
    name = map;
    const T missing{};
    for (Row<T>& row : keys_) {
      if (row.said.fallback.empty()) row.said.fallback = row.value.shown ? row.value.shown(missing) : "none";
      if (!row.said.meaning.empty()) Described::rows.push_back(row.said);
      inner.insert(inner.end(), row.value.inner.begin(), row.value.inner.end());
    }
  }

  [[nodiscard]] const std::string& expected() const { return expected_; }
  /// Reads every row of the object's kind, judges, and refuses other keys. False, with a fault, for anything but a map.
  bool read(const Key& map, T& target) const {
    if (!is_map(map)) return wrong(map, expected_);
    for (const Row<T>& row : keys_) {
      if (!row.is_of(kind_of(target))) continue;
      const Key key = at(map, row.said.key);
      if (key.tree != nullptr || row.said.fallback == required) row.value.read(key, target);
    }
    if (judge_ != nullptr) judge_(map, target);
    if (kind_ == nullptr || !kind_of(target).empty()) refuse_others(map, kind_of(target));
    return true;
  }

 private:
  [[nodiscard]] std::string_view kind_of(const T& target) const { return kind_ == nullptr ? "" : kind_(target); }

  void refuse_others(const Key& map, std::string_view kind) const {
    std::vector<std::string> known, silent;
    for (const Row<T>& row : keys_)
      if (row.is_of(kind)) (row.said.meaning.empty() ? silent : known).push_back(row.said.key);
    refuse_unknown(map, known, silent);
  }

  std::string expected_;
  std::vector<Row<T>> keys_;
  Judge judge_;
  Kind kind_;
};

/// A map with a table of its own.
template <class T, class M>
Value<T> map_of(M T::*member, const Table<M>& table) {
  return {.type = "map",
          .read = [member, &table](const Key& key, T& target) { table.read(key, target.*member); },
          .inner = {&table}};
}
template <class T, class M>
Value<T> map_of(std::optional<M> T::*member, const Table<M>& table) {
  return {.type = "map",
          .read =
              [member, &table](const Key& key, T& target) {
                if (M object{}; table.read(key, object)) target.*member = std::move(object);
              },
          .inner = {&table}};
}
/// A map whose keys are members of the same object.
template <class T>
Value<T> map_of(const Table<T>& table) {
  return {.type = "map", .read = [&table](const Key& key, T& target) { table.read(key, target); }, .inner = {&table}};
}

/// A list of maps.
template <class T, class M>
Value<T> list_of(std::vector<M> T::*member, const Table<M>& table) {
  return {.type = "list",
          .read =
              [=, &table](const Key& key, T& target) {
                for (const Key& entry : items(key, "a list of " + table.expected()))
                  if (M object{}; table.read(entry, object)) (target.*member).push_back(std::move(object));
              },
          .inner = {&table}};
}

}  // namespace brunt::scene
