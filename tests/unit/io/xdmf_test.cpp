// SPDX-License-Identifier: Apache-2.0
// The XDMF text names the tables of state.h5 with their sizes.
#include "io/results/xdmf.hpp"

#include <catch2/catch.hpp>

using namespace brunt;
using Catch::Contains;

TEST_CASE("xdmf: one grid a record, all on the one mesh") {
  const std::vector<io::StateRecord> records{{"/record_000000", 0, 0.0, {}},
                                             {"/record_000001", 8, 0.25, {{"stress", io::Place::element, 6}}}};
  const std::string topology = io::xdmf_topology({false, mesh::Shape::hex8, 0}, 2);
  const std::string text = io::xdmf_text(topology, 12, 2, records);
  CHECK_THAT(text, Contains(R"(CollectionType="Temporal")") && Contains(R"(<Time Value="0.25"/>)"));
  CHECK_THAT(text, Contains(R"(TopologyType="Hexahedron" NumberOfElements="2")") &&
                       Contains(R"("2 8">state.h5:/mesh/connectivity)"));
  CHECK_THAT(
      text,
      Contains(
          R"(Center="Cell"><DataItem Format="HDF" NumberType="Float" Precision="8" Dimensions="2 6">state.h5:/record_000001/element/stress)"));
}

TEST_CASE("xdmf: a stream of mixed cells has one dimension") {
  // two hexahedra (type and 8 nodes) and a tetrahedron (type and 4 nodes)
  CHECK_THAT(io::xdmf_topology({true, mesh::Shape::hex8, 2 * 9 + 5}, 3),
             Contains(R"(TopologyType="Mixed" NumberOfElements="3")") && Contains(R"(Dimensions="23")"));
}

TEST_CASE("xdmf: shells") {
  CHECK_THAT(io::xdmf_topology({false, mesh::Shape::quad4, 0}, 7), Contains(R"("Quadrilateral" NumberOfElements="7")"));
  CHECK_THAT(io::xdmf_topology({false, mesh::Shape::tri3, 0}, 7), Contains(R"("Triangle" NumberOfElements="7")"));
}
