// SPDX-License-Identifier: Apache-2.0
// Small text files, read and replaced as a whole. Not collective: for the root rank.
#pragma once
#include <string>
#include <string_view>

namespace brunt::io {

/// Writes `path`.tmp, waits until it is on disk, then renames it: a reader sees the old or the new text, never a part.
/// Throws MachineError.
void replace_text(const std::string& path, std::string_view text);

/// Throws InputError if the file cannot be read.
[[nodiscard]] std::string read_text(const std::string& path);

/// The text in one form, whatever program wrote it: without a byte-order mark, each line ends with '\n' instead of CR
/// LF or CR, and UTF-8: other text is taken as Latin-1. Line numbers stay. Throws InputError for UTF-16; `name`: of the
/// file.
[[nodiscard]] std::string plain_text(std::string text, const std::string& name);

/// Throws InputError if the text begins with the byte-order mark of UTF-16.
void refuse_utf16(std::string_view text, const std::string& name);

/// Ensures that a finished file is on disk under its final name (fsync, rename, fsync of the folder). Throws
/// MachineError.
void rename_durably(const std::string& from, const std::string& to);

}  // namespace brunt::io
