// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/words/share_words.h"

#include <fmt/format.h>

namespace trivar {

std::string share_words(double share)
{
    const double percents = share * 100;
    if (percents < 0.01) return "under 0.01 %";
    return percents < 10 ? fmt::format("{:.2g} %", percents) : fmt::format("{:.0f} %", percents);
}

} // namespace trivar
