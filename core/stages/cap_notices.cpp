// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/stages/cap_notices.h"

#include <fmt/format.h>

namespace trivar {

std::vector<std::string> notices_of(const CapCounts& counts)
{
    std::vector<std::string> out;
    if (counts.open > 0)
        out.emplace_back("it is a sheet where it is cut, without an inside to close");
    if (counts.gaps > 0)
        out.emplace_back("its surface has holes where it is cut; the cut is closed straight across "
                         "them, and they stay open");
    if (counts.fans > 0)
        out.push_back(fmt::format("its surface runs through itself where it is cut: {} openings "
                                  "are closed by triangles that overlap",
                                  counts.fans));
    return out;
}

} // namespace trivar
