// SPDX-License-Identifier: Apache-2.0
// The facets of masters that a rank needs, and their exchange.
#include <algorithm>
#include <array>
#include <limits>

#include "comm/rendezvous.hpp"
#include "contact/mortar/patches.hpp"
#include "core/sorted.hpp"
#include "implicit/data/nodal.hpp"
#include "mortar_shares.hpp"

namespace brunt::implicit {
namespace {

/// Displacement of nodes until the next exchange of masters, over the capture distance. The exchange includes all
/// facets within reach after both sides have moved by it, and a small margin for rounding.
constexpr double travel_of_capture = 0.5, spare = 1.1;

/// Reach of rows of points over the capture distance: the normal at a facet within reach depends on the facets around
/// its corners, which begin at most the diagonal of a facet farther away.
constexpr double with_neighbours = 3;

struct Box {
  std::array<double, 3> low{}, high{};

  Box() {
    low.fill(std::numeric_limits<double>::infinity());
    high.fill(-std::numeric_limits<double>::infinity());
  }
  void take(const Vec3& x) {
    for (std::size_t c = 0; c < 3; ++c) {
      low[c] = std::min(low[c], x[static_cast<int>(c)]);
      high[c] = std::max(high[c], x[static_cast<int>(c)]);
    }
  }
  void grow(double by) {
    for (std::size_t c = 0; c < 3; ++c) {
      low[c] -= by;
      high[c] += by;
    }
  }
  [[nodiscard]] bool meets(const Box& other) const {
    for (std::size_t c = 0; c < 3; ++c)
      if (low[c] > other.high[c] || other.low[c] > high[c]) return false;
    return true;
  }
};

Box box_of(const contact::FacetNodes& facet, std::span<const Vec3> x) {
  Box box;
  for (const LocalIndex node : facet)
    if (node != no_index) box.take(nth(x, node));
  return box;
}

/// A node sent to another rank.
struct NodeTold {
  GlobalIndex gid = 0;
  Rank owner = 0;
  LocalIndex node = 0;  ///< local index on the owner
  std::int32_t several = 0;
  std::array<double, 9> free{}, movable{};
};
struct FacetTold {
  GlobalIndex key = 0;
  std::array<GlobalIndex, 4> node{};  ///< the last is -1 for a triangle
  contact::PatchNumbers patch{};
  double wall = 0;
  std::int64_t interface = 0;
};

NodeTold told(const ContactNodes& nodes, LocalIndex place) {
  const auto k = static_cast<std::size_t>(place);
  NodeTold node{nodes.gid[k], nodes.source[k].rank, nodes.source[k].index, nodes.several[k]};
  Eigen::Map<Mat3>(node.free.data()) = nodes.free[k];
  Eigen::Map<Mat3>(node.movable.data()) = nodes.movable[k];
  return node;
}

/// For each rank and interface the box reached by its slave facets. Collective.
Ragged<Box> reaches(const comm::Communicator& ranks, const MortarContact& contact) {
  std::vector<Box> mine;
  for (const Interface& face : contact.interfaces) {
    Box box;
    for (const contact::FacetNodes& facet : face.surfaces.slave)
      for (const LocalIndex node : facet)
        if (node != no_index) box.take(nth(contact.nodes.x, node));
    box.grow((face.of_points ? with_neighbours : 1.0) * face.surfaces.capture + 2 * spare * contact.travel);
    mine.push_back(box);
  }
  return comm::exchange(ranks, std::vector<std::vector<Box>>(static_cast<std::size_t>(ranks.size()), mine));
}

struct Told {
  std::vector<FacetTold> facets;
  std::vector<NodeTold> nodes;
};

/// The masters of this rank that another rank needs.
Told told_to(std::span<const Box> reach, const MortarContact& contact) {
  Told all;
  std::vector<LocalIndex> nodes;
  for (std::size_t k = 0; k < contact.interfaces.size(); ++k) {
    const OwnMasters& own = contact.interfaces[k].own_masters;
    for (std::size_t facet = 0; facet < own.key.size(); ++facet) {
      if (!reach[k].meets(box_of(own.nodes[facet], contact.nodes.x))) continue;
      FacetTold told{own.key[facet], {}, {}, own.wall[facet], static_cast<std::int64_t>(k)};
      if (!own.patch.empty()) told.patch = own.patch[facet];
      for (std::size_t c = 0; c < 4; ++c) {
        const LocalIndex node = own.nodes[facet][c];
        told.node[c] = node == no_index ? -1 : nth(contact.nodes.gid, node);
        if (node != no_index) nodes.push_back(node);
      }
      all.facets.push_back(told);
    }
  }
  sort_unique(nodes);
  for (const LocalIndex node : nodes) all.nodes.push_back(told(contact.nodes, node));
  return all;
}

/// Collective. Facets by interface and key.
Told exchanged(const comm::Communicator& ranks, const MortarContact& contact) {
  const Ragged<Box> reach = reaches(ranks, contact);
  std::vector<std::vector<FacetTold>> facets;
  std::vector<std::vector<NodeTold>> nodes;
  for (LocalIndex r = 0; r < reach.rows(); ++r) {
    Told to = told_to(reach.row(r), contact);
    facets.push_back(std::move(to.facets));
    nodes.push_back(std::move(to.nodes));
  }
  Told here{comm::exchange(ranks, facets).values, comm::exchange(ranks, nodes).values};
  std::ranges::sort(here.facets, [](const FacetTold& a, const FacetTold& b) {
    return a.interface < b.interface || (a.interface == b.interface && a.key < b.key);
  });
  return here;
}

/// Weights of t_n refer to nodes, which are kept until the weights are replaced.
void add_remembered(const MortarContact& contact, std::vector<NodeTold>& nodes) {
  for (const Interface& face : contact.interfaces)
    for (const LocalIndex node : face.history.weights.nodes.values)
      if (static_cast<std::size_t>(node) >= contact.nodes.lasting) nodes.push_back(told(contact.nodes, node));
}

/// Stores these nodes after the lasting ones, in place of the previous ones.
void lay_nodes(const comm::Communicator& ranks, std::vector<NodeTold> told, ContactNodes& nodes) {
  std::ranges::sort(told, {}, &NodeTold::gid);
  const LocalIndex of_rank = nodes.gather.roots();
  for (auto* array : {&nodes.rows, &nodes.free, &nodes.movable}) array->resize(nodes.lasting);
  nodes.several.resize(nodes.lasting);
  nodes.gid.resize(nodes.lasting);
  nodes.source.resize(nodes.lasting);
  nodes.own.resize(nodes.lasting);
  for (const NodeTold& node : told) {
    if (nodes.place_of(node.gid) != no_index) continue;
    nodes.gid.push_back(node.gid);
    nodes.source.push_back({node.owner, node.node});
    nodes.own.push_back(no_index);
    nodes.free.emplace_back(Eigen::Map<const Mat3>(node.free.data()));
    nodes.movable.emplace_back(Eigen::Map<const Mat3>(node.movable.data()));
    nodes.several.push_back(static_cast<std::uint8_t>(node.several));
  }
  nodes.rows.resize(nodes.gid.size(), Mat3::Identity());
  nodes.gather = comm::Halo(ranks, of_rank, nodes.source);
}

void lay_masters(const ContactNodes& nodes, std::span<const FacetTold> facets, Interface& face) {
  face.surfaces.master.clear();
  face.surfaces.master_wall.clear();
  std::vector<contact::PatchNumbers> patches;
  if (face.self) face.self->master.clear();
  for (const FacetTold& told : facets) {
    contact::FacetNodes facet{};
    for (std::size_t c = 0; c < 4; ++c) facet[c] = told.node[c] < 0 ? no_index : nodes.place_of(told.node[c]);
    face.surfaces.master.push_back(facet);
    face.surfaces.master_wall.push_back(told.wall);
    if (face.of_points) patches.push_back(told.patch);
    if (face.self) face.self->master.push_back(face.self->number_of(told.key));
  }
  face.surfaces.master_patches = contact::patches_of(patches);
  face.search.anew = true;
}

}  // namespace

std::vector<Vec3> from_owners(const ContactNodes& nodes, std::span<const Vec3> values) {
  std::vector<double> local(3 * static_cast<std::size_t>(nodes.gather.roots())), here(3 * nodes.gid.size());
  for (std::size_t k = 0; k < nodes.lasting; ++k)
    if (nodes.own[k] != no_index) put(values[k], local, static_cast<std::size_t>(nodes.source[k].index));
  nodes.gather.forward(local, here, 3);
  std::vector<Vec3> all;
  for (std::size_t k = 0; k < nodes.gid.size(); ++k) all.emplace_back(&here[3 * k]);
  return all;
}

void share_movable(std::span<const Mat3> movable, ContactNodes& nodes) {
  std::vector<double> local(9 * static_cast<std::size_t>(nodes.gather.roots())), here(9 * nodes.gid.size());
  for (std::size_t k = 0; k < nodes.lasting; ++k)
    if (nodes.own[k] != no_index)
      std::copy_n(movable[k].data(), 9, &local[9 * static_cast<std::size_t>(nodes.source[k].index)]);
  nodes.gather.forward(local, here, 9);
  for (std::size_t k = 0; k < nodes.gid.size(); ++k) nodes.movable[k] = Eigen::Map<const Mat3>(&here[9 * k]);
}

bool masters_wear_out(const comm::Communicator& ranks, const MortarContact& contact) {
  if (!(contact.travel > 0)) return false;
  bool far = false;
  for (std::size_t k = 0; k < contact.nodes.lasting; ++k)
    far = far || (contact.nodes.x[k] - contact.nodes.x_told[k]).norm() > contact.travel;
  return ranks.any(far);
}

void tell_masters(const comm::Communicator& ranks, MortarContact& contact) {
  contact.travel = 0;
  for (const Interface& face : contact.interfaces) {
    const double travel = face.pair.tied ? 0.0 : travel_of_capture * face.surfaces.capture;
    if (travel > 0 && (contact.travel == 0 || travel < contact.travel)) contact.travel = travel;
  }
  if (!(contact.travel > 0)) return;
  Told told = exchanged(ranks, contact);
  add_remembered(contact, told.nodes);
  const std::vector<GlobalIndex> before = contact.nodes.gid;
  lay_nodes(ranks, std::move(told.nodes), contact.nodes);
  for (Interface& face : contact.interfaces)
    for (LocalIndex& node : face.history.weights.nodes.values) node = contact.nodes.place_of(nth(before, node));
  for (std::size_t k = 0; k < contact.interfaces.size(); ++k) {
    if (contact.interfaces[k].pair.tied) continue;
    const auto of_face = equal_part(told.facets, static_cast<std::int64_t>(k), &FacetTold::interface);
    lay_masters(contact.nodes, of_face, contact.interfaces[k]);
  }
  contact.nodes.x = from_owners(contact.nodes, contact.nodes.x);
  contact.nodes.x_before = from_owners(contact.nodes, contact.nodes.x_before);
  contact.nodes.x_told.assign(contact.nodes.x.begin(),
                              contact.nodes.x.begin() + static_cast<std::ptrdiff_t>(contact.nodes.lasting));
}

}  // namespace brunt::implicit
