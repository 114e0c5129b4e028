// SPDX-License-Identifier: Apache-2.0
// Contact between parts.
#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "core/excerpt.hpp"
#include "read_enforcement.hpp"
#include "read_friction.hpp"
#include "scene/read/sections.hpp"

namespace brunt::scene {
namespace {

using contact::Multiplier;
using contact::Passes;
using Enforce = contact::MortarPair::Enforce;
using Overlap = contact::OverlapRule;
using Slave = ContactEntry::Slave;

const Choices<Passes> passes_words{{{"auto", Passes::automatic},
                                    {"one", Passes::one},
                                    {"two", Passes::two},
                                    {"mortar", Passes::mortar},
                                    {"averaged", Passes::averaged}},
                                   {}};
const Choices<Overlap> overlap_words{{{"error", Overlap::error},
                                      {"warn", Overlap::warn},
                                      {"move", Overlap::move},
                                      {"place", Overlap::place},
                                      {"offset", Overlap::offset}},
                                     {}};
const Choices<Slave> slave_words{{{"auto", Slave::automatic}, {"first", Slave::first}, {"second", Slave::second}}, {}};
const Choices<Multiplier> multiplier_words{{{"dual", Multiplier::dual}, {"standard", Multiplier::standard}}, {}};
const Choices<Enforce> enforce_words{{{"lagrange", Enforce::lagrange}, {"penalty", Enforce::penalty}}, {}};
constexpr Overlap overlap_of_ties = Overlap::offset;  // ties keep nodes at their positions

/// An entry of the list, with the settings of all contact after it.
struct Entry {
  ContactEntry contact;
  Enforcement enforcement;
};

/// Two parts, or one given twice: self-contact.
bool read_pair(const Key& key, std::array<std::string, 2>& pair, std::string_view expected) {
  const std::vector<Key> names = items(key, expected, 2);
  return names.size() == 2 && read(names[0], pair[0], Named::part) && read(names[1], pair[1], Named::part);
}

void read_between(const Key& key, ContactEntry& contact) {
  constexpr std::string_view expected = "all, or two parts [a, b]";
  static const Choices<bool> words{{{"all", true}}, {}};
  bool all = true;
  std::array<std::string, 2> pair;
  if (is_value(key))
    read(key, all, words);
  else if (read_pair(key, pair, expected))
    contact.between = {pair[0], pair[1]};
}

void read_exclude(const Key& key, ContactEntry& contact) {
  for (const Key& entry : items(key, "a list of pairs of parts [[a, b], ...]")) {
    std::array<std::string, 2> pair;
    if (read_pair(entry, pair, "a pair of parts [a, b]")) contact.exclude.push_back(pair);
  }
}

/// `between` has been read: its parts may be named.
void read_slave(const Key& key, ContactEntry& contact) {
  const std::vector<std::string>& parts = contact.between;
  if (parts.empty() && is_value(key) && key.tree->text != "auto")
    return fault(key,
                 fmt::format("invalid slave '{}' for between: all; expected auto, or an entry with between: [a, b]",
                             excerpt(key.tree->text)));
  Choices<Slave> words = slave_words;
  for (std::size_t k = 0; k < parts.size(); ++k)
    if (k == 0 || parts[k] != parts[0]) words.now.emplace_back(parts[k], k == 0 ? Slave::first : Slave::second);
  read(key, contact.slave, words);
}

/// Only one value exists in this version.
void read_thickness(const Key& key, ContactEntry&) {
  if (key.tree->text != "auto") later(key, "a thickness of contact", "auto");
}

/// `mortar`, or a method of enforcement.
void read_method(const Key& key, Entry& entry) {
  entry.contact.mortar = is_value(key) && key.tree->text == "mortar";
  if (!entry.contact.mortar) read(key, entry.enforcement.settings.method, methods());
}

void judge_tied(const Key& map, ContactEntry& contact) {
  if (!contact.tied) return;
  const Key key = at(map, "tied");
  if (is_value(at(map, "between")))
    fault(key, "invalid tied for between: all; expected tied: true with between: [a, b]");
  if (!contact.between.empty() && contact.between[0] == contact.between[1])
    fault(key, "invalid tied: a part cannot be tied to itself; expected between: [a, b] with two parts");
  if (contact.friction.any()) fault(key, "invalid friction of tied parts; expected no friction with tied: true");
  if (!has(map, "initial_overlap")) contact.initial_overlap = overlap_of_ties;
  if (contact.initial_overlap == Overlap::place)
    fault(at(map, "initial_overlap"), "invalid initial_overlap of tied parts; expected error, warn, move or offset");
}

/// Keys of mortar contact, and keys that it does not have.
void judge_mortar(const Key& map, const ContactEntry& contact) {
  if (!contact.mortar)
    return refuse_any(map, {"multiplier", "enforce", "consistent", "edges"},
                      "invalid without method: mortar; expected no such key");
  const auto refuse = [&](bool wrong, const char* key, const char* why) {
    if (wrong) fault(at(map, key), why);
  };
  const bool itself = contact.between.size() == 2 && contact.between[0] == contact.between[1];
  const bool all = is_value(at(map, "between")) && at(map, "between").tree->text == "all";
  refuse(all && !contact.tied, "between",  // ties of all parts are reported elsewhere
         "invalid between for method: mortar; expected two parts [a, b], or one twice [a, a]");
  refuse(itself && contact.slave != Slave::automatic, "slave",
         "invalid for a part with itself, whose facets are slaves and masters by turns; expected no such key");
  refuse(itself && contact.initial_overlap != Overlap::error && has(map, "initial_overlap"), "initial_overlap",
         "invalid for method: mortar of a part with itself; expected error");
  refuse(itself && has(map, "edges"), "edges", "invalid for a part with itself; expected no such key");
  refuse(has(map, "exclude"), "exclude", "invalid with method: mortar; expected this key with between: all only");
  refuse(contact.friction.kinetic != contact.friction.fixed || contact.friction.lag > 0, "friction",
         "invalid friction for method: mortar, which has Coulomb's law with one coefficient; expected a number >= 0");
  refuse(contact.tied && contact.enforce == Enforce::penalty, "enforce",
         "invalid enforcement of a tie; expected lagrange");
  refuse(contact.tied && has(map, "consistent"), "consistent",
         "invalid with tied: true, whose forces are consistent; expected no such key");
  refuse(contact.tied && has(map, "edges"), "edges",
         "invalid with tied: true, which holds what meets at the start; expected no such key");
  refuse_any(map,
             {"passes", "tolerance", "max_iterations", "softness", "impact", "partition", "stiffness", "damping",
              "competing", "rebuild"},
             "invalid with method: mortar; expected multiplier, enforce, slave, consistent, edges, friction or tied");
}

/// Passes, and settings without effect.
void judge_passes(const Key& map, const ContactEntry& contact) {
  if (has(map, "self") && !contact.between.empty())
    warn(at(map, "self"), "no effect with two parts; a part meets itself by between: all, or [a, a]");
  const bool two = contact.passes == Passes::two || contact.passes == Passes::averaged;
  const bool mortar = contact.passes == Passes::mortar;
  if (two && contact.slave != Slave::automatic) warn(at(map, "slave"), "no effect with two passes");
  if ((two || mortar) && contact.friction.lag > 0)
    fault(at(map, "passes"), "invalid lag of friction with two passes or mortar rows; expected passes: auto or one");
  if (mortar && contact.tied) warn(at(map, "passes"), "no effect with tied: true: a tie has rows of its own");
  if (two && contact.tied) warn(at(map, "passes"), "no effect with tied: true: a tie has one pass");
}

/// What an entry says by itself.
void judge_entry(const Key& map, Entry& entry) {
  ContactEntry& contact = entry.contact;
  judge_tied(map, contact);
  if (has(map, "limit") && contact.initial_overlap != Overlap::place)
    fault(at(map, "limit"), "invalid without initial_overlap: place; expected no limit");
  judge_mortar(map, contact);
}

std::vector<Row<ContactEntry>> rows_of_contact() {
  return {
      {"between", special("`all` or list of 2 parts", read_between), "-",
       "All exterior faces, a pair `[a, b]`, or `[a, a]` for a part with itself.", required},
      {"exclude", special("list of pairs", read_exclude), "-", "With `all`: pairs `[[a, b]]` without contact."},
      {"self", value(&ContactEntry::self), "-", "With `all`: whether a part may touch itself."},
      {"friction", friction_of(&ContactEntry::friction), "-", "Coefficient of Coulomb friction."},
      {"passes", value(&ContactEntry::passes, passes_words), "-",
       "One pass holds slave nodes, two hold the nodes of both sides. See below."},
      {"slave", special(phrase(Slave::automatic, slave_words) + " or name", read_slave), "-",
       "Slave in one pass: by default the finer, of equal meshes the lighter part.",
       shown(ContactEntry{}.slave, slave_words)},
      {"tied", value(&ContactEntry::tied), "-", "Whether the pair is joined where its surfaces meet at the start."},
      {"initial_overlap", value(&ContactEntry::initial_overlap, overlap_words), "-",
       "What happens to nodes inside another part at the start. See below.",
       fmt::format("{}; tied {}", shown(ContactEntry{}.initial_overlap, overlap_words),
                   shown(overlap_of_ties, overlap_words))},
      {"limit", value(&ContactEntry::limit, positive), "length",
       "With `place`: largest displacement of a point of a part; beyond it the scene is refused. "
       "[Default](#placement-limit).",
       fmt::format("{} overlaps", most_overlaps)},
      {"thickness", special("`auto`", read_thickness), "-", "Reserved.", "`auto`"},
      {"multiplier", value(&ContactEntry::multiplier, multiplier_words), "-",
       "Of `mortar`: basis of the Lagrange multipliers."},
      {"enforce", value(&ContactEntry::enforce, enforce_words), "-",
       "Of `mortar`: exact constraints, or pressure = E/edge times the penetration."},
      {"consistent", value(&ContactEntry::consistent), "-",
       "Of `mortar`: pressures act through the [exact gradient of the "
       "gaps](../contact/mortar/README.md#consistent-forces): no energy from curved surfaces, more iterations."},
      {"edges", value(&ContactEntry::edges), "-",
       "Of `mortar`: for bodies with sharp edges and corners. [Sharp edges](../contact/mortar/README.md#sharp-edges) "
       "split the surfaces, and their nodes have rows of their own."},
  };
}

/// Those of an entry, and those of `enforcement`, of which `method` has one more word.
std::vector<Row<Entry>> rows_of_entry() {
  std::vector<Row<Entry>> rows = within(&Entry::contact, rows_of_contact());
  for (Row<Entry>& row : within(&Entry::enforcement, enforcement_rows())) {
    row.said.meaning = "As in [enforcement](#enforcement-of-contact).";
    if (row.said.key == "method") {
      row.said.meaning =
          "As in [enforcement](#enforcement-of-contact); `mortar` in [implicit scenes](#implicit-solver).";
      row.said.type += " or `mortar`";
      row.value.read = read_method;
    }
    rows.push_back(std::move(row));
  }
  return rows;
}

const Table<Entry> contact_keys{
    "contact",
    "a map {between: all} or {between: [a, b]}",
    rows_of_entry(),
    judge_entry,
};

/// Faults of combinations that the present method does not support.
void judge_method(const Key& whole, const ContactEntry& contact, const Input& input) {
  using contact::Method;
  const Method method = input.enforcement.settings.method;
  const bool ties = contact.tied || std::ranges::any_of(input.contact, &ContactEntry::tied);
  if (ties && method != Method::rate && method != Method::row_sum)
    fault(whole, "invalid tied: the enforcement method has no ties; expected method: rate or row_sum");
  const bool mortar = contact.passes == contact::Passes::mortar;
  if (mortar && !contact::holds_rates(method))
    fault(whole, "invalid passes: mortar: the enforcement method has no mortar rows; expected method: rate or row_sum");
  if (method != Method::reference) return;
  const bool rubs = contact.friction.any() ||
                    std::ranges::any_of(input.contact, [](const ContactEntry& e) { return e.friction.any(); }) ||
                    std::ranges::any_of(input.rigid_walls, [](const RigidWall& wall) { return wall.friction.any(); });
  if (rubs) fault(whole, "invalid method: reference has no friction; expected friction: 0, on rigid walls as well");
}

/// A later entry that names two tied parts releases their tie; a warning asks for an explicit statement.
void judge_untied(const Key& whole, const ContactEntry& contact, const Input& input) {
  if (contact.tied || contact.between.empty() || has(whole, "tied")) return;
  const std::set<std::string> pair(contact.between.begin(), contact.between.end());
  const auto names_it = [&](const ContactEntry& earlier) {
    return pair == std::set<std::string>(earlier.between.begin(), earlier.between.end());
  };
  const auto last = std::ranges::find_if(input.contact.rbegin(), input.contact.rend(), names_it);
  if (last == input.contact.rend() || !last->tied) return;
  warn(whole,
       fmt::format(
           "this entry releases the tie of {} and {} defined by contact.{}; tied: false does so without this warning",
           contact.between[0], contact.between[1], input.contact.rend() - last - 1));
}

/// Entry by entry: `enforcement` and `rigid_walls` have been read.
void read_contact_list(const Key& list, Input& input) {
  for (const Key& key : items(list, "a list of {between: all} or {between: [a, b]}")) {
    Entry entry{{}, input.enforcement};
    if (!contact_keys.read(key, entry)) continue;
    if (!entry.contact.mortar) {
      judge_enforcement_of_entry(key, entry.enforcement, input);
      input.enforcement = entry.enforcement;
    }
    judge_passes(key, entry.contact);
    judge_method(key, entry.contact, input);
    judge_untied(key, entry.contact, input);
    if (const contact::FrictionLaw& law = entry.contact.friction; law.kinetic < law.fixed && law.decay == 0)
      warn(at(key, "friction"), "kinetic has no effect without decay: the coefficient remains the static one");
    input.contact.push_back(std::move(entry.contact));
  }
}

using contact::SearchMethod;
const Choices<SearchMethod> search_methods{{{"auto", SearchMethod::automatic},
                                            {"blocks", SearchMethod::blocks},
                                            {"binary", SearchMethod::binary},
                                            {"bucket", SearchMethod::bucket}},
                                           {}};
}  // namespace

const Table<Input> search_keys{
    "search",
    "a map {method: auto, blocks, binary or bucket}",
    {
        {"method", value(&Input::search, search_methods), "-",
         "Blocks of points along a space-filling curve (`auto`), the binary sort or the bucket sort of Heinstein et "
         "al. (2000)."},
    },
};

Value<Input> contact_value() {
  return special("list", read_contact_list, {&contact_keys});
}

}  // namespace brunt::scene
