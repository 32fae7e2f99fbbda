// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

namespace trivar {

// Why the bytes are no whole PNG; empty: they are one. Its chunks are looked at, not its pixels.
// The library that reads PNG says what is damaged on stderr; what is refused here never gets there.
// PNG specification (W3C), 5.
std::string png_trouble(std::string_view bytes);

} // namespace trivar
