// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>

namespace trivar {

// The bytes of an ordinary file (core/base/ordinary_file.h). Throws Rejected for anything else, for
// a file that cannot be read, and for one with more than `max_bytes`.
std::string read_bytes(const std::string& path, std::uintmax_t max_bytes);

// The digest of a file's bytes, 32 hexadecimal digits. Throws Rejected.
std::string file_hash(const std::string& path);

// Writes beside `path` and renames at the end, so that any failure leaves the earlier file
// unchanged. Throws Rejected with the system's reason.
void write_bytes(const std::string& path, std::string_view bytes);

// The path of the file in `folder` that `name` means there, as FolderFiles finds it.
std::optional<std::string> file_inside(const std::string& folder, const std::string& name);

// The ending of a name in lower case, with the dot; empty if there is none.
std::string extension_of(const std::string& path);

// Whether JSON is nested more than 48 deep. Parsers and writers of JSON recurse; this function does
// not.
bool nested_too_deep(std::string_view json);

} // namespace trivar
