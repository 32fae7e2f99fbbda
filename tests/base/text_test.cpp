// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/text.h"

#include "core/base/rejected.h"
#include "tests/support/fixtures.h"

#include <bit>
#include <clocale>
#include <cmath>
#include <cstdint>
#include <fstream>
#include <gtest/gtest.h>
#include <limits>
#include <random>

namespace trivar {
namespace {

TEST(Shortest, ReadsBackAsTheSameBits)
{
    std::mt19937_64 random;
    for (int i = 0; i < 20000; ++i) {
        const double value = std::bit_cast<double>(random());
        if (!std::isfinite(value)) continue;
        const auto back = parse_number(shortest(value));
        ASSERT_TRUE(back.has_value());
        ASSERT_EQ(std::bit_cast<std::uint64_t>(*back), std::bit_cast<std::uint64_t>(value));
        const float single = std::bit_cast<float>(static_cast<std::uint32_t>(random()));
        if (!std::isfinite(single)) continue;
        ASSERT_EQ(static_cast<float>(*parse_number(shortest(single))), single);
    }
}

TEST(Shortest, IsShort)
{
    EXPECT_EQ(shortest(0.1), "0.1");
    EXPECT_EQ(shortest(0.1f), "0.1");
    EXPECT_EQ(shortest(3.0), "3");
    EXPECT_EQ(shortest(-0.0), "-0");
    EXPECT_EQ(shortest(1e300), "1e+300");
}

TEST(Shortest, KnowsNoLocale)
{
    const std::string before = std::setlocale(LC_NUMERIC, nullptr);
    std::setlocale(LC_NUMERIC, "de_DE.UTF-8"); // may not exist; then there is nothing to disturb
    EXPECT_EQ(shortest(0.5), "0.5");
    EXPECT_EQ(parse_number("0.5"), 0.5);
    std::setlocale(LC_NUMERIC, before.c_str());
}

TEST(ParseNumber, TakesWholeFiniteNumbersOnly)
{
    EXPECT_EQ(parse_number("-12.5e-1"), -1.25);
    EXPECT_EQ(parse_number("7"), 7.0);
    for (const char* text : {"", " ", "1 ", " 1", "1.2.3", "nan", "inf", "-inf", "1e999", "0x10",
                             "1,5", "+1", "--1", "e5", "one", "1f"})
        EXPECT_FALSE(parse_number(text).has_value()) << text;
    EXPECT_FALSE(parse_number(std::string_view("1\0", 2)).has_value());
}

TEST(ReadTextFile, GivesEveryByte)
{
    const testing::TemporaryFolder folder;
    const std::string content("a\r\nb\0c\xff", 7);
    std::ofstream(folder.file("x"), std::ios::binary) << content;
    EXPECT_EQ(read_text_file(folder.file("x")), content);
    std::ofstream(folder.file("empty")) << "";
    EXPECT_EQ(read_text_file(folder.file("empty")), "");
}

TEST(ReadTextFile, NamesTheFileThatIsMissingOrAFolder)
{
    const testing::TemporaryFolder folder;
    const auto sentence = [](const std::string& path) {
        try {
            read_text_file(path);
        } catch (const Rejected& rejected) {
            return std::string(rejected.what());
        }
        return std::string("was read");
    };
    const std::string missing = folder.file("none.txt");
    EXPECT_NE(sentence(missing).find(missing), std::string::npos);
    EXPECT_NE(sentence(missing).find("there is no such file"), std::string::npos);
    EXPECT_NE(sentence(folder.path().string()).find("folder"), std::string::npos);
}

} // namespace
} // namespace trivar
