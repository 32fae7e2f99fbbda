// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/fuzz/sentence.h"

#include "core/base/text.h"
#include "core/base/utf8.h"
#include "tests/fuzz/campaign.h"

#include <fmt/format.h>

namespace trivar::testing {
namespace {

constexpr std::size_t longest_sentence = 400;

} // namespace

std::string flaw_of_sentence(std::string_view sentence)
{
    if (sentence.empty()) return "a sentence is empty";
    const std::string shown = excerpt(sentence);
    if (sentence.size() > longest_sentence)
        return fmt::format("a sentence has {} bytes: {}", sentence.size(), shown);
    if (!is_utf8(sentence)) return "a sentence is no UTF-8: " + shown;
    if (printable(sentence) != sentence) return "a sentence holds control characters: " + shown;
    return {};
}

void check_sentences(const std::vector<std::string>& sentences)
{
    for (const std::string& sentence : sentences)
        if (const std::string flaw = flaw_of_sentence(sentence); !flaw.empty()) throw Broken(flaw);
}

} // namespace trivar::testing
