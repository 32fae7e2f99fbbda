// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/stages/told_steps.h"

#include <fmt/format.h>

namespace trivar {

void tell_of_steps(const ShapedVolume& shaped, std::vector<std::string>& notices)
{
    for (std::size_t i = 0; i < shaped.steps.size(); ++i)
        if (const std::string& notice = shaped.steps[i].notice; !notice.empty())
            notices.push_back(fmt::format("step {} of its shaping: {}", i + 1, notice));
}

} // namespace trivar
