// SPDX-License-Identifier: Apache-2.0
// The numbers of contact, of which an experiment may set some: BRUNT_TOLERANCES="name=value,name=value" in the
// environment of a test (see tests/hard/sweep_tolerances.py).
#pragma once
#include <algorithm>
#include <array>
#include <cstdlib>
#include <sstream>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>

#include "contact/data/tolerances.hpp"

namespace brunt::test {

using contact::Tolerances;

constexpr std::array<std::pair<std::string_view, double Tolerances::*>, 29> tolerance_fields{{
    {"same_direction", &Tolerances::same_direction},
    {"aligned", &Tolerances::aligned},
    {"facing", &Tolerances::facing},
    {"slight", &Tolerances::slight},
    {"competing", &Tolerances::competing},
    {"warp", &Tolerances::warp},
    {"facet_curvature", &Tolerances::facet_curvature},
    {"parallel", &Tolerances::parallel},
    {"kink", &Tolerances::kink},
    {"blunt_angle", &Tolerances::blunt_angle},
    {"capture", &Tolerances::capture},
    {"element_share", &Tolerances::element_share},
    {"rim", &Tolerances::rim},
    {"slow", &Tolerances::slow},
    {"coincidence", &Tolerances::coincidence},
    {"touching", &Tolerances::touching},
    {"ledge", &Tolerances::ledge},
    {"seam_reach", &Tolerances::seam_reach},
    {"seam_sample", &Tolerances::seam_sample},
    {"recovery", &Tolerances::recovery},
    {"recovery_limit", &Tolerances::recovery_limit},
    {"recovery_time", &Tolerances::recovery_time},
    {"drift", &Tolerances::drift},
    {"rounding", &Tolerances::rounding},
    {"fine_rounding", &Tolerances::fine_rounding},
    {"equal_figures", &Tolerances::equal_figures},
    {"similar_edges", &Tolerances::similar_edges},
    {"coarse_slave", &Tolerances::coarse_slave},
    {"kept_volume", &Tolerances::kept_volume},
}};
static_assert(sizeof(Tolerances) == tolerance_fields.size() * sizeof(double), "every number has its name here");

/// Of "name=value,name=value". Throws where a name is unknown or a value is no number.
inline Tolerances tolerances_from(const std::string& text) {
  Tolerances tolerances;
  std::istringstream entries(text);
  for (std::string entry; std::getline(entries, entry, ',');) {
    const std::size_t equals = entry.find('=');
    const std::string_view name = std::string_view(entry).substr(0, equals);
    const auto* const field =
        std::ranges::find(tolerance_fields, name, &std::pair<std::string_view, double Tolerances::*>::first);
    if (equals == std::string::npos || field == tolerance_fields.end())
      throw std::invalid_argument("BRUNT_TOLERANCES: unknown name in '" + entry + "'; expected name=value");
    tolerances.*(field->second) = std::stod(entry.substr(equals + 1));
  }
  return tolerances;
}

/// Of the environment, the same for all of a run.
inline const Tolerances& tolerances() {
  const char* const text = std::getenv("BRUNT_TOLERANCES");
  static const Tolerances chosen = tolerances_from(text == nullptr ? "" : text);
  return chosen;
}

}  // namespace brunt::test
