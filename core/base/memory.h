// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

namespace trivar {

// Memory this process holds at the moment; 0 where the system does not tell. To be shown only.
std::size_t resident_bytes();

} // namespace trivar
