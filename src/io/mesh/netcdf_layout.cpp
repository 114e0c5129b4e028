// SPDX-License-Identifier: Apache-2.0
// Walks the header of a classic netCDF file and adds up where its variables end.
#include "netcdf_layout.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <vector>

namespace brunt::io {
namespace {

struct Broken : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Sizes are doubles: exact to 2^53 bytes, and a damaged header cannot overflow them.
class Header {
 public:
  Header(const std::string& path, double size) : file_(path, std::ios::binary), size_(size) {}

  /// Where the last variable ends; 0 if this is no classic netCDF file.
  double end_of_data() {
    char magic[4] = {};
    file_.read(magic, 4);
    if (!file_ || magic[0] != 'C' || magic[1] != 'D' || magic[2] != 'F') return 0;
    version_ = static_cast<unsigned char>(magic[3]);
    if (version_ != 1 && version_ != 2 && version_ != 5) throw Broken("unknown version of netCDF; expected 1, 2 or 5");
    const double records = count();
    read_dimensions();
    skip_attributes();
    return read_variables(records == streaming() ? 0 : records);
  }

 private:
  struct Extent {
    double begin, bytes, padded;
  };

  std::uint64_t big_endian(int bytes) {
    std::uint64_t value = 0;
    for (int i = 0; i < bytes; ++i) {
      const int byte = file_.get();
      if (byte < 0) throw Broken("invalid netCDF file: truncated in its header; expected an undamaged file");
      value = (value << 8) | static_cast<std::uint64_t>(byte);
    }
    return value;
  }
  double count() { return static_cast<double>(big_endian(version_ == 5 ? 8 : 4)); }
  [[nodiscard]] double streaming() const { return version_ == 5 ? 18446744073709551615.0 : 4294967295.0; }

  /// Number of entries of a list, each of which takes at least four bytes.
  std::size_t list_length() {
    const double n = count();
    if (4 * n > size_)
      throw Broken("invalid netCDF header: a list is longer than the file; expected an undamaged file");
    return static_cast<std::size_t>(n);
  }
  void skip_padded(double bytes) {
    if (bytes > size_)
      throw Broken("invalid netCDF header: a value is longer than the file; expected an undamaged file");
    const auto n = (static_cast<std::streamoff>(bytes) + 3) / 4 * 4;
    file_.seekg(n, std::ios::cur);
  }
  /// Length of a list that may be absent (tag 0).
  std::size_t tagged_list(std::uint64_t tag) {
    const auto found = big_endian(4);
    const auto n = list_length();
    if (found != tag && !(found == 0 && n == 0))
      throw Broken("invalid netCDF header: a list has the wrong tag; expected an undamaged file");
    return n;
  }
  static double type_size(std::uint64_t type) {
    switch (type) {
      case 1:
      case 2:
      case 7:
        return 1;
      case 3:
      case 8:
        return 2;
      case 4:
      case 5:
      case 9:
        return 4;
      case 6:
      case 10:
      case 11:
        return 8;
      default:
        throw Broken("invalid netCDF header: a variable of unknown type; expected an undamaged file");
    }
  }
  void read_dimensions() {
    for (std::size_t i = tagged_list(10); i > 0; --i) {
      skip_padded(count());
      dimension_.push_back(count());
    }
  }
  void skip_attributes() {
    for (std::size_t i = tagged_list(12); i > 0; --i) {
      skip_padded(count());
      const double size = type_size(big_endian(4));
      skip_padded(size * count());
    }
  }

  double read_variables(double records) {
    double end = 0;
    std::vector<Extent> recorded;
    for (std::size_t i = tagged_list(11); i > 0; --i) {
      skip_padded(count());
      double values = 1;
      bool by_record = false;
      const std::size_t rank = list_length();
      for (std::size_t d = 0; d < rank; ++d) {
        const auto id = static_cast<std::size_t>(count());
        if (id >= dimension_.size())
          throw Broken("invalid netCDF header: an unknown dimension; expected an undamaged file");
        by_record |= d == 0 && dimension_[id] == 0;
        values *= d == 0 && dimension_[id] == 0 ? 1 : dimension_[id];
      }
      skip_attributes();
      const double bytes = values * type_size(big_endian(4));
      count();  // vsize: redundant, and capped in large files
      const auto begin = static_cast<double>(big_endian(version_ == 1 ? 4 : 8));
      if (by_record)
        recorded.push_back({begin, bytes, 4 * std::ceil(bytes / 4)});
      else
        end = std::max(end, begin + bytes);
    }
    double record = 0;
    for (const Extent& e : recorded) record += recorded.size() == 1 ? e.bytes : e.padded;
    if (records > 0)
      for (const Extent& e : recorded) end = std::max(end, e.begin + (records - 1) * record + e.bytes);
    return end;
  }

  std::ifstream file_;
  double size_;
  int version_ = 0;
  std::vector<double> dimension_;
};

}  // namespace

std::string netcdf_layout_fault(const std::string& path) {
  const auto size = static_cast<double>(std::filesystem::file_size(path));
  try {
    const double needed = Header(path, size).end_of_data();
    if (needed > size)
      return fmt::format(
          "invalid netCDF file, truncated or damaged: its header requires {:.0f} bytes, and the file has {:.0f}; "
          "expected an undamaged file",
          needed, size);
  } catch (const Broken& broken) {
    return broken.what();
  }
  return {};
}

}  // namespace brunt::io
