// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/commands/edits/entry_tracks.h"

#include <algorithm>
#include <charconv>
#include <fmt/format.h>
#include <optional>

namespace trivar {

namespace {

// The tracks with other numbers of the entries of a list; those without one are left out.
std::vector<Track> renumbered_entries(const Tracks& tracks, std::string_view list, const auto& now)
{
    std::vector<Track> out;
    for (Track track : tracks) {
        std::size_t index = 0;
        const std::string& name = track.parameter;
        if (name.starts_with(list)) {
            const char* first = name.data() + list.size();
            const auto [rest, error] = std::from_chars(first, name.data() + name.size(), index);
            if (error != std::errc()) continue;
            const std::optional<std::size_t> number = now(index);
            if (!number) continue;
            track.parameter = fmt::format("{}{}{}", list, *number,
                                          std::string_view(rest, name.data() + name.size()));
        }
        out.push_back(std::move(track));
    }
    std::ranges::sort(out, {}, &Track::parameter);
    return out;
}

} // namespace

std::vector<Track> without_entries(const Tracks& tracks, std::string_view list,
                                   const std::vector<char>& gone)
{
    return renumbered_entries(tracks, list, [&](std::size_t index) -> std::optional<std::size_t> {
        if (index >= gone.size() || gone[index] != 0) return {};
        return index - static_cast<std::size_t>(std::count(
                           gone.begin(), gone.begin() + static_cast<long>(index), char{1}));
    });
}

std::vector<Track> with_swapped_entries(const Tracks& tracks, std::string_view list, std::size_t a,
                                        std::size_t b)
{
    return renumbered_entries(tracks, list, [&](std::size_t index) -> std::optional<std::size_t> {
        return index == a ? b : index == b ? a : index;
    });
}

} // namespace trivar
