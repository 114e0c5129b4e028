// SPDX-License-Identifier: Apache-2.0
#include "mortar_shares.hpp"

#include <algorithm>

#include "core/sorted.hpp"
#include "self_sides.hpp"

namespace brunt::implicit {
namespace {

using contact::FacetNodes;

/// The nodes that this rank keeps throughout.
class Kept {
 public:
  explicit Kept(std::size_t nodes) : keeps_(nodes, 0), place_(nodes, no_index) {}
  void keep(LocalIndex node) {
    if (node != no_index) nth(keeps_, node) = 1;
  }
  void keep(const FacetNodes& facet) {
    for (const LocalIndex node : facet) keep(node);
  }
  /// Places in the whole surfaces, ascending; required before `place`.
  std::vector<std::size_t> list() {
    std::vector<std::size_t> nodes;
    for (std::size_t node = 0; node < keeps_.size(); ++node) {
      if (keeps_[node] == 0) continue;
      place_[node] = static_cast<LocalIndex>(nodes.size());
      nodes.push_back(node);
    }
    return nodes;
  }
  [[nodiscard]] LocalIndex place(LocalIndex node) const { return node == no_index ? no_index : nth(place_, node); }
  [[nodiscard]] FacetNodes place(const FacetNodes& facet) const {
    return {place(facet[0]), place(facet[1]), place(facet[2]), place(facet[3])};
  }

 private:
  std::vector<char> keeps_;
  std::vector<LocalIndex> place_;
};

/// The part of one interface on a rank: numbers of rows and slave facets of the whole.
struct Part {
  std::vector<std::size_t> rows, facets;
  std::vector<std::uint8_t> ours;        ///< of `facets`
  std::vector<std::size_t> rows_beside;  ///< rows whose tractions the patches of its own facets need
};

Rank owner_of(const WholeSurfaces& whole, LocalIndex node) {
  return nth(whole.nodes, node).owner;
}

/// A facet belongs to the owner of its first node in canonical order.
Rank owner_of(const WholeSurfaces& whole, const FacetNodes& facet) {
  LocalIndex first = facet[0];
  for (const LocalIndex node : facet)
    if (node != no_index) first = std::min(first, node);
  return owner_of(whole, first);
}

Part part_of(Rank rank, const WholeSurfaces& whole, const Interface& face) {
  Part part;
  for (std::size_t row = 0; row < face.count(); ++row)
    if (owner_of(whole, face.surfaces.rows[row]) == rank) part.rows.push_back(row);
  for (std::size_t facet = 0; facet < face.surfaces.slave.size(); ++facet) {
    const FacetNodes& nodes = face.surfaces.slave[facet];
    if (std::ranges::none_of(nodes, [&](LocalIndex n) { return n != no_index && owner_of(whole, n) == rank; }))
      continue;
    part.facets.push_back(facet);
    part.ours.push_back(owner_of(whole, nodes) == rank ? 1 : 0);
    for (std::size_t a = 0; a < nodes.size() && part.ours.back() != 0; ++a) {
      const LocalIndex row = face.topology.row_of_corner[facet][a];
      if (row != no_index && owner_of(whole, nodes[a]) != rank)
        part.rows_beside.push_back(static_cast<std::size_t>(row));
    }
  }
  sort_unique(part.rows_beside);
  return part;
}

void keep_nodes(Rank rank, const WholeSurfaces& whole, const WholeInterface& of, const Part& part, Kept& kept) {
  const auto of_side = [&](const WholeSide& side, bool all) {
    for (std::size_t facet = 0; facet < side.facets.size(); ++facet)
      for (const LocalIndex node : side.facets[facet])
        if (node != no_index && ((all && side.rank[facet] == rank) || owner_of(whole, node) == rank)) kept.keep(node);
  };
  of_side(of.slave, false);
  of_side(of.master, true);
  for (const std::size_t facet : part.facets) kept.keep(of.slave.facets[facet]);
  if (!of.face.pair.tied) return;
  for (const std::size_t row : part.rows) {
    for (const LocalIndex node : of.face.start.tie.weights.nodes.row(static_cast<LocalIndex>(row))) kept.keep(node);
    kept.keep(of.face.start.tie.below[row].nodes);
  }
}

/// Maps rows of all ranks to all rows in order, and to the rows beside.
void link_rows(const comm::Communicator& ranks, const WholeSurfaces& whole, const Interface& all, const Part& part,
               Interface& face) {
  std::vector<comm::RemoteSlot> source, beside;
  std::vector<LocalIndex> count(static_cast<std::size_t>(ranks.size()), 0);
  for (const LocalIndex node : all.surfaces.rows) {
    const Rank owner = owner_of(whole, node);
    source.push_back({owner, nth(count, owner)++});
  }
  for (const std::size_t row : part.rows_beside) beside.push_back(source[row]);
  face.numbering.rows_of_all = all.count();
  for (const std::size_t row : part.rows) face.numbering.place.push_back(static_cast<LocalIndex>(row));
  const auto rows = static_cast<LocalIndex>(part.rows.size());
  face.numbering.to_all = comm::Halo(ranks, rows, source);
  face.numbering.beside = comm::Halo(ranks, rows, beside);
}

/// The rows of the corners of its facets, in the numbers of this rank: its own, then those beside.
std::vector<FacetNodes> corner_rows_of(const Interface& all, const Part& part) {
  std::vector<LocalIndex> number(all.count(), no_index);
  LocalIndex next = 0;
  for (const std::vector<std::size_t>* rows : {&part.rows, &part.rows_beside})
    for (const std::size_t row : *rows) number[row] = next++;
  std::vector<FacetNodes> of_corner;
  for (const std::size_t facet : part.facets) {
    FacetNodes& rows = of_corner.emplace_back(all.topology.row_of_corner[facet]);
    for (LocalIndex& row : rows)
      if (row != no_index) row = nth(number, row);
  }
  return of_corner;
}

void lay_surfaces(Rank rank, const WholeInterface& of, const Part& part, const Kept& kept, Interface& face) {
  const contact::MortarSurfaces& all = of.face.surfaces;
  contact::MortarSurfaces& mine = face.surfaces;
  mine.multiplier = all.multiplier;
  mine.capture = all.capture;
  mine.fading = all.fading;
  mine.ours = part.ours;
  for (const std::size_t facet : part.facets) {
    mine.slave.push_back(kept.place(all.slave[facet]));
    mine.slave_wall.push_back(all.slave_wall[facet]);
    if (!all.at_edge.empty()) mine.at_edge.push_back(all.at_edge[facet]);
    face.slave_key.push_back(of.slave.key[facet]);
  }
  for (const std::size_t row : part.rows) {
    mine.rows.push_back(kept.place(all.rows[row]));
    const auto mirrors = all.mirrors.row(static_cast<LocalIndex>(row));
    mine.mirrors.values.insert(mine.mirrors.values.end(), mirrors.begin(), mirrors.end());
    mine.mirrors.close_row();
  }
  for (const std::size_t row : part.rows_beside) mine.rows_elsewhere.push_back(kept.place(all.rows[row]));
  mine.corner_rows = corner_rows_of(of.face, part);
  for (std::size_t facet = 0; facet < all.master.size() && !face.pair.tied; ++facet) {
    if (of.master.rank[facet] != rank) continue;
    face.own_masters.key.push_back(of.master.key[facet]);
    face.own_masters.nodes.push_back(kept.place(all.master[facet]));
    face.own_masters.wall.push_back(all.master_wall[facet]);
    if (face.of_points) face.own_masters.patch.push_back(of.master_patch[facet]);
  }
}

void lay_tie(const Interface& all, const Part& part, const Kept& kept, Interface& face) {
  for (const std::size_t row : part.rows) {
    const auto index = static_cast<LocalIndex>(row);
    for (const LocalIndex node : all.start.tie.weights.nodes.row(index))
      face.start.tie.weights.nodes.values.push_back(kept.place(node));
    face.start.tie.weights.nodes.close_row();
    const std::span<const double> weights = all.start.tie.weights.row(index);
    face.start.tie.weights.blocks.insert(face.start.tie.weights.blocks.end(), weights.begin(), weights.end());
    face.start.tie.covered.push_back(all.start.tie.covered[row]);
    face.start.tie.below.push_back({kept.place(all.start.tie.below[row].nodes), all.start.tie.below[row].weights});
  }
  for (const std::size_t facet : part.facets) face.start.tie.heights.push_back(all.start.tie.heights[facet]);
  face.start.tie.apart = all.start.tie.apart;
}

void lay_nodes(const comm::Communicator& ranks, const model::Model& model, const Unknowns& unknowns,
               const WholeSurfaces& whole, const std::vector<std::size_t>& kept,
               const std::vector<std::uint8_t>& several, ContactNodes& nodes) {
  nodes.lasting = kept.size();
  for (const std::size_t k : kept) {
    const NodeRecord& record = whole.nodes[k];
    nodes.gid.push_back(record.gid);
    nodes.source.push_back({record.owner, record.node});
    LocalIndex own = no_index;
    if (record.owner == ranks.rank())
      own = static_cast<LocalIndex>(std::ranges::lower_bound(unknowns.node, record.node) - unknowns.node.begin());
    nodes.own.push_back(own);
    nodes.free.push_back(whole.free[k]);
    nodes.several.push_back(several[k]);
    nodes.x.push_back(whole.reference[k]);
  }
  nodes.gather = comm::Halo(ranks, model.nodes(), nodes.source);
  nodes.rows = nodes.movable = nodes.free;
  nodes.reference = nodes.x_before = nodes.x_told = nodes.x;
  nodes.force.assign(nodes.lasting, Vec3::Zero());
  nodes.friction_force = nodes.force;
}

/// A flag for each node: whether surfaces of several pairs with multipliers contain it, or that of a part in contact
/// with itself, whose nodes may belong to its slave and its master.
std::vector<std::uint8_t> nodes_of_several(const WholeSurfaces& whole, const std::vector<WholeInterface>& interfaces) {
  std::vector<std::uint8_t> several(whole.nodes.size(), 0);
  std::vector<std::int32_t> seen(whole.nodes.size(), -1);
  for (std::size_t k = 0; k < interfaces.size(); ++k) {
    if (!interfaces[k].face.is_exact()) continue;
    const auto pair = static_cast<std::int32_t>(interfaces[k].face.of_pair);
    for (const WholeSide* side : {&interfaces[k].slave, &interfaces[k].master})
      for (const FacetNodes& facet : side->facets)
        for (const LocalIndex place : facet) {
          if (place == no_index) continue;
          const auto node = static_cast<std::size_t>(place);
          if (interfaces[k].face.self || (seen[node] >= 0 && seen[node] != pair)) several[node] = 1;
          seen[node] = pair;
        }
  }
  return several;
}

bool has_supports(const WholeSurfaces& whole, const std::vector<LocalIndex>& nodes) {
  return std::ranges::any_of(nodes, [&](LocalIndex node) { return !nth(whole.free, node).isIdentity(0); });
}

/// Whether a node has several rows, which are in ascending order of nodes.
bool has_several(const std::vector<LocalIndex>& rows) {
  return std::ranges::adjacent_find(rows) != rows.end();
}

/// The part of `of` on this rank, with nodes as places of the kept ones.
Interface interface_of(const comm::Communicator& ranks, const WholeSurfaces& whole, const WholeInterface& of,
                       const Part& part, const Kept& kept, std::span<const Vec3> reference) {
  Interface face;
  face.pair = of.face.pair;
  face.of_pair = of.face.of_pair;
  face.first_of_pair = of.face.first_of_pair;
  face.of_points = of.face.of_points;
  face.stiffness = of.face.stiffness;
  face.friction = of.face.friction;
  face.scratch = contact::make_mortar_scratch();
  link_rows(ranks, whole, of.face, part, face);
  lay_surfaces(ranks.rank(), of, part, kept, face);
  face.topology = contact::make_topology(face.surfaces, reference);
  face.topology.edge = of.face.topology.edge;
  if (face.pair.tied) lay_tie(of.face, part, kept, face);
  if (of.face.self) {
    face.self = of.face.self;
    share_self(of.slave.facets, whole.reference, part.facets, *face.self);
  }
  if (face.pair.tied && ranks.is_root()) {  // initial rows: counted once
    face.iterate.rows.segments = of.face.iterate.rows.segments;
    face.search.counts = of.face.search.counts;
  }
  const std::size_t n = face.count();
  face.iterate.z.assign(n * (face.pair.tied ? 3 : 1), 0.0);
  face.iterate.active.assign(n, 0);
  face.iterate.tractions.assign(n, Vec3::Zero());
  face.start.touches.assign(n, 0);
  return face;
}

}  // namespace

LocalIndex ContactNodes::place_of(GlobalIndex node) const {
  const auto middle = gid.begin() + static_cast<std::ptrdiff_t>(lasting);
  auto at = std::lower_bound(gid.begin(), middle, node);
  if (at != middle && *at == node) return static_cast<LocalIndex>(at - gid.begin());
  at = std::lower_bound(middle, gid.end(), node);
  return at != gid.end() && *at == node ? static_cast<LocalIndex>(at - gid.begin()) : no_index;
}

void share_out(const comm::Communicator& ranks, const model::Model& model, const Unknowns& unknowns,
               const WholeSurfaces& whole, std::vector<WholeInterface> interfaces, MortarContact& contact) {
  std::vector<Part> parts;
  Kept kept(whole.nodes.size());
  for (const WholeInterface& of : interfaces) {
    parts.push_back(part_of(ranks.rank(), whole, of.face));
    keep_nodes(ranks.rank(), whole, of, parts.back(), kept);
  }
  const std::vector<std::uint8_t> several = nodes_of_several(whole, interfaces);
  lay_nodes(ranks, model, unknowns, whole, kept.list(), several, contact.nodes);
  contact.shares_nodes = std::ranges::count(several, std::uint8_t{1}) > 0;
  contact.may_imply = contact.shares_nodes || std::ranges::any_of(interfaces, [&](const WholeInterface& of) {
                        return of.face.is_exact() && (has_supports(whole, of.face.surfaces.rows) ||
                                                      !of.face.first_of_pair || has_several(of.face.surfaces.rows));
                      });
  for (std::size_t k = 0; k < interfaces.size(); ++k)
    contact.interfaces.push_back(interface_of(ranks, whole, interfaces[k], parts[k], kept, contact.nodes.x));
  tell_masters(ranks, contact);
}

std::vector<double> told_to_all(const Interface& face, std::span<const double> of_rows, int width) {
  std::vector<double> all(face.numbering.rows_of_all * static_cast<std::size_t>(width));
  face.numbering.to_all.forward(of_rows, all, width);
  return all;
}

}  // namespace brunt::implicit
