// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace trivar {

// Whether a uri holds the bytes itself (RFC 2397) and names no file.
bool is_data_uri(std::string_view uri);

// The bytes that such a uri holds, as base64 or as text; empty where it is neither.
std::optional<std::string> data_uri_bytes(std::string_view uri);

// The text with each %41 replaced by A; anything that is no such escape stays.
std::string without_escapes(std::string_view text);

} // namespace trivar
