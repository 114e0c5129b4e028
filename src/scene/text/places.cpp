// SPDX-License-Identifier: Apache-2.0
#include "scene/text/places.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "core/excerpt.hpp"

namespace brunt::scene {

std::string shown_path(std::string_view path) {
  std::string shown;
  for (std::size_t from = 0; from <= path.size();) {
    const std::size_t dot = std::min(path.find('.', from), path.size());
    if (from > 0) shown += '.';
    shown += excerpt(path.substr(from, dot - from));
    from = dot + 1;
  }
  return shown;
}

std::string Places::name(std::string_view path, const std::string& file) const {
  for (std::string_view known = path; !known.empty();) {
    if (const auto found = places_.find(known); found != places_.end()) {
      const Place& place = found->second;
      return place.line > 0 ? fmt::format("{}:{}: {}", place.source, place.line, shown_path(path))
                            : fmt::format("{}: {}", place.source, shown_path(path));
    }
    const std::size_t dot = known.rfind('.');
    known = dot == std::string_view::npos ? std::string_view{} : known.substr(0, dot);
  }
  return fmt::format("{}: {}", file, shown_path(path));
}

}  // namespace brunt::scene
