// SPDX-License-Identifier: Apache-2.0
#include "abaqus_numbers.hpp"

#include <fmt/core.h>

#include <algorithm>

#include "core/excerpt.hpp"

namespace brunt::io {

const std::vector<std::int64_t>& AbaqusNumbers::all(Kind kind) {
  const bool of_nodes = kind == Kind::node;
  std::vector<std::int64_t>& numbers = of_nodes ? nodes_ : elements_;
  if (std::exchange(of_nodes ? has_nodes_ : has_elements_, true)) return numbers;
  if (part_ == nullptr) {
    const auto& known = of_nodes ? assembly_->assembly_nodes : assembly_->assembly_elements;
    numbers.assign(known.begin(), known.end());
    return numbers;
  }
  if (of_nodes) {
    numbers = part_->node_number;
  } else {
    for (const AbaqusElement& one : part_->elements) numbers.push_back(one.number);
    for (const AbaqusOther& one : part_->others) numbers.push_back(one.number);
  }
  std::ranges::sort(numbers);
  return numbers;
}

std::vector<std::int64_t> existing(const AbaqusDeck& deck, const AbaqusMembers& members, AbaqusNumbers& numbers,
                                   AbaqusNumbers::Kind kind, const std::string& name, std::set<std::string>& notes) {
  const std::vector<std::int64_t>& all = numbers.all(kind);
  const std::string_view what = kind == AbaqusNumbers::Kind::node ? "node" : "element";
  if (!members.generated) {
    if (!std::ranges::binary_search(all, members.first))
      deck.fail(members.line, fmt::format("unknown {0} {1} of '{2}'; expected the number of a {0} of the file", what,
                                          members.first, excerpt(name)));
    return {members.first};
  }
  std::vector<std::int64_t> found;
  for (auto at = std::ranges::lower_bound(all, members.first); at != all.end() && *at <= members.last; ++at)
    if ((*at - members.first) % members.step == 0) found.push_back(*at);
  const std::int64_t named = (members.last - members.first) / members.step + 1;
  const std::string range =
      fmt::format("GENERATE {}, {}, {} of '{}'", members.first, members.last, members.step, excerpt(name));
  if (found.empty())
    deck.fail(members.line, fmt::format("invalid {0}: no {1} has one of these numbers; expected a range with existing "
                                        "{1}s",
                                        range, what));
  if (static_cast<std::int64_t>(found.size()) < named)
    notes.insert(
        fmt::format("{}: {}: {} of its {} numbers exist", deck.place(members.line), range, found.size(), named));
  return found;
}

}  // namespace brunt::io
