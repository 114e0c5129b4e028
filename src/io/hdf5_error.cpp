// SPDX-License-Identifier: Apache-2.0
// Why an HDF5 call failed, in one text that is the same on all ranks.
#include "core/error.hpp"
#include "hdf5_handle.hpp"
#include "io/hdf5.hpp"

namespace brunt::io {

std::string hdf5_reason() {
  std::string reason;
  const auto keep_first = [](unsigned /*depth*/, const H5E_error2_t* error, void* text) -> herr_t {
    auto& kept = *static_cast<std::string*>(text);
    if (kept.empty() && error->desc != nullptr) kept = error->desc;
    return 0;
  };
  H5Ewalk2(H5E_DEFAULT, H5E_WALK_UPWARD, keep_first, &reason);
  return reason.empty() ? "unknown reason" : reason;
}

std::string first_reason(const comm::Communicator& ranks, const std::string& mine) {
  const auto* bytes = reinterpret_cast<const std::byte*>(mine.data());
  std::string reason;
  for (const std::vector<std::byte>& text : ranks.gather({bytes, mine.size()}))
    if (reason.empty()) reason.assign(reinterpret_cast<const char*>(text.data()), text.size());
  ranks.broadcast(reason);
  return reason;
}

std::string Hdf5File::fault(std::string_view action, const std::string& object, bool good) const {
  const std::string reason = first_reason(ranks_, good ? "" : hdf5_reason());
  const std::string what = object.empty() ? "" : " " + object;
  return path_ + ": cannot " + std::string(action) + what + ": " + reason;
}

void Hdf5File::require_written(bool good, std::string_view action, const std::string& object) const {
  if (ranks_.any(!good)) throw MachineError(fault(action, object, good));
}

void Hdf5File::require_read(bool good, std::string_view action, const std::string& object) const {
  if (ranks_.any(!good)) throw InputError(fault(action, object, good));
}

}  // namespace brunt::io
