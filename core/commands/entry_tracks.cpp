// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/commands/entry_tracks.h"

#include <algorithm>
#include <charconv>
#include <fmt/format.h>

namespace trivar {

std::vector<Track> without_entries(const Tracks& tracks, std::string_view list,
                                   const std::vector<char>& gone)
{
    std::vector<Track> out;
    for (Track track : tracks) {
        std::size_t index = 0;
        const std::string& name = track.parameter;
        if (name.starts_with(list)) {
            const char* first = name.data() + list.size();
            const auto [rest, error] = std::from_chars(first, name.data() + name.size(), index);
            if (error != std::errc() || index >= gone.size() || gone[index] != 0) continue;
            const auto before =
                std::count(gone.begin(), gone.begin() + static_cast<long>(index), char{1});
            track.parameter = fmt::format("{}{}{}", list, index - static_cast<std::size_t>(before),
                                          std::string_view(rest, name.data() + name.size()));
        }
        out.push_back(std::move(track));
    }
    std::ranges::sort(out, {}, &Track::parameter);
    return out;
}

} // namespace trivar
