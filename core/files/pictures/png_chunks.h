// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

namespace trivar {

// Returns why the bytes are no whole PNG, the rest of a sentence; empty: they are one. It checks
// chunks and their checksums, not pixels. PNG specification (W3C), 5.
std::string png_trouble(std::string_view bytes);

// The words that a whole PNG has under a name; empty: none. They are Latin text, not packed.
std::string png_text(std::string_view bytes, std::string_view name);

} // namespace trivar
