// SPDX-License-Identifier: Apache-2.0
// Interfaces shared out over the ranks against one rank that has all of them, and against all pairs of facets: the same
// pairs, segments, forces and terms of the matrix, bit by bit, while the surfaces slide over each other by several
// facets.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <random>
#include <vector>

#include "contact/mortar/interface.hpp"
#include "contact/search/facet_tree.hpp"
#include "implicit/mortar/mortar.hpp"

using namespace brunt;
using namespace brunt::implicit;
using contact::FacetNodes;

namespace {

/// Two sheets of quadrilaterals that wave, one above the other: a function of the seed.
struct Sheets {
  std::vector<Vec3> x;
  std::vector<FacetNodes> facets;  ///< the slave's first
  std::size_t slaves = 0;          ///< facets
  LocalIndex slave_nodes = 0;
  double friction = 0;
  bool strips = false;  ///< facets are dealt out by their places, else at random

  explicit Sheets(unsigned seed) : random(seed) {
    add(0, true);
    slaves = facets.size();
    slave_nodes = static_cast<LocalIndex>(x.size());
    add(0.06 * unit(), false);
    friction = unit() < 0.5 ? 0.3 : 0.0;
    strips = unit() < 0.5;
    way = Vec3(unit() - 0.5, unit() - 0.5, 0.1 * (unit() - 0.5));
  }
  /// Places after the master has gone `share` of its way.
  [[nodiscard]] std::vector<Vec3> at(double share) const {
    std::vector<Vec3> places = x;
    for (auto node = static_cast<std::size_t>(slave_nodes); node < x.size(); ++node) places[node] += share * way;
    return places;
  }
  /// Of each facet, for so many ranks.
  [[nodiscard]] std::vector<Rank> dealt(int ranks) {
    std::vector<Rank> rank;
    for (const FacetNodes& facet : facets) {
      const double place = strips ? x[static_cast<std::size_t>(facet[0])][0] + 0.5 : unit();
      rank.push_back(std::clamp(static_cast<int>(place * ranks), 0, ranks - 1));
    }
    return rank;
  }

 private:
  double unit() { return std::uniform_real_distribution<double>(0, 1)(random); }
  void add(double height, bool up) {
    const int n = 5 + static_cast<int>(5 * unit()), m = 5 + static_cast<int>(5 * unit());
    const double wave = 0.05 * unit(), noise = 0.1 / n;
    const auto first = static_cast<LocalIndex>(x.size());
    for (int j = 0; j <= m; ++j)
      for (int i = 0; i <= n; ++i) {
        const double a = static_cast<double>(i) / n - 0.5, b = static_cast<double>(j) / m - 0.5;
        x.push_back(Vec3(a, b, height + wave * std::sin(5 * a)) + noise * Vec3(unit(), unit(), 0.2 * unit()));
      }
    for (int j = 0; j < m; ++j)
      for (int i = 0; i < n; ++i) {
        const LocalIndex a = first + j * (n + 1) + i, b = a + 1, c = b + n + 1, d = c - 1;
        facets.push_back(up ? FacetNodes{a, b, c, d} : FacetNodes{a, d, c, b});
      }
  }
  std::mt19937 random;
  Vec3 way = Vec3::Zero();
};

/// A model of the faces that a rank has; no more of it than contact asks for.
model::Model model_of(const Sheets& sheets, Rank rank, const std::vector<Rank>& of_facet) {
  model::Model model;
  std::vector<Rank> owner(sheets.x.size(), 1 << 20);
  std::vector<char> here(sheets.x.size(), 0);
  for (std::size_t f = 0; f < sheets.facets.size(); ++f)
    for (const LocalIndex node : sheets.facets[f]) {
      const auto i = static_cast<std::size_t>(node);
      owner[i] = std::min(owner[i], of_facet[f]);
      if (of_facet[f] == rank) here[i] = 1;
    }
  std::vector<LocalIndex> local(sheets.x.size(), no_index);
  model.mesh.global_nodes = static_cast<GlobalIndex>(sheets.x.size());
  for (std::size_t i = 0; i < sheets.x.size(); ++i) {
    if (here[i] == 0) continue;
    local[i] = model.nodes();
    if (owner[i] == rank) model.owned.push_back(local[i]);
    model.mesh.node_gid.push_back(static_cast<GlobalIndex>(i));
    model.mesh.owner.push_back(owner[i]);
    model.reference.push_back(Quad{sheets.x[i][0], sheets.x[i][1], sheets.x[i][2], 0});
  }
  for (std::size_t f = 0; f < sheets.facets.size(); ++f) {
    if (of_facet[f] != rank) continue;
    mesh::ExteriorFace face{static_cast<GlobalIndex>(8 * f), {}, f < sheets.slaves ? 0 : 1};
    for (std::size_t c = 0; c < 4; ++c) face.nodes[c] = local[static_cast<std::size_t>(sheets.facets[f][c])];
    model.mesh.faces.push_back(face);
  }
  model.blocks.resize(2);
  for (model::ElementBlock& block : model.blocks) block.law = material::NeoHookean{1, 1, 1};
  contact::MortarPair pair;
  pair.master = 1;
  pair.choose_slave = false;
  pair.friction = sheets.friction;
  model.touching.mortar.push_back(pair);
  return model;
}

/// Contact of some ranks, brought from places to places.
struct Contact {
  const comm::Communicator& ranks;
  model::Model model;
  Unknowns unknowns;
  MortarContact contact;
  std::vector<ContactTerm> terms;

  Contact(const comm::Communicator& on, model::Model of)
      : ranks(on),
        model(std::move(of)),
        unknowns(number_unknowns(on, model)),
        contact(make_mortar(on, model, unknowns)) {
    contact.keeps_gaps = true;
    contact.budget = 1e-6;
  }
  void go(const std::vector<Vec3>& places, Iterate iterate) {
    model::State state;
    state.nodes.resize(model.mesh.node_gid.size());
    for (std::size_t i = 0; i < state.nodes.size(); ++i)
      for (int c = 0; c < 3; ++c) state.nodes[i].x[c] = places[static_cast<std::size_t>(model.mesh.node_gid[i])][c];
    std::vector<double> z;
    for (const LocalIndex k : contact.own) z.push_back(0.01 * (1 + std::sin(k)));
    gather_contact(ranks, state, z, contact);
    find_contact(ranks, contact, iterate);
    tally(ranks, contact);
    contact_terms(ranks, contact, implicit::FrictionLimit::follows, terms);
  }
  [[nodiscard]] const Interface& face() const { return contact.interfaces.front(); }
};

/// Of all pairs, by one rank that has all of them.
std::size_t segments_of_all(const Sheets& sheets, const std::vector<Vec3>& places, double capture) {
  contact::MortarSurfaces surfaces;
  const auto middle = sheets.facets.begin() + static_cast<std::ptrdiff_t>(sheets.slaves);
  surfaces.slave.assign(sheets.facets.begin(), middle);
  surfaces.master.assign(middle, sheets.facets.end());
  surfaces.capture = capture;
  for (LocalIndex node = 0; node < sheets.slave_nodes; ++node) surfaces.rows.push_back(node);
  Ragged<LocalIndex> candidates;
  for (std::size_t facet = 0; facet < surfaces.slave.size(); ++facet) {
    for (std::size_t c = 0; c < surfaces.master.size(); ++c) candidates.values.push_back(static_cast<LocalIndex>(c));
    candidates.close_row();
  }
  contact::MortarRows rows;
  contact::mortar_rows(surfaces, contact::make_topology(surfaces, sheets.x), candidates, places,
                       *contact::make_mortar_scratch(), rows);
  return rows.segments;
}

/// How many rows, forces and terms of the ranks are not those of one rank.
GlobalIndex differing(const Contact& shared, const Contact& alone) {
  GlobalIndex count = 0;
  for (std::size_t row = 0; row < shared.face().count(); ++row) {
    const auto all = static_cast<std::size_t>(shared.face().numbering.place[row]);
    const bool same = shared.face().iterate.rows.gaps[row] == alone.face().iterate.rows.gaps[all] &&
                      shared.face().iterate.rows.normals[row] == alone.face().iterate.rows.normals[all] &&
                      shared.face().iterate.tractions[row] == alone.face().iterate.tractions[all] &&
                      shared.face().iterate.active[row] == alone.face().iterate.active[all];
    count += same ? 0 : 1;
  }
  const ContactNodes &nodes = shared.contact.nodes, &all_nodes = alone.contact.nodes;
  for (std::size_t k = 0; k < nodes.lasting; ++k) {
    if (nodes.own[k] == no_index) continue;
    const auto all = static_cast<std::size_t>(all_nodes.place_of(nodes.gid[k]));
    const bool same =
        nodes.force[k] == all_nodes.force[all] && nodes.friction_force[k] == all_nodes.friction_force[all];
    count += same ? 0 : 1;
  }
  const auto before = [](const ContactTerm& a, const ContactTerm& b) {
    return a.row < b.row || (a.row == b.row && a.column < b.column);
  };
  for (std::size_t k = 0; k < shared.terms.size(); ++k) {  // those of one place are equally many, in the same order
    const ContactTerm& term = shared.terms[k];
    const auto [mine, mine_end] = std::equal_range(shared.terms.begin(), shared.terms.end(), term, before);
    const auto [first, end] = std::equal_range(alone.terms.begin(), alone.terms.end(), term, before);
    const auto at = shared.terms.begin() + static_cast<std::ptrdiff_t>(k) - mine;
    const bool same = end - first == mine_end - mine && (first + at)->value == term.value;
    count += same ? 0 : 1;
  }
  return count;
}

}  // namespace

TEST_CASE("interfaces shared out over ranks are those of one rank, and complete at every iterate") {
  const comm::Communicator ranks = comm::Communicator::world(), self = comm::Communicator::self();
  GlobalIndex told = 0, segments = 0, sliding = 0, held = 0, all_held = 0;
  constexpr unsigned seeds = 24;
  for (unsigned seed = 0; seed < seeds; ++seed) {
    CAPTURE(seed);
    Sheets sheets(seed);
    const std::vector<Rank> of_facet = sheets.dealt(ranks.size());
    Contact shared(ranks, model_of(sheets, ranks.rank(), of_facet));
    Contact alone(self, model_of(sheets, 0, std::vector<Rank>(of_facet.size(), 0)));
    const double capture = alone.face().surfaces.capture;
    for (const double share : {0.0, 0.02, 0.1, 0.3, 0.35, 0.7, 1.0, 0.2}) {
      const std::vector<Vec3> places = sheets.at(share), before = shared.contact.nodes.x_told;
      for (Contact* contact : {&shared, &alone})
        contact->go(places, share == 0.3 ? Iterate::later : Iterate::first_of_step);
      REQUIRE(ranks.sum(differing(shared, alone)) == 0);
      CHECK(ranks.sum(static_cast<GlobalIndex>(shared.terms.size())) == static_cast<GlobalIndex>(alone.terms.size()));
      CHECK(shared.contact.recovery == alone.contact.recovery);
      CHECK(shared.contact.counts.pairs == alone.contact.counts.pairs);
      CHECK(shared.contact.counts.active == alone.contact.counts.active);
      CHECK(shared.contact.counts.segments == static_cast<GlobalIndex>(segments_of_all(sheets, places, capture)));
      CHECK(given_in_step(shared.contact) == given_in_step(alone.contact));
      told += before == shared.contact.nodes.x_told ? 0 : 1;
      segments += shared.contact.counts.segments;
      for (const contact::FrictionState state : shared.face().iterate.states)
        sliding += state == contact::FrictionState::slip ? 1 : 0;
      if (share != 0.35) {
        keep_contact(shared.contact);
        keep_contact(alone.contact);
        CHECK(shared.contact.z_before == alone.contact.z_before);
        CHECK(shared.contact.traction_before == alone.contact.traction_before);
      }
    }
    if (!sheets.strips) continue;
    held += static_cast<GlobalIndex>(shared.face().surfaces.master.size());
    all_held += static_cast<GlobalIndex>(sheets.facets.size() - sheets.slaves);
  }
  CHECK(ranks.sum(told) > 2 * static_cast<GlobalIndex>(seeds));
  CHECK(segments > 100 * static_cast<GlobalIndex>(seeds));
  CHECK(ranks.sum(sliding) > 0);
  if (ranks.size() > 2) CHECK(ranks.sum(held) < ranks.sum(all_held));
}
