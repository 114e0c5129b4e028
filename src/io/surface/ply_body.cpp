// SPDX-License-Identifier: Apache-2.0
// PLY: numbers of the entries (see the header).
#include "ply_body.hpp"

#include <fmt/core.h>

#include "core/error.hpp"
#include "core/excerpt.hpp"
#include "raw_number.hpp"

namespace brunt::io {

PlyAsciiBody::PlyAsciiBody(std::string_view content, const std::string& name, const PlyHeader& header)
    : name_(name), in_(content.substr(header.size), name, LineSyntax::plain, header.lines) {}

void PlyAsciiBody::begin(const PlyElement& element, std::int64_t entry) {
  if (!in_.next_filled_line())
    in_.fail(fmt::format("missing entries: the file is truncated; expected {} {} of {}", excerpt(element.name),
                         entry + 1, element.count));
}

void PlyAsciiBody::end() {
  if (const std::string_view word = in_.word(); !word.empty())
    in_.fail(fmt::format("unknown text '{}'; expected the end of the line", excerpt(word)));
}

void PlyAsciiBody::need_end() {
  if (in_.next_filled_line())
    in_.fail(fmt::format("unknown text '{}' after the last entry; expected the end of the file", excerpt(in_.word())));
}

std::int64_t PlyAsciiBody::integer(PlyType /*type*/, std::string_view what) {
  return in_.integer(what);
}

double PlyAsciiBody::real(PlyType /*type*/, std::string_view what) {
  return in_.real(what);
}

void PlyAsciiBody::skip(PlyType /*type*/, std::int64_t count) {
  for (std::int64_t k = 0; k < count; ++k)
    if (in_.word().empty())
      in_.fail("missing value at the end of the line; expected one for each property of the entry");
}

/// Lists end with their line at the latest.
void PlyAsciiBody::need_room(PlyType /*type*/, std::int64_t /*count*/) const {}

std::string PlyAsciiBody::where(const PlyElement& /*element*/, std::int64_t /*entry*/, std::int64_t place) const {
  return fmt::format("{}:{}", name_, place);
}

PlyBinaryBody::PlyBinaryBody(std::string_view content, const std::string& name, const PlyHeader& header)
    : content_(content),
      name_(name),
      order_(header.encoding == PlyEncoding::big_endian ? std::endian::big : std::endian::little),
      at_(header.size) {}

void PlyBinaryBody::begin(const PlyElement& element, std::int64_t entry) {
  element_ = &element;
  entry_ = entry;
}

void PlyBinaryBody::need_end() {
  if (at_ < content_.size())
    throw InputError(
        fmt::format("{}: invalid content: {} bytes follow the last entry, from byte {}; expected the end of the file",
                    name_, content_.size() - at_, at_));
}

template <class T>
T PlyBinaryBody::take() {
  if (content_.size() - at_ < sizeof(T)) fail("missing bytes: the file is truncated; expected the rest of the entry");
  const T value = raw_number<T>(content_.data() + at_, order_);
  at_ += sizeof(T);
  return value;
}

std::int64_t PlyBinaryBody::integer(PlyType type, std::string_view /*what*/) {
  switch (type) {
    case PlyType::int8:
      return take<std::int8_t>();
    case PlyType::uint8:
      return take<std::uint8_t>();
    case PlyType::int16:
      return take<std::int16_t>();
    case PlyType::uint16:
      return take<std::uint16_t>();
    case PlyType::int32:
      return take<std::int32_t>();
    case PlyType::uint32:
      return take<std::uint32_t>();
    case PlyType::float32:
    case PlyType::float64:
      break;
  }
  demand(false, "invalid type of an index; expected an integer type");
  return 0;
}

double PlyBinaryBody::real(PlyType type, std::string_view what) {
  if (type == PlyType::float32) return static_cast<double>(take<float>());
  if (type == PlyType::float64) return take<double>();
  return static_cast<double>(integer(type, what));
}

void PlyBinaryBody::skip(PlyType type, std::int64_t count) {
  need_room(type, count);
  at_ += size_of(type) * static_cast<std::size_t>(count);
}

void PlyBinaryBody::need_room(PlyType type, std::int64_t count) const {
  const auto most = (content_.size() - at_) / size_of(type);
  if (static_cast<std::uint64_t>(count) > most)
    fail("missing bytes: the file is truncated; expected the rest of the entry");
}

std::string PlyBinaryBody::where(const PlyElement& element, std::int64_t entry, std::int64_t place) const {
  return fmt::format("{}: {} {} of {}, byte {}", name_, excerpt(element.name), entry + 1, element.count, place);
}

void PlyBinaryBody::fail(const std::string& fault) const {
  throw InputError(fmt::format("{}: {}", where(*element_, entry_, place()), fault));
}

}  // namespace brunt::io
