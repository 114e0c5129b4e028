// SPDX-License-Identifier: Apache-2.0
#include "contact/surface/passes.hpp"

namespace brunt::contact {

Pass pass_of(const Row& row, const SurfaceNode& node, GlobalIndex master_gid, const Specification& specification,
             std::span<const BodyFigures> bodies) {
  if (!meet_in_two_passes(specification, bodies, node, row.master_block, row.master_body)) return Pass::both;
  if (row.slave_body != row.master_body)
    return is_primary_slave(specification, bodies, node, row.master_block, row.master_body) ? Pass::first
                                                                                            : Pass::second;
  return row.key.slave < master_gid ? Pass::first : Pass::second;
}

}  // namespace brunt::contact
