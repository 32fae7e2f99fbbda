// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string_view>
#include <vector>

namespace trivar {

// A LetterMatch says how well `letters` are found in `text`, in order, with anything between them
// and in any case of letters; blanks in `letters` are ignored. Letters side by side and at the
// beginnings of words count more. Cost: the product of the lengths.
struct LetterMatch {
    int score = 0;
    std::vector<std::size_t> at; // their places in the text, rising
};
std::optional<LetterMatch> letters_in_order(std::string_view letters, std::string_view text);

} // namespace trivar
