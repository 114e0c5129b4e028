// SPDX-License-Identifier: Apache-2.0
// From the model's nodes to contact nodes and back.
#pragma once
#include "contact/contact.hpp"

namespace brunt::contact {

GatherPlan plan_gather(const Surface& surface, const ContactLists& lists);

/// Motion of contact nodes and area vectors of faces, of all ranks. Collective.
void gather(const StepInput& input, const GatherPlan& plan, ContactLists& lists, StepData& step);

/// Velocities after contact, on every copy of a node. Collective.
void scatter(Contact& contact, MutableVectorView velocity);

}  // namespace brunt::contact
