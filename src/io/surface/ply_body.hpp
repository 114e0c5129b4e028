// SPDX-License-Identifier: Apache-2.0
// Numbers of the entries of a PLY file, in text or in binary: two classes with the same functions.
#pragma once
#include <bit>
#include <cstdint>
#include <string>
#include <string_view>

#include "ply_header.hpp"
#include "surface_text.hpp"

namespace brunt::io {

/// One line an entry.
class PlyAsciiBody {
 public:
  PlyAsciiBody(std::string_view content, const std::string& name, const PlyHeader& header);

  void begin(const PlyElement& element, std::int64_t entry);  ///< goes to an entry
  void end();                                                 ///< its line must end
  void need_end();                                            ///< so must the file

  std::int64_t integer(PlyType type, std::string_view what);
  double real(PlyType type, std::string_view what);
  void skip(PlyType type, std::int64_t count);
  void need_room(PlyType type, std::int64_t count) const;  ///< for entries of a list; else a fault

  [[nodiscard]] std::int64_t place() const { return in_.line(); }
  [[nodiscard]] std::string where(const PlyElement& element, std::int64_t entry, std::int64_t place) const;
  [[noreturn]] void fail(const std::string& fault) const { in_.fail(fault); }

 private:
  const std::string& name_;
  TextCursor in_;
};

class PlyBinaryBody {
 public:
  PlyBinaryBody(std::string_view content, const std::string& name, const PlyHeader& header);

  void begin(const PlyElement& element, std::int64_t entry);
  void end() {}
  void need_end();

  std::int64_t integer(PlyType type, std::string_view what);
  double real(PlyType type, std::string_view what);
  void skip(PlyType type, std::int64_t count);
  void need_room(PlyType type, std::int64_t count) const;

  [[nodiscard]] std::int64_t place() const { return static_cast<std::int64_t>(at_); }
  [[nodiscard]] std::string where(const PlyElement& element, std::int64_t entry, std::int64_t place) const;
  [[noreturn]] void fail(const std::string& fault) const;

 private:
  template <class T>
  T take();

  std::string_view content_;
  const std::string& name_;
  std::endian order_;
  std::size_t at_;  // byte that comes next
  const PlyElement* element_ = nullptr;
  std::int64_t entry_ = 0;
};

}  // namespace brunt::io
