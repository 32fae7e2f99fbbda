// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string_view>
#include <vector>

namespace trivar {

// How well `letters` are found in `text`, in order, whatever lies between and whatever their case;
// blanks in `letters` say nothing. Letters side by side and at the beginnings of words count more.
// Cost: the product of the lengths.
struct LetterMatch {
    int score = 0;
    std::vector<std::size_t> at; // their places in the text, rising
};
std::optional<LetterMatch> letters_in_order(std::string_view letters, std::string_view text);

} // namespace trivar
