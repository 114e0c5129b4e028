// SPDX-License-Identifier: Apache-2.0
// The surfaces of mortar interfaces, told to all ranks.
#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <map>

#include "brunt/comm/rendezvous.hpp"
#include "brunt/contact/mortar/active_set.hpp"
#include "brunt/contact/mortar/normals.hpp"
#include "brunt/core/error.hpp"
#include "brunt/implicit/interface_forces.hpp"
#include "brunt/implicit/mortar.hpp"
#include "brunt/implicit/thickness.hpp"
#include "brunt/material/law.hpp"

namespace brunt::implicit {
namespace {

using contact::FacetNodes;
using contact::MortarPair;

/// Rows touch at the start where their gap is below this share of a facet's edge: what coordinates of a mesh file in
/// single precision leave, and less than any contact cares for.
constexpr double touching = 1e-6;

/// Meshes whose mean edges differ by less are alike: the first is the slave then.
constexpr double clearly = 1 - 1e-6;

/// Stiffness of sticking rows over that of a layer of one facet, E / edge: at a traction of E they slip by a tenth of
/// an edge. Softer ones creep before they slide, stiffer ones cost iterations.
constexpr double sticking = 10;

/// An exterior face of a body in contact, as all ranks see it.
struct FaceRecord {
  GlobalIndex key = 0;
  std::array<GlobalIndex, 4> node{};  ///< the last -1 for a triangle
  std::int32_t block = 0;
};
struct NodeRecord {
  GlobalIndex gid = 0;
  Rank owner = 0;
  LocalIndex node = 0;  ///< of the owner
  std::array<double, 3> reference{};
  std::array<double, 9> free{1, 0, 0, 0, 1, 0, 0, 0, 1};
};
struct MirrorRecord {
  GlobalIndex gid = 0;
  std::array<double, 3> normal{};
};

template <class Record>
std::vector<Record> told_to_all(const comm::Communicator& ranks, const std::vector<Record>& mine) {
  return comm::exchange(ranks, std::vector<std::vector<Record>>(static_cast<std::size_t>(ranks.size()), mine)).values;
}

std::vector<FaceRecord> faces_of_pairs(const comm::Communicator& ranks, const model::Model& model) {
  std::vector<FaceRecord> mine;
  for (std::size_t f = 0; f < model.mesh.faces.size(); ++f) {
    const mesh::ExteriorFace& face = model.mesh.faces[f];
    const bool meets = std::ranges::any_of(
        model.mortar, [&](const MortarPair& pair) { return pair.slave == face.block || pair.master == face.block; });
    if (!meets || (!model.in_symmetry_plane.empty() && model.in_symmetry_plane[f] != 0)) continue;
    FaceRecord record{face.key, {}, face.block};
    for (std::size_t k = 0; k < 4; ++k)
      record.node[k] = face.nodes[k] == no_index ? -1 : model.mesh.node_gid[static_cast<std::size_t>(face.nodes[k])];
    mine.push_back(record);
  }
  std::vector<FaceRecord> all = told_to_all(ranks, mine);
  std::ranges::sort(all, {}, &FaceRecord::key);
  return all;
}

std::vector<NodeRecord> nodes_of(const comm::Communicator& ranks, const model::Model& model,
                                 const std::vector<FaceRecord>& faces) {
  std::vector<GlobalIndex> gids;
  for (const FaceRecord& face : faces)
    for (const GlobalIndex gid : face.node)
      if (gid >= 0) gids.push_back(gid);
  std::ranges::sort(gids);
  std::vector<NodeRecord> mine;
  for (const LocalIndex node : model.owned) {
    const auto i = static_cast<std::size_t>(node);
    if (!std::ranges::binary_search(gids, model.mesh.node_gid[i])) continue;
    NodeRecord record{model.mesh.node_gid[i], ranks.rank(), node};
    for (int c = 0; c < 3; ++c) record.reference[static_cast<std::size_t>(c)] = model.reference[i][c];
    const auto held = std::ranges::lower_bound(model.constrained, node, {}, &model::ConstrainedNode::node);
    if (held != model.constrained.end() && held->node == node)
      Eigen::Map<Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(record.free.data()) = held->free;
    mine.push_back(record);
  }
  std::vector<NodeRecord> all = told_to_all(ranks, mine);
  std::ranges::sort(all, {}, &NodeRecord::gid);
  return all;
}

void lay_nodes(const comm::Communicator& ranks, const model::Model& model, const Unknowns& unknowns,
               const std::vector<NodeRecord>& records, ContactNodes& nodes) {
  std::vector<comm::RemoteSlot> source;
  for (const NodeRecord& record : records) {
    nodes.gid.push_back(record.gid);
    nodes.reference.emplace_back(record.reference.data());
    nodes.free.emplace_back(Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(record.free.data()));
    source.push_back({record.owner, record.node});
    LocalIndex own = no_index;
    if (record.owner == ranks.rank())
      own = static_cast<LocalIndex>(std::ranges::lower_bound(unknowns.node, record.node) - unknowns.node.begin());
    nodes.own.push_back(own);
    const auto here = std::ranges::lower_bound(model.mesh.node_gid, record.gid);
    const bool held = here != model.mesh.node_gid.end() && *here == record.gid;
    nodes.here.push_back(held ? static_cast<LocalIndex>(here - model.mesh.node_gid.begin()) : no_index);
  }
  nodes.gather = comm::Halo(ranks, model.nodes(), source);
  nodes.rows = nodes.movable = nodes.free;
  nodes.x = nodes.x_before = nodes.reference;
  nodes.force.assign(nodes.gid.size(), Vec3::Zero());
  nodes.friction_force = nodes.force;
}

LocalIndex place_of(const ContactNodes& nodes, GlobalIndex gid) {
  return static_cast<LocalIndex>(std::ranges::lower_bound(nodes.gid, gid) - nodes.gid.begin());
}

/// Faces of a block in the order of their keys, with nodes as places.
std::vector<FacetNodes> facets_of(const ContactNodes& nodes, const std::vector<FaceRecord>& faces, std::int32_t block) {
  std::vector<FacetNodes> facets;
  for (const FaceRecord& face : faces) {
    if (face.block != block) continue;
    FacetNodes facet{};
    for (std::size_t k = 0; k < 4; ++k) facet[k] = face.node[k] < 0 ? no_index : place_of(nodes, face.node[k]);
    facets.push_back(facet);
  }
  return facets;
}

struct EdgeLengths {
  double mean = 0, largest = 0;  ///< [length]
};
EdgeLengths edges_of(const std::vector<FacetNodes>& facets, std::span<const Vec3> x) {
  EdgeLengths edges;
  double count = 0;
  for (const FacetNodes& facet : facets) {
    const std::size_t n = facet[3] == no_index ? 3 : 4;
    for (std::size_t k = 0; k < n; ++k) {
      const double length =
          (x[static_cast<std::size_t>(facet[k])] - x[static_cast<std::size_t>(facet[(k + 1) % n])]).norm();
      edges.mean += length;
      edges.largest = std::max(edges.largest, length);
      ++count;
    }
  }
  edges.mean /= std::max(count, 1.0);
  return edges;
}

double young_of(const model::ElementBlock& block) {
  const material::ElasticModuli moduli = material::initial_moduli(block.law);
  return moduli.mu * (3 * moduli.lambda + 2 * moduli.mu) / (moduli.lambda + moduli.mu);
}

void lay_rows(const ContactNodes& nodes, const std::vector<MirrorRecord>& mirrors, contact::MortarSurfaces& surfaces) {
  for (const FacetNodes& facet : surfaces.slave)
    for (const LocalIndex node : facet)
      if (node != no_index) surfaces.rows.push_back(node);
  std::ranges::sort(surfaces.rows);
  const auto repeated = std::ranges::unique(surfaces.rows);
  surfaces.rows.erase(repeated.begin(), repeated.end());
  for (const LocalIndex row : surfaces.rows) {
    const GlobalIndex gid = nodes.gid[static_cast<std::size_t>(row)];
    for (const MirrorRecord& mirror : std::ranges::equal_range(mirrors, gid, {}, &MirrorRecord::gid))
      surfaces.mirrors.values.emplace_back(mirror.normal.data());
    surfaces.mirrors.close_row();
  }
}

std::vector<MirrorRecord> mirrors_of(const comm::Communicator& ranks, const model::Model& model) {
  std::vector<MirrorRecord> mine;
  for (const model::SymmetryNodes& plane : model.symmetries)
    for (const LocalIndex node : plane.nodes)
      if (std::ranges::binary_search(model.owned, node))
        mine.push_back(
            {model.mesh.node_gid[static_cast<std::size_t>(node)], {plane.normal[0], plane.normal[1], plane.normal[2]}});
  std::vector<MirrorRecord> all = told_to_all(ranks, mine);
  std::ranges::stable_sort(all, {}, &MirrorRecord::gid);
  return all;
}

/// Is there a node that supports leave a direction to?
bool can_move(const ContactNodes& nodes, const std::vector<FacetNodes>& facets) {
  return std::ranges::any_of(facets, [&](const FacetNodes& facet) {
    return std::ranges::any_of(facet, [&](LocalIndex node) {
      return node != no_index && nodes.free[static_cast<std::size_t>(node)] != Mat3::Zero();
    });
  });
}

/// Multipliers of a slave that is wholly held would act on the master's nodes alone, more rows than they can follow:
/// what can move is the slave then, else the finer side.
bool master_is_better(const ContactNodes& nodes, const std::vector<FacetNodes>& slave,
                      const std::vector<FacetNodes>& master) {
  const bool slave_moves = can_move(nodes, slave), master_moves = can_move(nodes, master);
  if (slave_moves != master_moves) return master_moves;
  return edges_of(master, nodes.reference).mean < clearly * edges_of(slave, nodes.reference).mean;
}

Interface make_interface(const model::Model& model, const ContactNodes& nodes, const std::vector<FaceRecord>& faces,
                         const std::vector<MirrorRecord>& mirrors, const MortarPair& asked) {
  Interface face;
  face.pair = asked;
  if (asked.choose_slave &&
      master_is_better(nodes, facets_of(nodes, faces, asked.slave), facets_of(nodes, faces, asked.master)))
    std::swap(face.pair.slave, face.pair.master);
  face.surfaces.slave = facets_of(nodes, faces, face.pair.slave);
  face.surfaces.master = facets_of(nodes, faces, face.pair.master);
  face.surfaces.multiplier = asked.multiplier;
  face.surfaces.capture = std::max(edges_of(face.surfaces.slave, nodes.reference).largest,
                                   edges_of(face.surfaces.master, nodes.reference).largest);
  face.surfaces.slave_wall = thickness_behind(face.surfaces.slave, nodes.reference, face.surfaces.capture);
  face.surfaces.master_wall = thickness_behind(face.surfaces.master, nodes.reference, face.surfaces.capture);
  lay_rows(nodes, mirrors, face.surfaces);
  face.topology = contact::make_topology(face.surfaces, nodes.reference);
  const auto block = [&](std::int32_t b) -> const model::ElementBlock& {
    return model.blocks[static_cast<std::size_t>(b)];
  };
  const double young = std::min(young_of(block(face.pair.slave)), young_of(block(face.pair.master)));
  face.stiffness = contact::layer_stiffness(young, face.topology);
  face.friction = {asked.friction, sticking * face.stiffness};
  face.scratch = contact::make_mortar_scratch();
  const std::size_t n = face.count();
  face.z.assign(n * (asked.tied ? 3 : 1), 0.0);
  face.active.assign(n, 0);
  face.tractions.assign(n, Vec3::Zero());
  face.touches.assign(n, 0);
  return face;
}

/// Where the multipliers stand in the system, and which of them are this rank's.
void number_multipliers(const comm::Communicator& ranks, const Unknowns& unknowns,
                        const std::vector<NodeRecord>& records, MortarContact& contact) {
  GlobalIndex next = unknowns.total;
  std::vector<GlobalIndex> row;
  std::vector<Rank> owner;
  for (Interface& face : contact.interfaces) {
    face.first = next;
    for (const LocalIndex node : face.surfaces.rows)
      for (int k = 0; k < face.multipliers(); ++k) {
        row.push_back(next++);
        owner.push_back(records[static_cast<std::size_t>(node)].owner);
      }
  }
  contact.z.assign(row.size(), 0.0);
  std::vector<LocalIndex> count(static_cast<std::size_t>(ranks.size()), 0);
  std::vector<comm::RemoteSlot> source;
  for (std::size_t k = 0; k < row.size(); ++k) {
    source.push_back({owner[k], count[static_cast<std::size_t>(owner[k])]++});
    if (owner[k] != ranks.rank()) continue;
    contact.own_rows.push_back(row[k]);
    contact.own.push_back(static_cast<LocalIndex>(k));
  }
  contact.gather_z = comm::Halo(ranks, static_cast<LocalIndex>(contact.own.size()), source);
}

/// Both sides wholly held: nothing can give way.
void refuse_held(const model::Model& model, const MortarContact& contact, const Interface& face) {
  const auto& part = [&](std::int32_t b) -> const std::string& {
    return model.blocks[static_cast<std::size_t>(b)].part;
  };
  if (face.surfaces.slave.empty() || face.surfaces.master.empty())
    throw InputError(fmt::format("{}: {} has no face that could meet {}; accepted: parts with exterior faces",
                                 face.pair.entry,
                                 part(face.surfaces.slave.empty() ? face.pair.slave : face.pair.master),
                                 part(face.surfaces.slave.empty() ? face.pair.master : face.pair.slave)));
  if (!can_move(contact.nodes, face.surfaces.slave) && !can_move(contact.nodes, face.surfaces.master))
    throw InputError(
        fmt::format("{}: all nodes of the surfaces of {} and {} are held; accepted: a pair of which "
                    "one can give way",
                    face.pair.entry, part(face.pair.slave), part(face.pair.master)));
}

void note_redundant(const Interface& face, std::vector<std::string>& notes) {
  std::size_t covered = 0, redundant = 0;
  for (std::size_t row = 0; row < face.count(); ++row) {
    if (face.tie.covered[row] == 0) continue;
    ++covered;
    if (!face.tied[row].isIdentity()) ++redundant;
  }
  if (redundant > 0)
    notes.push_back(
        fmt::format("{}: {} of {} tied nodes have no multiplier along directions in which supports hold both "
                    "sides or other multipliers say the same",
                    face.pair.entry, redundant, covered));
}

}  // namespace

MortarContact make_mortar(const comm::Communicator& ranks, const model::Model& model, const Unknowns& unknowns) {
  MortarContact contact;
  if (model.mortar.empty()) return contact;
  const std::vector<FaceRecord> faces = faces_of_pairs(ranks, model);
  const std::vector<NodeRecord> records = nodes_of(ranks, model, faces);
  const std::vector<MirrorRecord> mirrors = mirrors_of(ranks, model);
  lay_nodes(ranks, model, unknowns, records, contact.nodes);
  for (const MortarPair& pair : model.mortar) {
    contact.interfaces.push_back(make_interface(model, contact.nodes, faces, mirrors, pair));
    refuse_held(model, contact, contact.interfaces.back());
  }
  number_multipliers(ranks, unknowns, records, contact);
  contact.z_before = contact.z;
  find_contact(contact, Iterate::first_of_step);
  for (Interface& face : contact.interfaces) {
    if (face.pair.tied) {
      face.tie = contact::tie(face.rows);
      contact::find_places_below(face.surfaces, face.topology, face.search.candidates, contact.nodes.x, face.tie);
      contact::nodal_normals(face.surfaces, face.topology, contact.nodes.x, face.tie.normals);
    }
    for (std::size_t row = 0; row < face.count(); ++row)
      face.touches[row] = face.rows.covered[row] > 0 && std::abs(face.mean_gap(row)) <= touching * face.topology.edge;
  }
  leave_out_redundant(contact);
  for (const Interface& face : contact.interfaces)
    if (face.pair.tied) note_redundant(face, contact.notes);
  keep_contact(contact);
  contact.impulses.assign(contact.interfaces.size() * static_cast<std::size_t>(interface_force_width), 0.0);
  contact.forces_before = contact.impulses;
  return contact;
}

}  // namespace brunt::implicit
