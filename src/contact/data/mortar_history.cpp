// SPDX-License-Identifier: Apache-2.0
#include "contact/data/mortar_history.hpp"

#include <algorithm>
#include <tuple>

#include "core/error.hpp"

namespace brunt::contact {
namespace {

constexpr std::size_t head_numbers = 12;

/// The row's own node comes first, then the master's nodes.
int place_of(const RowKey& key, const MortarTerm& term) {
  if (term.part == MortarPart::slave) return term.id == key.slave ? 0 : 2;
  return term.part == MortarPart::master ? 1 : 3;
}

}  // namespace

std::vector<MortarTermRecord> term_records(const MortarHistory& history) {
  std::vector<MortarTermRecord> records;
  for (std::size_t r = 0; r < history.heads.size(); ++r)
    for (const MortarTerm& term : history.terms.row(static_cast<LocalIndex>(r)))
      records.push_back({history.heads[r].key, term});
  return records;
}

MortarHistory mortar_history_from(std::vector<MortarHead> heads, std::vector<MortarTermRecord> terms) {
  std::ranges::sort(heads, {}, &MortarHead::key);
  std::ranges::sort(terms, {}, [](const MortarTermRecord& record) {
    return std::tuple(saved(record.key), place_of(record.key, record.term), record.term.id);
  });
  MortarHistory history;
  auto next = terms.begin();
  for (const MortarHead& head : heads) {
    history.heads.push_back(head);
    for (; next != terms.end() && next->key == head.key; ++next) history.terms.values.push_back(next->term);
    history.terms.close_row();
  }
  demand(next == terms.end(), "each weight of a mortar row has its row");
  return history;
}

std::array<RecordTable, 2> mortar_tables(const MortarHistory& history) {
  RecordTable heads{.name = "contact_mortar", .key_width = 4, .value_width = head_numbers};
  RecordTable terms{.name = "contact_mortar_weights", .key_width = 6, .value_width = 2};
  for (const MortarHead& head : history.heads) {
    const SavedKey key = saved(head.key);
    heads.keys.insert(heads.keys.end(), key.begin(), key.end());
    heads.values.insert(heads.values.end(), head.slip.begin(), head.slip.end());
    heads.values.insert(heads.values.end(), head.apart.begin(), head.apart.end());
    heads.values.insert(heads.values.end(),
                        {head.area, head.size, head.whole, head.born, head.age, static_cast<double>(head.block)});
  }
  for (const MortarTermRecord& record : term_records(history)) {
    const SavedKey key = saved(record.key);
    terms.keys.insert(terms.keys.end(), key.begin(), key.end());
    terms.keys.insert(terms.keys.end(), {static_cast<GlobalIndex>(record.term.part), record.term.id});
    terms.values.insert(terms.values.end(), {record.term.weight, record.term.reach});
  }
  return {heads, terms};
}

std::vector<MortarHead> mortar_heads_from(const RecordTable& table) {
  demand(4 * table.values.size() == head_numbers * table.keys.size(), "the table of mortar rows is complete");
  std::vector<MortarHead> heads;
  const double* value = table.values.data();
  for (auto key = table.keys.begin(); key != table.keys.end(); key += 4, value += head_numbers) {
    MortarHead head{.key = row_key_from({key[0], key[1], key[2], key[3]})};
    std::copy_n(value, 3, head.slip.begin());
    std::copy_n(value + 3, 3, head.apart.begin());
    head.area = value[6];
    head.size = value[7];
    head.whole = value[8];
    head.born = value[9];
    head.age = value[10];
    head.block = static_cast<std::int32_t>(value[11]);
    heads.push_back(head);
  }
  return heads;
}

std::vector<MortarTermRecord> mortar_terms_from(const RecordTable& table) {
  demand(6 * table.values.size() == 2 * table.keys.size(), "the table of the weights of mortar rows is complete");
  std::vector<MortarTermRecord> terms;
  const double* value = table.values.data();
  for (auto key = table.keys.begin(); key != table.keys.end(); key += 6, value += 2)
    terms.push_back({row_key_from({key[0], key[1], key[2], key[3]}),
                     {key[5], value[0], value[1], static_cast<MortarPart>(key[4])}});
  return terms;
}

}  // namespace brunt::contact
