// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace trivar {

// Number of characters that so many bytes take in base64, with '=' at the end.
constexpr std::size_t base64_length(std::size_t bytes)
{
    return (bytes + 2) / 3 * 4;
}

// The bytes of a text in base64 (RFC 4648), blanks and ends of lines left out; empty where it is
// damaged. A text may end without its '='.
std::optional<std::string> from_base64(std::string_view text);

} // namespace trivar
