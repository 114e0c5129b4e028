// SPDX-License-Identifier: Apache-2.0
// Records of a state file (see the header).
#include "io/results/state_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "core/error.hpp"
#include "io/disk_space.hpp"
#include "io/on_root.hpp"
#include "io/results/xdmf.hpp"
#include "io/text_file.hpp"
#include "state_topology.hpp"

namespace brunt::io {
namespace {

constexpr GlobalIndex format_version = 1;

std::vector<GlobalIndex> all_elements(const StateMesh& mesh) {
  std::vector<GlobalIndex> elements;
  for (const StateBlock& block : mesh.blocks)
    elements.insert(elements.end(), block.element.begin(), block.element.end());
  return elements;
}

const char* folder_of(Place place) {
  return place == Place::node ? "node" : "element";
}

void check_same_mesh(const Hdf5File& file, const StateMesh& mesh) {
  const auto check = [&](const char* what, GlobalIndex expected) {
    const GlobalIndex found = file.integer_attribute("/", what);
    if (found != expected)
      throw InputError(fmt::format("{}: invalid for this run: another mesh of {} {}; expected {}", file.path(), found,
                                   what, expected));
  };
  check("format", format_version);
  check("nodes", mesh.global_nodes);
  check("elements", mesh.global_elements);
  check("blocks", static_cast<GlobalIndex>(mesh.blocks.size()));
}

bool exists_for_all(const comm::Communicator& ranks, const std::string& path) {
  return ranks.any(ranks.is_root() && std::filesystem::exists(path));
}

std::vector<StateRecord::Table> tables_of(const Hdf5File& file, const std::string& record) {
  std::vector<StateRecord::Table> tables;
  for (const Place place : {Place::node, Place::element}) {
    const std::string group = record + "/" + folder_of(place);
    if (!file.contains(group)) continue;
    for (const std::string& name : file.datasets(group))
      tables.push_back({name, place, file.extent(group + "/" + name).width});
  }
  return tables;
}

}  // namespace

std::vector<StateRecord> state_records(const Hdf5File& file) {
  std::vector<StateRecord> records;
  for (const std::string& name : file.groups("/")) {
    const std::string group = "/" + name;
    if (name.rfind("record_", 0) != 0 || !file.has_attribute(group, "time")) continue;
    records.push_back(
        {group, file.integer_attribute(group, "step"), file.real_attribute(group, "time"), tables_of(file, group)});
  }
  std::sort(records.begin(), records.end(), [](const StateRecord& a, const StateRecord& b) { return a.step < b.step; });
  return records;
}

StateFile::StateFile(const comm::Communicator& ranks, std::string folder, StateMesh mesh,
                     std::optional<GlobalIndex> restart_step)
    : ranks_(ranks),
      folder_(std::move(folder)),
      global_nodes_(mesh.global_nodes),
      global_elements_(mesh.global_elements),
      topology_(state_topology(ranks, mesh)),
      nodes_(ranks, mesh.global_nodes, mesh.node),
      elements_(ranks, mesh.global_elements, all_elements(mesh)) {
  if (restart_step && exists_for_all(ranks_, folder_ + "/state.h5"))
    resume(mesh, *restart_step);
  else
    start(mesh);
}

void StateFile::start(StateMesh& mesh) {
  const GlobalIndex bytes = 65536 + table_bytes(global_nodes_, 4) + table_bytes(global_elements_, 10);
  demand_disk_space(ranks_, folder_ + "/state.h5", bytes);
  file_ = std::make_unique<Hdf5File>(ranks_, folder_ + "/state.h5", Hdf5File::Mode::create);
  file_->set_attribute("/", "format", format_version);
  file_->set_attribute("/", "nodes", mesh.global_nodes);
  file_->set_attribute("/", "elements", mesh.global_elements);
  file_->set_attribute("/", "blocks", static_cast<GlobalIndex>(mesh.blocks.size()));
  write_mesh(mesh);
  file_->flush();
  write_xdmf();
}

void StateFile::name_unit(const std::string& quantity, const std::string& unit) {
  const std::string name = "unit_" + quantity;
  if (!file_->has_attribute("/", name)) file_->set_attribute("/", name, unit);  // a restart finds them
}

void StateFile::resume(const StateMesh& mesh, GlobalIndex restart_step) {
  file_ = std::make_unique<Hdf5File>(ranks_, folder_ + "/state.h5", Hdf5File::Mode::append);
  check_same_mesh(*file_, mesh);
  records_ = state_records(*file_);
  std::erase_if(records_, [&](const StateRecord& record) { return record.step > restart_step; });
  for (const std::string& name : file_->groups("/")) {
    const std::string group = "/" + name;
    const bool kept = std::any_of(records_.begin(), records_.end(), [&](const auto& r) { return r.group == group; });
    if (name.rfind("record_", 0) == 0 && !kept) file_->remove(group);
  }
  file_->flush();
  write_xdmf();
}

void StateFile::write(GlobalIndex step, double time, std::span<const StateField> fields) {
  StateRecord record{fmt::format("/record_{:06}", records_.size()), step, time, {}};
  GlobalIndex bytes = 16384;
  for (const StateField& field : fields)
    bytes += table_bytes(field.place == Place::node ? global_nodes_ : global_elements_, field.components);
  demand_disk_space(ranks_, file_->path(), bytes);
  file_->create_group(record.group);
  for (const StateField& field : fields) {
    const comm::BlockRedistribution& redistribution = field.place == Place::node ? nodes_ : elements_;
    const comm::BlockLayout& layout = redistribution.layout();
    std::vector<double> block(static_cast<std::size_t>(layout.count(ranks_.rank())) *
                              static_cast<std::size_t>(field.components));
    redistribution.to_blocks(field.values, block, field.components);
    const std::string table = fmt::format("{}/{}/{}", record.group, folder_of(field.place), field.name);
    file_->create_doubles(table, layout.total, field.components);
    file_->write(table, layout.first(ranks_.rank()), std::span<const double>(block));
    record.tables.push_back({field.name, field.place, field.components});
  }
  file_->flush();
  file_->set_attribute(record.group, "step", step);
  file_->set_attribute(record.group, "time", time);
  file_->flush();
  records_.push_back(std::move(record));
  write_xdmf();
}

void StateFile::write_xdmf() const {
  on_root(ranks_, [&] {
    replace_text(folder_ + "/state.xdmf", xdmf_text(topology_, global_nodes_, global_elements_, records_));
  });
}

}  // namespace brunt::io
