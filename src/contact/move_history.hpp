// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace brunt::contact {

struct Contact;

/// Sends the records of the history to the ranks that create their rows. The row of an edge is created on the rank of
/// the face with the lower key, which may be another one after a change of the surface. Records whose node or edge is
/// no longer on the surface are dropped. Collective.
void move_history(Contact& contact);

}  // namespace brunt::contact
