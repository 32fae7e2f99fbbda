// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/words/letters_in_order.h"

#include <algorithm>
#include <cctype>
#include <string>

namespace trivar {
namespace {

constexpr int letter = 1, side_by_side = 14, word_begins = 8, text_begins = 4;
constexpr std::size_t longest = 128; // what lies beyond is not looked at

char lower(char c)
{
    return static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
}

int worth(std::string_view text, std::size_t i)
{
    if (i == 0) return letter + word_begins + text_begins;
    const bool inside = std::isalnum(static_cast<unsigned char>(text[i - 1])) != 0;
    return letter + (inside ? 0 : word_begins);
}

} // namespace

std::optional<LetterMatch> letters_in_order(std::string_view letters, std::string_view text)
{
    std::string wanted;
    for (const char c : letters.substr(0, longest))
        if (c != ' ') wanted += lower(c);
    text = text.substr(0, longest);
    const std::size_t m = wanted.size(), n = text.size();
    if (m == 0) return LetterMatch{};
    if (m > n) return std::nullopt;
    // best(k, i): of the first k + 1 letters with the last of them at i; from(k, i): where the one
    // before it is then.
    constexpr int none = -1000000;
    std::vector<int> best(m * n, none);
    std::vector<std::size_t> from(m * n, n);
    for (std::size_t k = 0; k < m; ++k) {
        int reachable = none; // the best of the letters before, further left than side by side
        std::size_t where = n;
        for (std::size_t i = k; i < n; ++i) {
            if (k > 0 && i >= 2 && best[(k - 1) * n + i - 2] > reachable) {
                reachable = best[(k - 1) * n + i - 2];
                where = i - 2;
            }
            if (lower(text[i]) != wanted[k]) continue;
            int before = k == 0 ? 0 : reachable;
            std::size_t place = where;
            if (k > 0 && i >= 1 && best[(k - 1) * n + i - 1] > none &&
                best[(k - 1) * n + i - 1] + side_by_side >= before) {
                before = best[(k - 1) * n + i - 1] + side_by_side;
                place = i - 1;
            }
            if (before <= none) continue;
            best[k * n + i] = before + worth(text, i);
            from[k * n + i] = place;
        }
    }
    const auto last = best.end() - static_cast<std::ptrdiff_t>(n);
    const auto end = std::max_element(last, best.end());
    if (*end <= none) return std::nullopt;
    LetterMatch match{*end, std::vector<std::size_t>(m)};
    std::size_t i = static_cast<std::size_t>(end - last);
    for (std::size_t k = m; k-- > 0;) {
        match.at[k] = i;
        i = from[k * n + i];
    }
    return match;
}

} // namespace trivar
