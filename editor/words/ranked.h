// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace trivar {

// The names that hold the letters in order, the best match first. Among equal matches a complete
// word comes first, then the last used, then the one whose letters stand nearest together, then the
// first listed. Without letters: the recent names and then all others.
struct RankedName {
    std::size_t index = 0;            // in `names`
    std::vector<std::size_t> letters; // that matched
    bool recent = false;
};
std::vector<RankedName> ranked(std::string_view letters, const std::vector<std::string>& names,
                               const std::vector<std::string>& recent);

} // namespace trivar
