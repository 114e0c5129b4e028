// SPDX-License-Identifier: Apache-2.0
// Writes the XDMF text (see the header).
#include "io/results/xdmf.hpp"

#include <fmt/format.h>

namespace brunt::io {
namespace {

std::string data_item(const std::string& path, const char* type, const std::string& dimensions) {
  return fmt::format(R"(<DataItem Format="HDF" NumberType="{}" Precision="8" Dimensions="{}">state.h5:{}</DataItem>)",
                     type, dimensions, path);
}

std::string dimensions_of(GlobalIndex rows, int components) {
  return components == 1 ? fmt::format("{}", rows) : fmt::format("{} {}", rows, components);
}

// Six components stay as they are ("Matrix"): XDMF's Tensor6 has another order than ours.
const char* attribute_type(int components) {
  if (components == 1) return "Scalar";
  if (components == 3) return "Vector";
  return components == 9 ? "Tensor" : "Matrix";
}

std::string attribute(const StateRecord& record, const StateRecord::Table& table, GlobalIndex rows) {
  const bool nodal = table.place == Place::node;
  const std::string path = fmt::format("{}/{}/{}", record.group, nodal ? "node" : "element", table.name);
  return fmt::format("        <Attribute Name=\"{}\" AttributeType=\"{}\" Center=\"{}\">{}</Attribute>\n", table.name,
                     attribute_type(table.components), nodal ? "Node" : "Cell",
                     data_item(path, "Float", dimensions_of(rows, table.components)));
}

}  // namespace

namespace {

const char* xdmf_name(mesh::Shape shape) {
  switch (shape) {
    case mesh::Shape::tri3:
      return "Triangle";
    case mesh::Shape::quad4:
      return "Quadrilateral";
    case mesh::Shape::tet4:
      return "Tetrahedron";
    case mesh::Shape::hex8:
      break;
  }
  return "Hexahedron";
}

}  // namespace

std::string xdmf_topology(const XdmfCells& cells, GlobalIndex elements) {
  const int width = mesh::nodes_per_element(cells.shape);
  const std::string dimensions =
      cells.mixed ? fmt::format("{}", cells.stream_length) : fmt::format("{} {}", elements, width);
  return fmt::format(R"(<Topology TopologyType="{}" NumberOfElements="{}">{}</Topology>)",
                     cells.mixed ? "Mixed" : xdmf_name(cells.shape), elements,
                     data_item("/mesh/connectivity", "Int", dimensions));
}

std::string xdmf_text(const std::string& topology, GlobalIndex nodes, GlobalIndex elements,
                      std::span<const StateRecord> records) {
  std::string text =
      "<?xml version=\"1.0\"?>\n<Xdmf Version=\"3.0\">\n  <Domain>\n"
      "    <Grid Name=\"state\" GridType=\"Collection\" CollectionType=\"Temporal\">\n";
  const std::string geometry = fmt::format(R"(<Geometry GeometryType="XYZ">{}</Geometry>)",
                                           data_item("/mesh/coordinates", "Float", dimensions_of(nodes, 3)));
  const std::string block =
      fmt::format(R"(<Attribute Name="block" AttributeType="Scalar" Center="Cell">{}</Attribute>)",
                  data_item("/mesh/element_block", "Int", dimensions_of(elements, 1)));
  for (const StateRecord& record : records) {
    text += fmt::format("      <Grid Name=\"step_{}\" GridType=\"Uniform\">\n", record.step);
    text += fmt::format("        <Time Value=\"{}\"/>\n", record.time);
    for (const std::string& part : {topology, geometry, block}) text += "        " + part + "\n";
    for (const StateRecord::Table& table : record.tables)
      text += attribute(record, table, table.place == Place::node ? nodes : elements);
    text += "      </Grid>\n";
  }
  return text + "    </Grid>\n  </Domain>\n</Xdmf>\n";
}

}  // namespace brunt::io
