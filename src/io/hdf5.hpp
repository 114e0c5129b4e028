// SPDX-License-Identifier: Apache-2.0
// An HDF5 file that all ranks read or write together: small attributes, and tables of doubles or 64-bit integers of
// which every rank transfers a contiguous range of rows. Every function is collective. A failure on one rank is thrown
// on all of them with the same text: MachineError for failed writing, InputError for a file that cannot be read
// (missing, truncated, damaged, or with unexpected content).
#pragma once
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "comm/communicator.hpp"
#include "core/types.hpp"

namespace brunt::io {

class Hdf5File {
 public:
  enum class Mode { create, read, append };  ///< create: an existing file is lost

  Hdf5File(const comm::Communicator& ranks, std::string path, Mode mode);
  ~Hdf5File();  ///< closes the file; failures are not reported, so a writer calls close()
  Hdf5File(const Hdf5File&) = delete;
  Hdf5File& operator=(const Hdf5File&) = delete;

  void flush();  ///< afterwards the file can be opened even if the run is killed
  void close();
  [[nodiscard]] const std::string& path() const { return path_; }
  [[nodiscard]] const comm::Communicator& ranks() const { return ranks_; }

  [[nodiscard]] bool contains(const std::string& object) const;
  [[nodiscard]] std::vector<std::string> groups(const std::string& group) const;    ///< directly below, sorted
  [[nodiscard]] std::vector<std::string> datasets(const std::string& group) const;  ///< at any depth, sorted
  void create_group(const std::string& group);
  void remove(const std::string& object);

  /// Tables; the groups in the name are created. Their content is undefined until written.
  void create_doubles(const std::string& name, GlobalIndex rows, int width);
  void create_integers(const std::string& name, GlobalIndex rows, int width);

  enum class Type { doubles, integers };
  struct Extent {
    GlobalIndex rows = 0;
    int width = 0;
    Type type = Type::doubles;
    bool operator==(const Extent&) const = default;
  };
  [[nodiscard]] Extent extent(const std::string& name) const;

  /// Transfers rows first_row, first_row + 1, ... of this rank; `rows` may be empty on some ranks.
  void write(const std::string& name, GlobalIndex first_row, std::span<const double> rows);
  void write(const std::string& name, GlobalIndex first_row, std::span<const std::int64_t> rows);
  void read(const std::string& name, GlobalIndex first_row, std::span<double> rows) const;
  void read(const std::string& name, GlobalIndex first_row, std::span<std::int64_t> rows) const;

  void set_attribute(const std::string& object, const std::string& name, double value);
  void set_attribute(const std::string& object, const std::string& name, GlobalIndex value);
  void set_attribute(const std::string& object, const std::string& name, const std::string& text);
  [[nodiscard]] bool has_attribute(const std::string& object, const std::string& name) const;
  [[nodiscard]] double real_attribute(const std::string& object, const std::string& name) const;
  [[nodiscard]] GlobalIndex integer_attribute(const std::string& object, const std::string& name) const;
  [[nodiscard]] std::string text_attribute(const std::string& object, const std::string& name) const;

 private:
  void require_written(bool good, std::string_view action, const std::string& object) const;
  void require_read(bool good, std::string_view action, const std::string& object) const;
  [[nodiscard]] std::string fault(std::string_view action, const std::string& object, bool good) const;
  void create_table(const std::string& name, GlobalIndex rows, int width, std::int64_t type);
  void transfer(const std::string& name, GlobalIndex first_row, std::size_t values, std::int64_t type,
                const void* source, void* target) const;
  void put_attribute(const std::string& object, const std::string& name, std::int64_t type, const void* value);
  void get_attribute(const std::string& object, const std::string& name, std::int64_t type, void* value) const;

  comm::Communicator ranks_;
  std::string path_;
  std::int64_t file_ = -1;  // HDF5's id
};

}  // namespace brunt::io
