// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/words/ranked.h"

#include "editor/words/letters_in_order.h"

#include <algorithm>
#include <optional>

namespace trivar {

std::vector<RankedName> ranked(std::string_view letters, const std::vector<std::string>& names,
                               const std::vector<std::string>& recent)
{
    struct ScoredName {
        RankedName ranked;
        int score = 0;
        bool whole = false;     // nothing of the name is left over
        std::size_t used = 0;   // place among the recent ones
        std::size_t spread = 0; // from the first matched letter to the last one
    };
    const bool all = letters.find_first_not_of(' ') == letters.npos;
    std::vector<ScoredName> found;
    for (std::size_t i = 0; i < names.size(); ++i) {
        std::optional<LetterMatch> match = letters_in_order(letters, names[i]);
        if (!match) continue;
        const auto place = std::ranges::find(recent, names[i]);
        const bool whole = match->at.size() == names[i].size();
        const std::size_t spread = match->at.empty() ? 0 : match->at.back() - match->at.front();
        found.push_back({{i, std::move(match->at), all && place != recent.end()},
                         match->score,
                         whole,
                         static_cast<std::size_t>(place - recent.begin()),
                         spread});
    }
    std::ranges::stable_sort(found, [](const ScoredName& a, const ScoredName& b) {
        if (a.score != b.score) return a.score > b.score;
        if (a.whole != b.whole) return a.whole;
        return a.used != b.used ? a.used < b.used : a.spread < b.spread;
    });
    std::vector<RankedName> result;
    result.reserve(found.size());
    for (ScoredName& each : found) result.push_back(std::move(each.ranked));
    return result;
}

} // namespace trivar
