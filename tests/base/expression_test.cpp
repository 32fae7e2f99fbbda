// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/expression.h"

#include <cmath>
#include <gtest/gtest.h>
#include <string>

namespace trivar {
namespace {

double plain(std::string_view text)
{
    return evaluate_expression(text, Measure::plain).value_or(NAN);
}
double length(std::string_view text, double present = 0)
{
    return evaluate_expression(text, Measure::length, present).value_or(NAN);
}
double angle(std::string_view text)
{
    return evaluate_expression(text, Measure::angle).value_or(NAN);
}

TEST(Expression, IsReadAsPeopleWriteIt)
{
    EXPECT_EQ(plain("1.25"), 1.25);
    EXPECT_EQ(plain(" .5 "), 0.5);
    EXPECT_EQ(plain("2e3"), 2000);
    EXPECT_EQ(plain("1 + 2 * 3"), 7);
    EXPECT_EQ(plain("(1 + 2) * 3"), 9);
    EXPECT_EQ(plain("10 - 4 - 3"), 3);
    EXPECT_EQ(plain("12 / 3 / 2"), 2);
    EXPECT_EQ(plain("2^3^2"), 512);
    EXPECT_EQ(plain("-2^2"), -4);
    EXPECT_EQ(plain("2^-1"), 0.5);
    EXPECT_EQ(plain("--1"), 1);
}

TEST(Expression, KnowsItsFunctions)
{
    EXPECT_DOUBLE_EQ(plain("sin(pi / 2)"), 1);
    EXPECT_DOUBLE_EQ(plain("cos(0) + sqrt(9)"), 4);
    EXPECT_DOUBLE_EQ(angle("sin(30)"), 0.5);
    EXPECT_EQ(plain("min(3, 1, 2)"), 1);
    EXPECT_EQ(plain("max(3, 1, 2)"), 3);
}

TEST(Expression, CarriesUnitsOfWhatItMeasures)
{
    EXPECT_DOUBLE_EQ(length("12 mm"), 0.012);
    EXPECT_DOUBLE_EQ(length("12mm + 0.5 in"), 0.0247);
    EXPECT_DOUBLE_EQ(length("1 ft"), 0.3048);
    EXPECT_DOUBLE_EQ(length("(1 + 2) cm"), 0.03);
    EXPECT_DOUBLE_EQ(length("2 * 3 m"), 6);
    EXPECT_EQ(angle("30 deg"), 30);
    EXPECT_DOUBLE_EQ(angle("pi rad"), 180);
    EXPECT_TRUE(std::isnan(length("30 deg")));
    EXPECT_TRUE(std::isnan(angle("3 mm")));
    EXPECT_TRUE(std::isnan(plain("3 m")));
}

TEST(Expression, ChangesWhatIsThere)
{
    EXPECT_EQ(length("+=0.5", 2), 2.5);
    EXPECT_EQ(length("-= 50 cm", 2), 1.5);
    EXPECT_EQ(length("*=2", 2), 4);
    EXPECT_EQ(length("/=2", 2), 1);
    EXPECT_EQ(length("=7", 2), 7);
    EXPECT_EQ(length("+7", 2), 7) << "a sign is no change";
}

TEST(Expression, GivesNothingWhereItCannotBeRead)
{
    for (const char* text :
         {"",           " ",        "1 +", "(1",   "1)",    "1 2",  "sqrt", "sqrt()",
          "sqrt(1, 2)", "sqrt(-1)", "1/0", "nan",  "inf",   "e",    "1..2", "--",
          "+=",         "*=2 m",    "1,5", "0x10", "2 mmm", "sin 3"})
        EXPECT_FALSE(evaluate_expression(text, Measure::length, 1)) << text;
    EXPECT_FALSE(evaluate_expression(std::string(100000, '('), Measure::plain));
    EXPECT_FALSE(evaluate_expression(std::string(100000, '-'), Measure::plain));
}

} // namespace
} // namespace trivar
