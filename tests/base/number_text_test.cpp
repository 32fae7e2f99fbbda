// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/number_text.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <gtest/gtest.h>
#include <random>
#include <string>
#include <string_view>
#include <utility>

namespace trivar {
namespace {

// Returns numbers of every size that a double has, half of them as in scenes.
double any_number(std::mt19937_64& random)
{
    std::uniform_real_distribution<double> power(-14, 14), digits(-9.999, 9.999);
    const double of_ten = random() % 2 ? power(random) : 20 * power(random);
    return digits(random) * std::pow(10, of_ten);
}

// "-1,234.5" and "2.4·10⁻¹⁷" as numbers, by the library's own reader.
double read(std::string text)
{
    std::erase(text, ',');
    const std::pair<const char*, const char*> plain[] = {
        {"·10", "e"}, {"⁻", "-"}, {"⁰", "0"}, {"¹", "1"}, {"²", "2"}, {"³", "3"},
        {"⁴", "4"},   {"⁵", "5"}, {"⁶", "6"}, {"⁷", "7"}, {"⁸", "8"}, {"⁹", "9"}};
    for (const auto& [shown, read] : plain)
        for (std::size_t at; (at = text.find(shown)) != text.npos;)
            text.replace(at, std::string_view(shown).size(), read);
    char* end = nullptr;
    const double value = std::strtod(text.c_str(), &end);
    EXPECT_EQ(*end, 0) << text;
    return value;
}

TEST(NumberText, ReadsBackWithinItsDigits)
{
    std::mt19937_64 random;
    for (int i = 0; i < 20000; ++i) {
        const double value = any_number(random);
        const int digits = static_cast<int>(random() % 8) + 1;
        const std::string text =
            number_text(value, {digits, static_cast<int>(random() % 4), random() % 2 == 0});
        const double unit = std::pow(10, std::floor(std::log10(std::abs(value))) - (digits - 1));
        ASSERT_LE(std::abs(read(text) - value), 0.50001 * unit) << text << " " << value;
        const bool plain = text.find("·") == text.npos; // then no digit before the point is lost
        ASSERT_TRUE(!plain ||
                    std::abs(read(text) - value) <= std::max(0.50001, 1e-15 * std::abs(value)))
            << text;
    }
}

TEST(NumberText, HasNoExponentAndNoMinusAtNothing)
{
    std::mt19937_64 random;
    for (int i = 0; i < 20000; ++i) {
        const double value = any_number(random);
        const std::string text = number_text(value, {static_cast<int>(random() % 8) + 1});
        ASSERT_EQ(text.find_first_of("eE+"), text.npos) << text;
        ASSERT_NE(text.find_first_of("123456789"), text.npos) << text; // it tells it from 0
        const bool usual = std::abs(value) > 1e-9 && std::abs(value) < 9e14;
        ASSERT_TRUE(!usual || text.find("·") == text.npos) << text;
    }
    EXPECT_EQ(number_text(-0.0), "0");
    EXPECT_EQ(number_text(-0.0, {.digits = 3, .decimals = 2}), "0");
}

TEST(NumberText, IsWhatAPersonWouldWrite)
{
    EXPECT_EQ(number_text(0.24), "0.24");
    EXPECT_EQ(number_text(-0.05, {.digits = 1}), "-0.05");
    EXPECT_EQ(number_text(0.0247, {.digits = 2}), "0.025");
    EXPECT_EQ(number_text(0.004), "0.004");
    EXPECT_EQ(number_text(9.996), "10");
    EXPECT_EQ(number_text(999.7), "1,000");
    EXPECT_EQ(number_text(129.5, {.digits = 6}), "129.5");
    EXPECT_EQ(number_text(1834.2, {.digits = 2}), "1,834");
    EXPECT_EQ(number_text(2e2, {.digits = 2}), "200");
    EXPECT_EQ(number_text(23190840), "23,190,840");
    EXPECT_EQ(number_text(23190840, {.commas = false}), "23190840");
    EXPECT_EQ(number_text(0.4, {.decimals = 2}), "0.40");
    EXPECT_EQ(number_text(-3, {.decimals = 2}), "-3.00");
    EXPECT_EQ(number_text(12, {.decimals = 2}), "12.0");
    EXPECT_EQ(number_text(123, {.decimals = 2}), "123");
    EXPECT_EQ(number_text(1e-9), "0.000000001");
    EXPECT_EQ(number_text(HUGE_VAL), "infinite");
    EXPECT_EQ(number_text(std::nan("")), "not a number");
}

TEST(NumberText, SaysPowersOfTenWhereZerosWouldNotBeCounted)
{
    EXPECT_EQ(number_text(2.43e-17), "2.43·10⁻¹⁷");
    EXPECT_EQ(number_text(-1e300), "-1·10³⁰⁰");
    EXPECT_EQ(number_text(4.9e-324), "4.94·10⁻³²⁴");
    EXPECT_EQ(number_text(1e15), "1,000,000,000,000,000");
    EXPECT_EQ(number_text(2e16), "2·10¹⁶");
}

TEST(WithCommas, PartsThousands)
{
    EXPECT_EQ(with_commas(0), "0");
    EXPECT_EQ(with_commas(999), "999");
    EXPECT_EQ(with_commas(262144), "262,144");
    EXPECT_EQ(with_commas(18446744073709551615u), "18,446,744,073,709,551,615");
}

TEST(PercentText, HasTwoDigitsAtLeast)
{
    EXPECT_EQ(percent_text(0.0041), "0.41 %");
    EXPECT_EQ(percent_text(1.104), "110 %");
    EXPECT_EQ(percent_text(0.998), "100 %");
    EXPECT_EQ(percent_text(1e-7), "under 0.01 %");
    EXPECT_EQ(percent_text(0), "0 %");
}

} // namespace
} // namespace trivar
