// SPDX-License-Identifier: Apache-2.0
// The sections of MSH 2.2 and 4.1, both in ASCII.
#include "gmsh_sections.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cstdlib>
#include <numeric>
#include <unordered_map>

#include "core/excerpt.hpp"

namespace brunt::io {
namespace {

struct Kind {
  int dimension, nodes;
};

class Sections {
 public:
  explicit Sections(LineReader& in) : in_(in) {}

  GmshFile read() {
    while (in_.next_line()) {
      const std::string section(in_.rest());
      if (section[0] != '$')
        in_.fail(fmt::format("invalid text '{}'; expected the beginning of a section ($Nodes, ...)", excerpt(section)));
      if (version_ == Version::unknown && section != "$MeshFormat" && section != "$Comments")
        in_.fail("invalid beginning of the file; expected $MeshFormat");
      read_section(section);
    }
    if (version_ == Version::unknown) in_.fail("missing section $MeshFormat; expected it at the beginning of the file");
    if (!nodes_seen_)
      in_.fail("missing section $Nodes: the file is truncated or contains no mesh; expected $Nodes and $Elements");
    if (!elements_seen_)
      in_.fail("missing section $Elements: the file is truncated or contains no mesh; expected $Nodes and $Elements");
    refuse_repeated_numbers();
    return std::move(file_);
  }

 private:
  enum class Version { unknown, two, four };

  void read_section(const std::string& section) {
    const std::string end = "$End" + section.substr(1), shown_end = excerpt(end);
    if (section == "$MeshFormat") {
      read_format();
    } else if (section == "$PhysicalNames") {
      read_names();
    } else if (section == "$Entities") {
      read_entities();
    } else if (section == "$PartitionedEntities") {
      in_.fail("invalid section: partitioned meshes are not supported; expected a mesh written without partitions");
    } else if (section == "$Nodes" || (section == "$ParametricNodes" && version_ == Version::two)) {
      // parametric nodes: the coordinates are followed by parameters on the geometry, which are not used
      once(nodes_seen_, section);
      version_ == Version::two ? read_nodes_2() : read_nodes_4();
    } else if (section == "$Elements") {
      if (!nodes_seen_) in_.fail("missing section $Nodes before $Elements; expected $Nodes first");
      once(elements_seen_, section);
      version_ == Version::two ? read_elements_2() : read_elements_4();
    } else {
      do in_.need_line(shown_end);
      while (in_.rest() != end);
      return;
    }
    in_.need_line(shown_end);
    if (in_.rest() != end) in_.fail(fmt::format("invalid text '{}'; expected {}", excerpt(in_.rest()), shown_end));
  }
  /// Each element has a number of its own (Gmsh reference manual, MSH file formats). A surface element is listed once
  /// for each of its physical groups.
  void refuse_repeated_numbers() const {
    std::vector<std::size_t> order(file_.elements.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    const auto number = [&](std::size_t k) { return file_.elements[k].number; };
    if (!std::ranges::is_sorted(order, {}, number)) std::ranges::stable_sort(order, {}, number);
    for (std::size_t k = 1; k < order.size(); ++k) {
      const GmshElement &one = file_.elements[order[k - 1]], &other = file_.elements[order[k]];
      const bool in_two_groups = one.dimension <= 2 && one.type == other.type && one.nodes == other.nodes;
      if (one.number == other.number && !in_two_groups)
        in_.fail_at(other.line, fmt::format("invalid element {}: another element has this number (line {}); expected a "
                                            "number of its own for each element",
                                            other.number, one.line));
    }
  }
  void once(bool& seen, const std::string& section) {
    if (seen) in_.fail(fmt::format("invalid second section {}; expected one of each", excerpt(section)));
    seen = true;
  }

  void read_format() {
    in_.need_line("the version of the format");
    const double version = in_.real("the version of the format");
    const std::int64_t binary = in_.integer("the file type");
    constexpr auto expected = "expected 2.2 or 4.1 in ASCII (gmsh -save -format msh41 FILE -o NEW.msh)";
    if (version != 2.2 && version != 4.1) in_.fail(fmt::format("unknown MSH version {}; {}", version, expected));
    if (binary != 0) in_.fail(fmt::format("invalid binary MSH file; {}", expected));
    version_ = version == 2.2 ? Version::two : Version::four;
  }

  void read_names() {
    in_.need_line("the number of names");
    for (std::int64_t left = in_.count("the number of names"); left > 0; --left) {
      in_.need_line("a physical name");
      const auto dimension = static_cast<int>(in_.integer("a dimension"));
      const std::int64_t number = in_.integer("a physical number");
      file_.name[{dimension, number}] = in_.quoted("a physical name");
    }
  }

  void read_entities() {
    in_.need_line("the numbers of entities");
    std::array<std::int64_t, 4> count{};
    for (auto& n : count) n = in_.count("a number of entities");
    for (int dimension = 0; dimension < 4; ++dimension)
      for (std::int64_t left = nth(count, dimension); left > 0; --left) {
        in_.need_line("an entity");
        const std::int64_t entity = in_.integer("the number of an entity");
        for (int i = 0; i < (dimension == 0 ? 3 : 6); ++i) in_.real("a bound of the entity");
        auto& groups = groups_[{dimension, entity}];
        for (std::int64_t more = in_.count("the number of physical groups"); more > 0; --more)
          groups.push_back(std::abs(in_.integer("a physical number")));
        if (dimension == 3 && groups.size() > 1)
          in_.fail(
              fmt::format("invalid volume {}: it belongs to {} physical groups; expected one", entity, groups.size()));
      }
  }

  void add_node(std::int64_t number, const Vec3& x) {
    if (!index_.emplace(number, static_cast<LocalIndex>(file_.coordinates.size())).second)
      in_.fail(fmt::format("invalid node {}: defined twice; expected each node once", number));
    file_.coordinates.push_back(x);
    file_.node_number.push_back(number);
  }
  Vec3 coordinates() {
    Vec3 x;
    for (int i = 0; i < 3; ++i) x[i] = in_.real("a coordinate");
    return x;
  }
  void read_nodes_2() {
    in_.need_line("the number of nodes");
    for (std::int64_t left = in_.count("the number of nodes"); left > 0; --left) {
      in_.need_line("a node");
      const std::int64_t number = in_.integer("a node number");
      add_node(number, coordinates());
    }
  }
  void read_nodes_4() {
    in_.need_line("the numbers of entity blocks and nodes");
    std::int64_t blocks = in_.count("the number of entity blocks");
    const std::int64_t total = in_.count("the number of nodes");
    for (; blocks > 0; --blocks) {
      in_.need_line("a block of nodes");
      for (int i = 0; i < 3; ++i) in_.integer("the dimension and number of an entity, and whether it is parametric");
      std::vector<std::int64_t> numbers(static_cast<std::size_t>(in_.count("the number of nodes in the block")));
      for (auto& number : numbers) {
        in_.need_line("a node number");
        number = in_.integer("a node number");
      }
      for (const std::int64_t number : numbers) {
        in_.need_line("a node's coordinates");
        add_node(number, coordinates());
      }
    }
    if (static_cast<std::int64_t>(file_.coordinates.size()) != total)
      in_.fail(fmt::format("invalid number of nodes: {} in the blocks; expected {}", file_.coordinates.size(), total));
  }

  Kind kind_of(std::int64_t type) const {
    switch (type) {
      case 1:
        return {1, 2};
      case 2:
        return {2, 3};
      case 3:
        return {2, 4};
      case 4:
        return {3, 4};
      case 5:
        return {3, 8};
      case 6:
        return {3, 6};
      case 7:
        return {3, 5};
      case 15:
        return {0, 1};
      default:
        return {dimension_of_other(type), 0};
    }
  }
  /// Of types of second and third order (Gmsh reference manual, MSH file format); others are unknown.
  [[nodiscard]] int dimension_of_other(std::int64_t type) const {
    switch (type) {
      case 8:
      case 26:
        return 1;
      case 9:
      case 10:
      case 16:
      case 20:
      case 21:
        return 2;
      case 11:
      case 12:
      case 13:
      case 14:
      case 17:
      case 18:
      case 19:
      case 29:
        return 3;
      default:
        in_.fail(fmt::format("unknown element type {}; expected {}", type, gmsh_element_types));
    }
  }
  void read_corners(GmshElement& element, const Kind& kind) {
    element.dimension = kind.dimension;
    element.corners = kind.nodes;
    element.line = in_.line();
    if (kind.nodes == 0) return;  // its nodes are not read
    for (int k = 0; k < kind.nodes; ++k) {
      const std::int64_t number = in_.integer("a node number");
      const auto found = index_.find(number);
      if (found == index_.end())
        in_.fail(fmt::format("invalid element {}: unknown node {}; expected nodes defined in $Nodes", element.number,
                             number));
      nth(element.nodes, k) = found->second;
    }
    if (!in_.rest().empty())
      in_.fail(fmt::format("invalid line: too many nodes; expected {} for this element type", kind.nodes));
  }
  /// Lines matter as groups, which are edges of shells.
  static bool is_kept(const GmshElement& element) {
    return element.dimension >= 2 || (element.dimension == 1 && element.physical != 0 && element.corners > 0);
  }
  void read_elements_2() {
    in_.need_line("the number of elements");
    for (std::int64_t left = in_.count("the number of elements"); left > 0; --left) {
      in_.need_line("an element");
      GmshElement element;
      element.number = in_.integer("an element number");
      element.type = static_cast<int>(in_.integer("an element type"));
      const Kind kind = kind_of(element.type);
      const std::int64_t tags = in_.count("the number of tags");
      for (std::int64_t t = 0; t < tags; ++t) {
        const std::int64_t tag = in_.integer("a tag");
        if (t == 0) element.physical = std::abs(tag);
        if (t == 1) element.entity = tag;
      }
      read_corners(element, kind);
      if (is_kept(element)) file_.elements.push_back(element);
    }
  }
  void read_elements_4() {
    in_.need_line("the numbers of entity blocks and elements");
    std::int64_t blocks = in_.count("the number of entity blocks");
    const std::int64_t total = in_.count("the number of elements");
    std::int64_t seen = 0;
    for (; blocks > 0; --blocks) {
      in_.need_line("a block of elements");
      const auto dimension = static_cast<int>(in_.integer("the dimension of an entity"));
      GmshElement element;
      element.entity = in_.integer("the number of an entity");
      element.type = static_cast<int>(in_.integer("an element type"));
      const Kind kind = kind_of(element.type);
      if (kind.dimension != dimension)
        in_.fail("invalid element type for the dimension of the entity; expected a type of the same dimension");
      auto groups = groups_[{dimension, element.entity}];
      if (groups.empty()) groups.push_back(0);
      for (std::int64_t left = in_.count("the number of elements in the block"); left > 0; --left, ++seen) {
        in_.need_line("an element");
        element.number = in_.integer("an element number");
        read_corners(element, kind);
        for (const std::int64_t group : groups) {
          element.physical = group;
          if (is_kept(element)) file_.elements.push_back(element);
        }
      }
    }
    if (seen != total) in_.fail(fmt::format("invalid number of elements: {} in the blocks; expected {}", seen, total));
  }

  LineReader& in_;
  GmshFile file_;
  Version version_ = Version::unknown;
  bool nodes_seen_ = false, elements_seen_ = false;
  std::unordered_map<std::int64_t, LocalIndex> index_;
  std::map<std::pair<int, std::int64_t>, std::vector<std::int64_t>> groups_;  // of each entity
};

}  // namespace

GmshFile read_gmsh_sections(LineReader& in) {
  return Sections(in).read();
}

}  // namespace brunt::io
