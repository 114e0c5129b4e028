// SPDX-License-Identifier: Apache-2.0
#include "brunt/scene/places.hpp"

#include <fmt/format.h>

namespace brunt::scene {

std::string Places::name(std::string_view path, const std::string& file) const {
  for (std::string_view known = path; !known.empty();) {
    if (const auto found = places_.find(known); found != places_.end()) {
      const Place& place = found->second;
      return place.line > 0 ? fmt::format("{}:{}: {}", place.source, place.line, path)
                            : fmt::format("{}: {}", place.source, path);
    }
    const std::size_t dot = known.rfind('.');
    known = dot == std::string_view::npos ? std::string_view{} : known.substr(0, dot);
  }
  return fmt::format("{}: {}", file, path);
}

}  // namespace brunt::scene
