// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/fuzz/shortened.h"

#include <algorithm>

namespace trivar::testing {

std::vector<std::string>
shortened(std::vector<std::string> lines,
          const std::function<bool(const std::vector<std::string>&)>& fails)
{
    std::size_t length = std::max<std::size_t>(lines.size() / 2, 1); // of what is left out
    while (!lines.empty()) {
        bool found = false;
        // The search begins at the end: the lines after a failure are needed least.
        for (std::size_t end = lines.size(); end > 0;) {
            const std::size_t begin = end > length ? end - length : 0;
            std::vector<std::string> fewer(lines.begin(), lines.begin() + std::ptrdiff_t(begin));
            fewer.insert(fewer.end(), lines.begin() + std::ptrdiff_t(end), lines.end());
            if (fails(fewer)) {
                lines = std::move(fewer);
                found = true;
            }
            end = begin;
        }
        if (length == 1 && !found) break;
        length = std::max<std::size_t>(length / 2, 1);
    }
    return lines;
}

} // namespace trivar::testing
