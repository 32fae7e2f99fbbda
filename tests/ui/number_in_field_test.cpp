// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/expression.h"
#include "ui/widgets.h"

#include <cmath>
#include <gtest/gtest.h>
#include <random>

namespace trivar::ui {
namespace {

std::string shown(double value, std::size_t letters, double step = 0)
{
    return number_in_field(value, step,
                           [&](const std::string& text) { return text.size() <= letters; });
}

// The place of the last digit that is shown, as a number.
double last_place(const std::string& text)
{
    const std::size_t raised = text.find("·10"), point = text.find('.');
    const std::string digits = text.substr(0, raised);
    const double of_ten =
        raised == text.npos ? 1 : *evaluate_expression("1" + text.substr(raised), Measure::plain);
    if (point >= digits.size()) return of_ten;
    return of_ten * std::pow(10, -static_cast<double>(digits.size() - point - 1));
}

TEST(NumberInField, ReadsBackWithinItsShownDigits)
{
    std::mt19937_64 random;
    std::uniform_real_distribution<double> power(-14, 14), digits(-9.999, 9.999);
    for (int i = 0; i < 20000; ++i) {
        const double value = digits(random) * std::pow(10, power(random));
        const std::string text = shown(value, 3 + random() % 12);
        const auto read = evaluate_expression(text, Measure::plain);
        ASSERT_TRUE(read) << text;
        ASSERT_LE(std::abs(*read - value), 0.5001 * last_place(text)) << text << " " << value;
        ASSERT_NE(*read, 0) << value;
        ASSERT_EQ(text.find_first_of("eE"), text.npos) << text;
    }
    EXPECT_EQ(shown(-0.0, 3), "0");
    EXPECT_EQ(shown(-0.0, 3, 1), "0");
}

TEST(NumberInField, ShowsAllOfWhatWasTyped)
{
    EXPECT_EQ(shown(-0.05, 9), "-0.05");
    EXPECT_EQ(shown(0.004, 9), "0.004");
    EXPECT_EQ(shown(0.0247, 9), "0.0247");
    EXPECT_EQ(shown(129.5, 9), "129.5");
    EXPECT_EQ(shown(-464.5, 9), "-464.5");
    EXPECT_EQ(shown(0.4, 9), "0.40");
    EXPECT_EQ(shown(2, 9), "2.00");
    EXPECT_EQ(shown(1.0 / 3, 9), "0.3333");
    EXPECT_EQ(shown(23190840, 9, 1), "23190840");
}

TEST(NumberInField, IsLessExactWhereItIsNarrow)
{
    EXPECT_EQ(shown(-0.05, 5), "-0.05");
    EXPECT_EQ(shown(0.0247, 5), "0.025");
    EXPECT_EQ(shown(0.0247, 4), "0.02");
    EXPECT_EQ(shown(1.0 / 3, 4), "0.33");
}

} // namespace
} // namespace trivar::ui
