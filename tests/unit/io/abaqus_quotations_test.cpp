// SPDX-License-Identifier: Apache-2.0
// What faults and notes quote of an Abaqus file: at most 60 characters on one line, wherever a long text stands.
#include <catch2/catch.hpp>
#include <functional>
#include <string_view>
#include <vector>

#include "abaqus_text.hpp"

using namespace brunt;

namespace {

const std::string mesh_data = R"(*NODE, NSET=EVERY, SYSTEM=R
1, 0, 0, 0
2, 1, 0, 0
3, 1, 1, 0
4, 0, 1, 0
5, 0, 0, 1
6, 1, 0, 1
7, 1, 1, 1
8, 0, 1, 1
*ELEMENT, TYPE=C3D8R, ELSET=BAR
1, 1, 2, 3, 4, 5, 6, 7, 8
*ELEMENT, TYPE=S4R, ELSET=SKIN
2, 1, 2, 3, 4
*ELEMENT, TYPE=T3D2, ELSET=ROD
3, 1, 2
*NSET, NSET=FOOT
1, 2, EVERY
*NSET, NSET=FOOT
"EVERY", 3
*NSET, NSET=RANGE, GENERATE
1, 999, 2
*NSET, NSET=OF, ELSET=BAR
*ELSET, ELSET=ALL, GENERATE
1, 9
*SURFACE, NAME=TOP, TYPE=ELEMENT
BAR, S1
1, S2
*SURFACE, NAME=FOOT
BAR, S1
*SURFACE, NAME=POINTS, TYPE=NODE
FOOT,
*SURFACE, NAME=ROUND, TYPE=CYLINDER
1, 2, 3
*SYSTEM
0, 0, 0, 1, 0, 0
*SOLID SECTION, ELSET=BAR, MATERIAL=STEEL
*SHELL SECTION, ELSET=SKIN
*STRANGE, WORD=TEXT
)";

const std::string assembly = R"(*ASSEMBLY, NAME=A
*INSTANCE, NAME=I, PART=P
1, 0, 0
0, 0, 0, 1, 0, 0, 90
*END INSTANCE
*NODE, NSET=POINT
1, 0, 0, 0
*ELEMENT, TYPE=MASS, ELSET=BALL
1, 1
*NSET, NSET=HELD, INSTANCE=I
1, FOOT
*NSET, NSET=MORE
I.1, I.FOOT, POINT
*END ASSEMBLY
*STEP, NAME=S
*END STEP
)";

const std::vector<std::string> decks{
    mesh_data, mesh_data + "*INCLUDE, INPUT=no.inp\n",
    "*PART, NAME=P\n" + mesh_data + "*END PART\n*PART, NAME=UNUSED\n" + mesh_data + "*END PART\n" + assembly};

/// Everything that a user would read.
std::string told(const std::string& text) {
  try {
    std::string all;
    for (const std::string& note : test::read(text).notes) all += note + '\n';
    return all;
  } catch (const InputError& error) {
    std::string all;
    for (const std::string& fault : error.faults()) all += fault + '\n';
    return all;
  }
}

/// Each field in turn has this text in its place, or behind it.
void for_each_field(const std::string& deck, const std::string& text, const std::function<void(std::string)>& use) {
  constexpr std::string_view marks = ",=\n*. ";
  for (std::size_t from = 0; from < deck.size();) {
    const std::size_t end = std::min(deck.find_first_of(marks, from), deck.size());
    if (end > from) {
      const std::string field = deck.substr(from, end - from), before = deck.substr(0, from), behind = deck.substr(end);
      use(before + text + behind);
      use(before + field + text + behind);
    }
    from = end + 1;
  }
}

}  // namespace

TEST_CASE("abaqus: quotations are short, wherever a long text stands") {
  std::size_t quoted = 0;
  for (const std::string& deck : decks)
    for (const std::string& text : {std::string(300, 'X'), '"' + std::string(300, 'x') + '"', std::string(300, '\xe9')})
      for_each_field(deck, text, [&](const std::string& changed) {
        const std::string all = told(changed);
        INFO(all.substr(0, 600));
        if (all.find(std::string(61, text[1])) != std::string::npos) FAIL("a quotation of more than 60 characters");
        if (all.find('\xe9') != std::string::npos) FAIL("a byte that is no text");
        quoted += all.find(std::string(60, text[1])) != std::string::npos ? 1 : 0;
      });
  CHECK(quoted > 100);
}

TEST_CASE("abaqus: quotations of names that stand twice are short") {
  std::string deck = "*PART, NAME=P\n" + mesh_data + "*END PART\n" + assembly;
  for (const std::string name : {"P", "I", "EVERY", "BAR", "SKIN", "ROD", "FOOT", "RANGE", "OF", "ALL", "TOP", "POINTS",
                                 "ROUND", "HELD", "MORE"}) {
    std::string changed;  // the name everywhere, so that references to it still hold
    for (std::size_t at = 0; at < deck.size();) {
      const bool starts = at == 0 || std::string_view("=, .\n\"").find(deck[at - 1]) != std::string_view::npos;
      const std::size_t end = at + name.size();
      const bool ends = end >= deck.size() || std::string_view(",.\n\" ").find(deck[end]) != std::string_view::npos;
      const bool here = starts && ends && deck.compare(at, name.size(), name) == 0;
      changed += here ? std::string(300, 'X') : deck.substr(at, 1);
      at = here ? end : at + 1;
    }
    for (const std::string& more : {std::string(), "*PART, NAME=" + std::string(300, 'X') + "\n*END PART\n"}) {
      const std::string all = told(changed + more);
      INFO(name << ": " << all.substr(0, 600));
      CHECK(all.find(std::string(61, 'X')) == std::string::npos);
    }
  }
}
