// SPDX-License-Identifier: Apache-2.0
// Does a classic netCDF file hold all the bytes that its header promises?
#pragma once
#include <string>

namespace brunt::io {

/// Empty if so (or if the file is no classic netCDF file: HDF5 checks itself), else what is wrong.
/// Format: NetCDF Classic Format Specification, versions 1, 2 (64-bit offset) and 5 (64-bit data).
std::string netcdf_layout_fault(const std::string& path);

}  // namespace brunt::io
