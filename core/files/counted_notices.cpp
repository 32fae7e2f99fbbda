// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/files/counted_notices.h"

#include <algorithm>
#include <fmt/format.h>

namespace trivar {

void CountedNotices::add(const char* once, const char* often, std::size_t times,
                         std::string_view first)
{
    if (times == 0) return;
    const auto known = std::ranges::find(kinds_, std::string_view(often), &Kind::often);
    if (known == kinds_.end())
        kinds_.push_back({once, often, times, std::string(first)});
    else
        known->times += times;
}

void CountedNotices::say(std::string sentence)
{
    kinds_.push_back({"{1}", "{1}", 1, std::move(sentence)});
}

std::vector<std::string> CountedNotices::sentences(const std::string& file_name) const
{
    std::vector<std::string> out;
    for (const Kind& kind : kinds_) {
        const std::string_view sentence = kind.times == 1 ? kind.once : kind.often;
        out.push_back(fmt::format("{}: {}", file_name,
                                  fmt::format(fmt::runtime(sentence), kind.times, kind.first)));
    }
    return out;
}

} // namespace trivar
