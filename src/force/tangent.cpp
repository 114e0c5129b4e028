// SPDX-License-Identifier: Apache-2.0
#include "force/tangent.hpp"

#include <fmt/core.h>

#include <variant>

#include "core/error.hpp"
#include "tangent_loop.hpp"

namespace brunt::force {
namespace {

Tangents tangents_of(element::ElementKind kind) {
  switch (kind) {
    case element::ElementKind::hex8_full:
      return hex8_full_tangents;
    case element::ElementKind::hex8_bbar:
      return hex8_bbar_tangents;
    case element::ElementKind::tet4:
      return tet4_tangents;
    case element::ElementKind::hex8:
    case element::ElementKind::shell4:
    case element::ElementKind::shell4_full:
    case element::ElementKind::shell3:
      break;
  }
  return nullptr;
}

}  // namespace

bool gives_tangents(element::ElementKind kind) {
  return tangents_of(kind) != nullptr;
}

bool gives_tangents(const material::Law& law) {
  return std::holds_alternative<material::Elastic>(law) || std::holds_alternative<material::J2>(law) ||
         std::holds_alternative<material::NeoHookean>(law);
}

void element_tangents(const model::Model& model, LocalIndex block, std::span<const LocalIndex> elements,
                      const Motion& motion, const History& committed, std::span<double> matrices) {
  const model::ElementBlock& of = nth(model.blocks, block);
  const Tangents tangents = tangents_of(of.kind);
  if (tangents == nullptr)
    throw InputError(
        fmt::format("part {}: invalid element {}: it has no tangent; expected hex8_full, hex8_bbar or tet4", of.part,
                    element::name_of(of.kind)));
  tangents(of, {model, block, elements, motion, committed, matrices});
}

}  // namespace brunt::force
