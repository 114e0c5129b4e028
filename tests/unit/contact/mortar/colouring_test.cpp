// SPDX-License-Identifier: Apache-2.0
// Slave and master among the facets of one surface.
#include "contact/mortar/colouring.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <random>

using namespace brunt;
using namespace brunt::contact;

namespace {

using Role = FacetRole;

/// Of each pair exactly one facet is the slave, whichever stands first.
void check_orders(const std::vector<FacetRole>& roles) {
  for (LocalIndex a = 0; a < static_cast<LocalIndex>(roles.size()); ++a)
    for (LocalIndex b = 0; b < static_cast<LocalIndex>(roles.size()); ++b) {
      const Role of_a = roles[static_cast<std::size_t>(a)], of_b = roles[static_cast<std::size_t>(b)];
      if (a != b) CHECK(is_slave(of_a, of_b, a, b) != is_slave(of_b, of_a, b, a));
    }
}

/// Two rows of facets, 0 .. n-1 above n .. 2 n - 1, each opposite its own and the next.
std::vector<FacingPair> gap(LocalIndex n) {
  std::vector<FacingPair> pairs;
  for (LocalIndex k = 0; k < n; ++k) {
    pairs.push_back({k, n + k});
    if (k + 1 < n) pairs.push_back({n + k, k + 1});
  }
  return pairs;
}

}  // namespace

TEST_CASE("two walls that face each other have different roles, facets that face nothing none") {
  const std::vector<double> edge(9, 1.0);
  const std::vector<FacetRole> roles = roles_of_facets(gap(4), edge);
  for (std::size_t k = 0; k < 4; ++k) {
    CHECK(roles[k] == Role::slave);
    CHECK(roles[4 + k] == Role::master);
  }
  CHECK(roles[8] == Role::none);
  CHECK(undecided(gap(4), roles).slave == no_index);
  check_orders(roles);
}

TEST_CASE("the finer side of a gap is the slave") {
  std::vector<double> edge(8, 1.0);
  std::fill_n(edge.begin() + 4, 4, 0.5);
  const std::vector<FacetRole> roles = roles_of_facets(gap(4), edge);
  for (std::size_t k = 0; k < 4; ++k) {
    CHECK(roles[k] == Role::master);
    CHECK(roles[4 + k] == Role::slave);
  }
}

TEST_CASE("of equal sides the one that looks up is the slave, in each component") {
  std::vector<FacingPair> pairs = gap(3);  // 0 .. 2 look down, their partners 3 .. 5 up
  for (const FacingPair& pair : gap(3)) pairs.push_back({pair.slave + 6, pair.master + 6});
  std::vector<double> edge(12, 1.0);
  for (FacingPair& pair : pairs) pair.up = pair.slave % 6 < 3 ? -0.8 : 0.8;
  const std::vector<FacetRole> roles = roles_of_facets(pairs, edge);
  for (std::size_t k = 0; k < 12; ++k) CHECK(roles[k] == (k % 6 < 3 ? Role::master : Role::slave));
  std::fill_n(edge.begin(), 3, 0.5);  // but the finer side comes first
  CHECK(roles_of_facets(pairs, edge)[0] == Role::slave);
  CHECK(roles_of_facets(pairs, edge)[6] == Role::master);
}

TEST_CASE("what is pressed remains the slave, and all that is connected with it follows") {
  std::vector<FacingPair> pairs = gap(4);
  pairs[6] = {7, 3, 1};  // facet 7 presses on 3, against order and edges
  std::vector<double> edge(8, 1.0);
  std::fill_n(edge.begin(), 4, 0.5);
  const std::vector<FacetRole> roles = roles_of_facets(pairs, edge);
  for (std::size_t k = 0; k < 4; ++k) {
    CHECK(roles[k] == Role::master);
    CHECK(roles[4 + k] == Role::slave);
  }
}

TEST_CASE("pressed zones of opposite roles that grow together keep them, and one pair between is undecided") {
  std::vector<FacingPair> pairs = gap(6);
  pairs[0].pressed = 1;    // 0 on 6
  pairs[10] = {11, 5, 1};  // 11 on 5
  const std::vector<double> edge(12, 1.0);
  const std::vector<FacetRole> roles = roles_of_facets(pairs, edge);
  CHECK(roles[0] == Role::slave);
  CHECK(roles[6] == Role::master);
  CHECK(roles[11] == Role::slave);
  CHECK(roles[5] == Role::master);
  CHECK(std::ranges::count(roles, Role::none) == 0);
  std::size_t same = 0;
  for (const FacingPair& pair : pairs)
    same += roles[static_cast<std::size_t>(pair.slave)] == roles[static_cast<std::size_t>(pair.master)] ? 1 : 0;
  CHECK(same == 1);
  CHECK(undecided(pairs, roles).slave != no_index);
  check_orders(roles);
}

TEST_CASE("three walls that face each other cannot all differ: one pair is undecided and has a slave") {
  const std::vector<FacingPair> pairs{{0, 1}, {1, 2}, {0, 2}};
  const std::vector<double> edge(3, 1.0);
  const std::vector<FacetRole> roles = roles_of_facets(pairs, edge);
  const FacingPair odd = undecided(pairs, roles);
  REQUIRE(odd.slave == 1);
  CHECK(odd.master == 2);
  CHECK(roles[0] == Role::slave);
  check_orders(roles);
}

TEST_CASE("roles depend neither on the order of pairs nor, without pressure, on which stood first") {
  std::mt19937 random(5);
  for (int round = 0; round < 200; ++round) {
    const LocalIndex facets = 4 + static_cast<LocalIndex>(random() % 30);
    std::vector<FacingPair> pairs;
    for (LocalIndex a = 0; a < facets; ++a)
      for (LocalIndex b = a + 1; b < facets; ++b)
        if (random() % 12 == 0) pairs.push_back({a, b});
    std::vector<double> edge;
    for (LocalIndex k = 0; k < facets; ++k) edge.push_back(1 + static_cast<double>(random() % 3));
    const std::vector<FacetRole> roles = roles_of_facets(pairs, edge);
    std::ranges::shuffle(pairs, random);
    for (FacingPair& pair : pairs)
      if (random() % 2 == 0) std::swap(pair.slave, pair.master);
    CHECK(roles_of_facets(pairs, edge) == roles);
    for (FacingPair& pair : pairs)
      if (random() % 6 == 0) pair.pressed = 1;
    const std::vector<FacetRole> later = roles_of_facets(pairs, edge);
    for (const FacingPair& pair : pairs)
      if (pair.pressed != 0) {
        CHECK(later[static_cast<std::size_t>(pair.slave)] == Role::slave);
        CHECK(later[static_cast<std::size_t>(pair.master)] != Role::none);
      }
    check_orders(later);
  }
}
