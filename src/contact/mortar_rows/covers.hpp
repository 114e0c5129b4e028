// SPDX-License-Identifier: Apache-2.0
// What the faces of other bodies cover of a slave facet: segments and multiplier functions (contact/mortar), for one
// set of positions. Each facet is integrated once, however many of its nodes ask.
#pragma once
#include <span>
#include <vector>

#include "contact/data/constraint.hpp"
#include "contact/data/standard_tolerances.hpp"
#include "contact/detection/detection.hpp"
#include "contact/mortar/weights.hpp"
#include "contact/mortar_rows/candidates.hpp"

namespace brunt::contact {

struct MortarScene {
  const MortarCandidates& candidates;
  std::span<const MasterFace> faces;
  std::span<const GlobalIndex> gid;    ///< of contact nodes
  std::span<const NodeMotion> motion;  ///< likewise
  const Tolerances& tolerances;
  std::span<const AcceptedOverlap> accepted{};
};

/// Of one body on one slave facet.
struct Cover {
  std::int32_t body = 0, block = 0;  ///< block: the lowest one of the faces
  bool smooth =
      true;  ///< the faces look against the facet and along each other: otherwise nodes of it have no mortar row
  MultiplierFunctions functions;
  LocalIndex first = 0, end = 0;  ///< segments
};

struct CoverSegment {
  LocalIndex face = 0;  ///< of the master
  SegmentIntegrals integrals;
};

class FacetCovers {
 public:
  /// Forgets everything.
  void start(std::size_t facets);
  /// By body. Valid until the next call.
  std::span<const Cover> of(const MortarScene& scene, LocalIndex facet);
  [[nodiscard]] std::span<const CoverSegment> segments(const Cover& cover) const;
  /// Whether nodes of the facet may have a row: a master that looks against it comes so near that they may share a
  /// segment.
  bool may_begin(const MortarScene& scene, LocalIndex facet);

 private:
  void find(const MortarScene& scene, LocalIndex facet);
  void add_segment(const MortarScene& scene, const SlavePlane& plane, double capture, LocalIndex face);
  void close_cover(const SlavePlane& plane);

  enum class Nearness : char { unknown, may_begin, near, far };
  Nearness nearness_of(const MortarScene& scene, LocalIndex facet) const;
  Nearness look(const MortarScene& scene, LocalIndex facet);

  std::vector<Nearness> near_;
  std::vector<LocalIndex> first_, end_;  ///< of covers_, of each facet; no_index: not yet found
  std::vector<Cover> covers_;
  std::vector<CoverSegment> segments_;
  std::vector<SegmentIntegrals> integrals_;  ///< of the cover in hand
  Vec3 first_normal_ = Vec3::Zero();         ///< of its first master
};

/// Corners of a facet or face at t_n.
struct CornersNow {
  std::array<Vec3, 4> point;
  std::size_t count = 0;
  template <class Face>
  CornersNow(const Face& face, std::span<const NodeMotion> motion)
      : count(static_cast<std::size_t>(face.corner_count)) {
    for (std::size_t i = 0; i < count; ++i) point[i] = nth(motion, face.nodes[i]).position;
  }
  [[nodiscard]] std::span<const Vec3> span() const { return {point.data(), count}; }
};

}  // namespace brunt::contact
