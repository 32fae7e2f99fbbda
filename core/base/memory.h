// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

namespace trivar {

// Memory this process holds at the moment; 0 where the system does not tell. To be shown only.
std::size_t resident_bytes();

// What is freed from now on stays with the process, up to 256 MB, for the next who asks. The meshes
// of a scene that plays come and go with every picture, and the system would clear each page anew.
void keep_freed_memory();

} // namespace trivar
