// SPDX-License-Identifier: Apache-2.0
// Checks that a classic netCDF file has all the bytes that its header requires.
#pragma once
#include <string>

namespace brunt::io {

/// Empty if it has (or if the file is no classic netCDF file: HDF5 checks its own files), otherwise the fault.
/// Format: NetCDF Classic Format Specification, versions 1, 2 (64-bit offset) and 5 (64-bit data).
std::string netcdf_layout_fault(const std::string& path);

}  // namespace brunt::io
