// SPDX-License-Identifier: Apache-2.0
// Text files replaced as a whole (see the header).
#include "io/text_file.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <utility>

#include "core/error.hpp"
#include "core/utf8.hpp"

namespace brunt::io {
namespace {

[[noreturn]] void fail(const std::string& path, const char* action) {
  throw MachineError(path + ": cannot " + action + ": " + std::strerror(errno));
}

// Some file systems cannot sync folders; the rename itself is atomic all the same.
void sync_folder_of(const std::string& path) {
  const std::filesystem::path folder = std::filesystem::absolute(path).parent_path();
  const int handle = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY);
  if (handle < 0) return;
  ::fsync(handle);
  ::close(handle);
}

}  // namespace

void rename_durably(const std::string& from, const std::string& to) {
  const int file = ::open(from.c_str(), O_RDONLY);
  if (file < 0) fail(from, "open the file");
  const bool synced = ::fsync(file) == 0;
  ::close(file);
  if (!synced) fail(from, "write the file to disk");
  if (std::rename(from.c_str(), to.c_str()) != 0) fail(to, "rename the temporary file");
  sync_folder_of(to);
}

void replace_text(const std::string& path, std::string_view text) {
  const std::string draft = path + ".tmp";
  std::FILE* file = std::fopen(draft.c_str(), "wb");
  if (file == nullptr) fail(draft, "create the file");
  const bool written = std::fwrite(text.data(), 1, text.size(), file) == text.size();
  if (const bool closed = std::fclose(file) == 0; !written || !closed) fail(draft, "write the file");
  rename_durably(draft, path);
}

std::string read_text(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  if (!file || std::filesystem::is_directory(path))
    throw InputError(path + ": cannot read the file (" + std::strerror(file ? EISDIR : errno) +
                     "); expected a readable file");
  std::ostringstream text;
  text << file.rdbuf();
  return std::move(text).str();
}

void refuse_utf16(std::string_view text, const std::string& name) {
  if (text.starts_with("\xFF\xFE") || text.starts_with("\xFE\xFF"))
    throw InputError(name + ":1: invalid encoding: the text is UTF-16; expected a file saved as UTF-8");
}

std::string plain_text(std::string text, const std::string& name) {
  refuse_utf16(text, name);
  if (text.starts_with("\xEF\xBB\xBF")) text.erase(0, 3);
  text = as_utf8(std::move(text));
  std::size_t to = text.find('\r');
  if (to == std::string::npos) return text;
  for (std::size_t from = to; from < text.size(); ++from) {
    if (text[from] == '\r' && from + 1 < text.size() && text[from + 1] == '\n') continue;
    text[to++] = text[from] == '\r' ? '\n' : text[from];
  }
  text.resize(to);
  return text;
}

}  // namespace brunt::io
