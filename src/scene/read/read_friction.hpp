// SPDX-License-Identifier: Apache-2.0
// The key `friction` of contact and of rigid walls: a coefficient, or a map of static, kinetic, decay and lag.
#pragma once
#include "contact/data/options.hpp"
#include "scene/keys/table.hpp"

namespace brunt::scene {

extern const Table<contact::FrictionLaw> friction_keys;

void read_friction(const Key& key, contact::FrictionLaw& law);

template <class T>
Value<T> friction_of(contact::FrictionLaw T::*member) {
  return {.type = "number >= 0 or map",
          .read = [=](const Key& key, T& target) { read_friction(key, target.*member); },
          .shown = [=](const T& target) { return shown((target.*member).fixed); },
          .inner = {&friction_keys}};
}

}  // namespace brunt::scene
