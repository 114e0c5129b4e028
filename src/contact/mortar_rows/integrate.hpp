// SPDX-License-Identifier: Apache-2.0
// The weights of the mortar rows of one slave node, from what is covered of the facets around it.
#pragma once
#include <span>
#include <vector>

#include "contact/data/mortar_history.hpp"
#include "contact/mortar_rows/covers.hpp"

namespace brunt::contact {

/// Arrays of one node, kept between nodes.
class NodeIntegration {
 public:
  /// Appends the rows of slave s, and where the points and facets of their terms are: contact nodes, facets. before:
  /// its rows until now, whose slip is taken over.
  void append(const MortarScene& scene, std::size_t s, FacetCovers& covers, std::span<const MortarHead> before,
              MortarHistory& after, std::vector<LocalIndex>& places);

 private:
  struct Group {  ///< facets of one smooth part of the node's surface
    std::int32_t body = 0, block = 0;
    Vec3 normal = Vec3::Zero();  ///< of its first facet
    double area = 0, size = 0;
    bool whole = true;
    std::vector<LocalIndex> points, facets;
    std::vector<MortarTerm> at_points, at_facets;
  };

  void collect(const MortarScene& scene, std::size_t s, FacetCovers& covers, bool dual);
  void add_cover(const MortarScene& scene, LocalIndex node, LocalIndex facet, const Cover& cover,
                 const FacetCovers& covers, bool dual);
  Group& group_of(std::int32_t body, const Vec3& normal, double facing);
  [[nodiscard]] bool is_bent(std::int32_t body) const;
  [[nodiscard]] double largest_weight() const;
  void close(const MortarScene& scene, LocalIndex node, const Group& group, GlobalIndex number,
             std::span<const MortarHead> before, MortarHistory& after, std::vector<LocalIndex>& places);

  std::vector<Group> groups_;
  std::size_t group_count_ = 0;     ///< in use; the others keep their memory
  std::vector<std::int32_t> bent_;  ///< bodies with a cover that is not smooth
  std::vector<std::size_t> order_;  ///< of the points of a group
  std::vector<MortarTerm> terms_;   ///< of a row
};

/// The sum of weights and positions of a row [length].
Vec3 sum_of_places(std::span<const MortarTerm> terms, std::span<const LocalIndex> places,
                   std::span<const NodeMotion> motion);

}  // namespace brunt::contact
