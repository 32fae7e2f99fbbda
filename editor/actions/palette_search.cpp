// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/actions/palette_search.h"

#include "editor/words/synonyms.h"

#include <algorithm>
#include <cctype>

namespace trivar {
namespace {

std::string in_small_letters(std::string_view text)
{
    std::string out(text.substr(0, 256));
    std::ranges::transform(out, out.begin(),
                           [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return out;
}

bool has_word_that_begins(const std::string& text, const std::string& with)
{
    for (std::size_t at = text.find(with); at != text.npos; at = text.find(with, at + 1))
        if (at == 0 || std::isalnum(static_cast<unsigned char>(text[at - 1])) == 0) return true;
    return false;
}

} // namespace

std::vector<RankedName> found_entries(std::string_view typed,
                                      const std::vector<PaletteEntry>& entries,
                                      const std::vector<std::string>& recent)
{
    constexpr std::size_t few = 4; // letters of an abbreviation
    std::vector<std::string> names;
    for (const PaletteEntry& each : entries) names.push_back(each.name);
    std::vector<RankedName> by_letters = ranked(typed, names, recent);
    std::string wanted = in_small_letters(typed);
    while (wanted.ends_with(' ')) wanted.pop_back();
    wanted.erase(0, wanted.find_first_not_of(' '));
    if (wanted.empty()) return by_letters;
    const auto scattered =
        std::stable_partition(by_letters.begin(), by_letters.end(), [&](const RankedName& each) {
            return in_small_letters(names[each.index]).find(wanted) != std::string::npos;
        });
    std::vector<RankedName> found(by_letters.begin(), scattered);
    const auto add = [&](RankedName each) {
        if (std::ranges::find(found, each.index, &RankedName::index) == found.end())
            found.push_back(std::move(each));
    };
    for (const std::string& name : names_meant_by(wanted))
        if (const auto at = std::ranges::find(names, name); at != names.end())
            add({static_cast<std::size_t>(at - names.begin()), {}, false});
    if (found.empty() || wanted.size() <= few)
        for (auto each = scattered; each != by_letters.end(); ++each) add(std::move(*each));
    for (std::size_t i = 0; i < entries.size(); ++i)
        if (has_word_that_begins(in_small_letters(entries[i].note), wanted)) add({i, {}, false});
    return found;
}

} // namespace trivar
