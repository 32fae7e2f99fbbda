// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>

namespace trivar {

// The memory that this process holds at present; 0 where the system does not tell. Only to be
// shown.
std::size_t resident_bytes();

// The memory that this computer has; 0 where the system does not tell.
std::uint64_t physical_bytes();

// Lets the process keep freed memory, up to 256 MB, for later use. The meshes of a scene that plays
// come and go with every picture, and the system would clear each page anew.
void keep_freed_memory();

} // namespace trivar
