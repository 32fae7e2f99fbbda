// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>

namespace trivar::testing {

// Begins a new measurement of the most memory that this process holds.
void forget_peak_memory();

// The most since then, in bytes; nothing where it cannot be told: under sanitizers, which hold a
// multiple of it, and on systems that do not say.
std::optional<std::size_t> peak_memory();

} // namespace trivar::testing
