// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>

namespace trivar {

// An ordinary file's bytes (core/base/ordinary_file.h). Throws Rejected for what is none, cannot be
// read or has more than `max_bytes`.
std::string read_bytes(const std::string& path, std::uintmax_t max_bytes);

// The digest of a file's bytes, 32 hexadecimal digits. Throws Rejected.
std::string file_hash(const std::string& path);

// Writes beside `path` and renames at the end, so that any failure leaves the previous file as it
// was. Throws Rejected with the system's reason.
void write_bytes(const std::string& path, std::string_view bytes);

// The path of the file in `folder` that a file there means by `name`, as FolderFiles finds it.
std::optional<std::string> file_inside(const std::string& folder, const std::string& name);

// Lower case, with the dot; empty if there is none.
std::string extension_of(const std::string& path);

// Whether JSON is nested more than 48 deep. Parsers and writers of JSON recurse; this does not.
bool nested_too_deep(std::string_view json);

} // namespace trivar
