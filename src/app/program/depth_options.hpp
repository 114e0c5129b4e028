// SPDX-License-Identifier: Apache-2.0
// Options of `brunt depth`.
#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "depth/metric.hpp"

namespace brunt::app {

struct DepthOptions {
  std::string a, b;   ///< surface files; a alone: a scene
  std::string at;     ///< "x,y,z"
  std::string turn;   ///< "x,y,z,degrees"
  std::string poses;  ///< CSV file; empty: one pose
  std::vector<std::string> metrics = {"displacement"};
  std::string along;         ///< axes of admitted translations, "x,y"; empty: all
  std::string pieces;        ///< file of convex pieces
  std::string out;           ///< folder; empty: none
  double clearance = 0;      ///< left between the surfaces [length]
  double certify = 0;        ///< required (depth - bound) / depth; 0: no search
  std::int64_t boxes = 0;    ///< most boxes of that search; 0: the default
  double limit = 0;          ///< most time of that search a pose [s]; 0: none
  std::int64_t samples = 0;  ///< placements in contact, sampled once as starts of all poses; 0: none
  double merge = -1;         ///< tolerance of merged points [length]; < 0: of the format
  bool careful = false, sequence = false, json = false, force = false;
  std::vector<std::string> overrides;  ///< of a scene
};

[[nodiscard]] depth::Metric metric_named(const std::string& name);
[[nodiscard]] const char* name_of(depth::Metric metric);

}  // namespace brunt::app
