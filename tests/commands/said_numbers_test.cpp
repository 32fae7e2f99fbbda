// SPDX-License-Identifier: GPL-3.0-or-later
// How numbers are said in titles of steps, refusals and notices, whatever the values are.
#include "core/base/rejected.h"
#include "tests/support/scenes/commands.h"

#include <gtest/gtest.h>
#include <regex>

namespace trivar {
namespace {

using testing::fitting_document;

// An exponent, a minus zero, or five digits before the point without a comma.
bool is_badly_said(const std::string& words)
{
    static const std::regex bad(
        R"([0-9]e[+-]?[0-9]|(^|[^0-9a-z.])-0(?![.0-9])|(^|[^0-9.a-z])[0-9]{5,})");
    return std::regex_search(words, bad);
}

TEST(SaidNumbers, AreJudgedRightly)
{
    for (const char* words : {"2.43e-17 m", "it hovers 2e+02 m", "move -0 m", "23190840 vertices"})
        EXPECT_TRUE(is_badly_said(words)) << words;
    for (const char* words :
         {"0.00243 m", "200 m", "move -0.05 m", "23,190,840 vertices", "1.234567", "2.43·10⁻¹⁷ m"})
        EXPECT_FALSE(is_badly_said(words)) << words;
}

TEST(SaidNumbers, HaveNoExponentsInTitlesAndRefusals)
{
    std::mt19937 random(52);
    const Document start = fitting_document();
    int titles = 0;
    for (int i = 0; i < 20000; ++i) {
        const Command command = testing::random_command(random);
        std::string words;
        try {
            words = step_title(command, start, after(start, command)).text();
            ++titles;
        } catch (const Rejected& refusal) {
            words = refusal.what();
        }
        EXPECT_FALSE(is_badly_said(words)) << words;
    }
    EXPECT_GT(titles, 1000); // the test means something
}

TEST(SaidNumbers, HaveNoExponentsInNotices)
{
    std::mt19937 random(520);
    Evaluator evaluator = testing::new_evaluator();
    const Document start = fitting_document();
    for (int i = 0; i < 300; ++i) {
        Document document;
        try {
            document = after(start, testing::random_command(random));
        } catch (const Rejected&) {
            continue;
        }
        for (const auto& [id, effects] : evaluator(document).objects)
            for (const std::string& notice : effects->notices)
                EXPECT_FALSE(is_badly_said(notice)) << notice;
    }
}

} // namespace
} // namespace trivar
