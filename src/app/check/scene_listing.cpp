// SPDX-License-Identifier: Apache-2.0
#include "scene_listing.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>
#include <string>
#include <type_traits>
#include <variant>
#include <vector>

#include "core/excerpt.hpp"
#include "mesh/primitives.hpp"
#include "scene/build/select.hpp"
#include "scene/text/units.hpp"

namespace brunt::app {
namespace {

std::string vector_text(const Vec3& v) {
  return fmt::format("({:g}, {:g}, {:g})", v[0], v[1], v[2]);
}

std::string counted(GlobalIndex count, const char* what) {
  return fmt::format("{} {}{}", count, what, count == 1 ? "" : "s");
}

std::string curve_text(const std::string& curve) {
  return curve.empty() ? "" : ", curve " + curve;
}

template <class Body>
const char* shell_word(const Body& body) {
  return body.shell ? "shell " : "";
}

std::string body_text(const scene::MeshEntry& entry) {
  return std::visit(
      [](const auto& body) -> std::string {
        using Body = std::decay_t<decltype(body)>;
        if constexpr (std::is_same_v<Body, scene::MeshFile>) {
          return "file " + body.file;
        } else if constexpr (std::is_same_v<Body, scene::CylinderMesh>) {
          return fmt::format("{}: cylinder, elements: {} across the radius, {} around, {} along", body.part,
                             body.elements[0], mesh::elements_around(body.elements[0]), body.elements[1]);
        } else if constexpr (std::is_same_v<Body, scene::SphereMesh>) {
          return fmt::format("{}: {}sphere, elements: {} across the radius, {} around the whole", body.part,
                             shell_word(body), body.elements, mesh::elements_around(body.elements));
        } else if constexpr (std::is_same_v<Body, scene::TubeMesh>) {
          return fmt::format("{}: {}tube, elements: {} through the wall, {} around, {} along", body.part,
                             shell_word(body), body.elements[0], body.elements[1], body.elements[2]);
        } else if constexpr (std::is_same_v<Body, scene::TorusMesh>) {
          return fmt::format("{}: torus, elements: {} around the ring, {} around the tube, {} through the wall",
                             body.part, body.elements[0], body.elements[1], body.elements[2]);
        } else {
          const char* kind = std::is_same_v<Body, scene::BoxMesh> ? "box" : "plate";
          const std::string plane = fmt::format("{}: {}{}, elements: {} x {}", body.part, shell_word(body), kind,
                                                body.elements[0], body.elements[1]);
          return std::is_same_v<Body, scene::PlateMesh> && body.shell
                     ? plane
                     : plane + fmt::format(" x {}", body.elements[2].cells);
        }
      },
      entry.body);
}

class Listing {
 public:
  explicit Listing(const Prepared& run) : run_(run), units_(*scene::find_unit_system(run.input.units)) {
    const scene::Input& input = run.input;
    for (const scene::MeshEntry& entry : input.mesh) add("mesh", body_text(entry));
    add_sets();
    each(input.initial, &Listing::add_motion);
    each(input.fixed, &Listing::add_fixed);
    each(input.symmetry, &Listing::add_symmetry);
    each(input.prescribed, &Listing::add_prescribed);
    each(input.pressure, &Listing::add_pressure);
    each(input.forces, &Listing::add_force);
    each(input.traction, &Listing::add_traction);
    each(input.remove, &Listing::add_removal);
    each(input.parts, &Listing::add_shell);
    each(input.parts, &Listing::add_metal);
    each(input.parts, &Listing::add_erosion);
    add_fields();
  }

  std::vector<std::string> lines;

 private:
  void add(const char* kind, const std::string& what) { lines.push_back(fmt::format("{:<16} {}", kind, what)); }

  template <class Entry>
  void each(const std::vector<Entry>& list, void (Listing::*tell)(const Entry&, std::size_t)) {
    for (std::size_t k = 0; k < list.size(); ++k) (this->*tell)(list[k], k);
  }

  /// Of a set of nodes, over all ranks.
  [[nodiscard]] std::string nodes_of(const std::string& set) const {
    GlobalIndex count = 0;
    for (const LocalIndex node : run_.model.mesh.node_sets.at(set))
      count += std::ranges::binary_search(run_.model.owned, node) ? 1 : 0;
    return counted(run_.links.ranks.sum(count), "node");
  }

  [[nodiscard]] std::string nodes_of(const char* list, std::size_t entry) const {
    return nodes_of(scene::selection_name(list, entry));
  }

  [[nodiscard]] std::string faces_of(const std::string& set) const {
    const auto count = static_cast<GlobalIndex>(run_.model.mesh.side_sets.at(set).size());
    return counted(run_.links.ranks.sum(count), "face");
  }

  /// A side set of the same name as a node set is another one if it has other nodes.
  [[nodiscard]] static bool reaches_beyond(const std::vector<mesh::ExteriorFace>& sides,
                                           const std::vector<LocalIndex>& nodes) {
    const std::set<LocalIndex> known(nodes.begin(), nodes.end());
    return std::ranges::any_of(sides, [&](const mesh::ExteriorFace& side) {
      return std::ranges::any_of(side.nodes, [&](LocalIndex n) { return n != no_index && !known.contains(n); });
    });
  }

  void add_sets() {
    const mesh::LocalMesh& mesh = run_.model.mesh;
    for (std::size_t k = 0; k < run_.input.sets.size(); ++k) {
      const scene::SetEntry& set = run_.input.sets[k];
      std::string text = set.name + ": " + nodes_of("set", k);
      if (set.side_set) text += ", " + faces_of(*set.side_set);
      add("set", text);
    }
    for (const auto& [name, nodes] : mesh.node_sets) {
      if (name.front() == '@') continue;
      const auto sides = mesh.side_sets.find(name);
      if (sides != mesh.side_sets.end() && run_.links.ranks.any(reaches_beyond(sides->second, nodes))) {
        add("set of the mesh", fmt::format("node set {}: {}", excerpt(name), nodes_of(name)));
        add("set of the mesh", fmt::format("side set {}: {}", excerpt(name), faces_of(name)));
        continue;
      }
      add("set of the mesh", fmt::format("{}: {}{}", excerpt(name), nodes_of(name),
                                         sides == mesh.side_sets.end() ? "" : ", " + faces_of(name)));
    }
    for (const auto& [name, sides] : mesh.side_sets)
      if (name.front() != '@' && !mesh.node_sets.contains(name))
        add("set of the mesh", fmt::format("{}: {}", excerpt(name), faces_of(name)));
  }

  void add_motion(const scene::InitialMotion& motion, std::size_t k) {
    std::string text = fmt::format("{}: velocity {} {}", motion.where, vector_text(motion.velocity), units_.velocity);
    if (motion.spin_rate != 0)
      text +=
          fmt::format(", rotation {:g} rad/{} about {}", motion.spin_rate, units_.time, vector_text(motion.spin_axis));
    add("initial", text + ", " + nodes_of("initial", k));
  }

  void add_fixed(const scene::Fixed& fixed, std::size_t k) {
    std::string directions;
    for (std::size_t c = 0; c < 3; ++c)
      if (fixed.dofs[c]) directions += fmt::format("{}{}", directions.empty() ? "" : " ", "xyz"[c]);
    for (std::size_t c = 0; c < 3; ++c)
      if (fixed.turns[c]) directions += fmt::format("{}r{}", directions.empty() ? "" : " ", "xyz"[c]);
    add("fixed", fmt::format("{}: {}, {}", fixed.where, directions, nodes_of("fixed", k)));
  }

  void add_symmetry(const scene::Symmetry& plane, std::size_t k) {
    add("symmetry", fmt::format("plane through {} with normal {}: {}", vector_text(plane.point),
                                vector_text(plane.normal), nodes_of("symmetry", k)));
  }

  void add_prescribed(const scene::Prescribed& motion, std::size_t k) {
    using Gives = scene::Prescribed::Gives;
    const bool acceleration = motion.gives == Gives::acceleration, turns = motion.dof >= 3;
    const std::string of_turn = fmt::format("rad/{}", units_.time);
    const std::string unit = acceleration ? fmt::format("{}/{}^2", turns ? "rad" : units_.length, units_.time)
                             : turns      ? of_turn
                                          : units_.velocity;
    const std::string value = motion.curve.empty() ? fmt::format("{:g} {}", motion.scale, unit)
                                                   : fmt::format("curve {} times {:g}", motion.curve, motion.scale);
    const char* what = acceleration                          ? "acceleration"
                       : motion.gives == Gives::displacement ? "displacement"
                                                             : "velocity";
    add("prescribed", fmt::format("{}: {} {}{} {}, {}", motion.where, what, turns ? "r" : "", "xyz"[motion.dof % 3],
                                  value, nodes_of("prescribed", k)));
  }

  void add_pressure(const scene::Pressure& pressure, std::size_t k) {
    add("pressure", fmt::format("{}: {:g} {}{}, {}", pressure.where, pressure.value, units_.stress,
                                curve_text(pressure.curve), faces_of(scene::selection_name("pressure", k))));
  }

  void add_force(const scene::DeadLoad& load, std::size_t k) {
    const bool total = load.kind == scene::DeadLoad::Kind::total;
    const std::string reserved = scene::selection_name("forces", k);
    add("force",
        fmt::format("{}: {} {}{}{}, {}", load.where, vector_text(load.value), units_.force, total ? " in all" : " each",
                    curve_text(load.curve), total ? faces_of(reserved) : nodes_of(reserved)));
  }

  void add_traction(const scene::DeadLoad& load, std::size_t k) {
    add("traction", fmt::format("{}: {} {}{}, {}", load.where, vector_text(load.value), units_.stress,
                                curve_text(load.curve), faces_of(scene::selection_name("traction", k))));
  }

  void add_removal(const scene::Removal& removal, std::size_t /*k*/) {
    add("remove", fmt::format("{}: at t = {:g} {}{}", removal.where, removal.at, units_.time,
                              removal.keeps_nodes ? "" : ", nodes too"));
  }

  void add_shell(const scene::Part& part, std::size_t /*k*/) {
    const element::ShellSection& section = part.section;
    if (section.thickness == 0) return;
    const bool gauss = section.rule == element::ThicknessRule::gauss;
    std::string text = fmt::format("{}: thickness {}, {} through it ({})", part.name,
                                   scene::with_length(section.thickness, run_.input.units, 6),
                                   counted(section.points, "point"), gauss ? "gauss" : "lobatto");
    if (section.offset != 0) text += fmt::format(", middle at {:g} of it above the nodes", section.offset);
    add("shell", text + (section.thinning ? "" : ", constant") + (section.warping ? "" : ", without warping"));
  }

  /// What a metal has besides its strength.
  void add_metal(const scene::Part& part, std::size_t /*k*/) {
    const auto* metal = std::get_if<material::Metal>(&run_.input.materials.at(part.material));
    if (metal == nullptr) return;
    std::vector<std::string> has;
    using Model = material::EquationOfState::Model;
    if (metal->eos) has.push_back(metal->eos->model == Model::mie_gruneisen ? "mie_gruneisen" : "linear_polynomial");
    if (metal->heat.capacity > 0) has.push_back(fmt::format("heats from {:g}", metal->heat.start));
    if (metal->rate.form != material::RateFactor::Form::none)
      has.push_back(fmt::format("rates over {:g} 1/{}", metal->rate.reference, units_.time));
    if (metal->fracture)
      has.push_back(fmt::format("fails at damage {:g}{}", metal->fracture->critical,
                                metal->fracture->softens ? ", softens" : ""));
    if (!has.empty()) add("metal", fmt::format("{}: {}", part.name, fmt::join(has, ", ")));
  }

  void add_erosion(const scene::Part& part, std::size_t /*k*/) {
    if (!part.erosion) return;
    const model::Erosion& erosion = *part.erosion;
    std::vector<std::string> criteria;
    const auto tell = [&](const char* name, const std::optional<double>& value, const std::string& unit) {
      if (value) criteria.push_back(fmt::format("{} {:g}{}{}", name, *value, unit.empty() ? "" : " ", unit));
    };
    tell("damage", erosion.damage, "");
    tell("plastic strain", erosion.plastic_strain, "");
    tell("pressure", erosion.pressure, units_.stress);
    tell("volume", erosion.volume, "");
    tell("step", erosion.step, units_.time);
    add("erosion", fmt::format("{}: {}, {}; nodes {}", part.name, fmt::join(criteria, ", "),
                               erosion.points == model::Erosion::Points::any ? "any point" : "mean of points",
                               erosion.keeps_nodes ? "stay" : "go too"));
  }

  void add_fields() {
    if (const auto& relaxation = run_.input.relaxation)
      add("relaxation",
          fmt::format("before t = 0, to {:g}, {} steps at most", relaxation->tolerance, relaxation->max_steps));
    if (const auto& gravity = run_.input.gravity)
      add("gravity", fmt::format("{} {}/{}^2{}", vector_text(gravity->vector), units_.length, units_.time,
                                 curve_text(gravity->curve)));
    if (const auto& damping = run_.input.damping)
      add("damping", fmt::format("{:g} 1/{} from {:g}{}", damping->alpha, units_.time, damping->from,
                                 std::isfinite(damping->to) ? fmt::format(" to {:g}", damping->to) : " on"));
  }

  const Prepared& run_;
  const scene::UnitSystem& units_;
};

}  // namespace

std::vector<std::string> list_scene(const Prepared& run) {
  return Listing(run).lines;
}

}  // namespace brunt::app
