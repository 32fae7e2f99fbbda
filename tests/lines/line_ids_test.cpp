// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/lines/line_ids.h"

#include <gtest/gtest.h>

namespace trivar::testing {
namespace {

Stroke line_from(const glm::vec3& from, const glm::vec3& to, std::uint64_t id)
{
    Stroke out;
    out.id = id;
    for (int i = 0; i <= 100; ++i) {
        const glm::vec3 p = glm::mix(from, to, static_cast<float>(i) / 100);
        out.points.push_back({.at = glm::vec2(p), .p = p});
    }
    return out;
}

std::vector<std::uint64_t> ids_after(LineIds& ids, std::vector<Stroke> strokes)
{
    ids(std::span(&strokes, 1));
    std::vector<std::uint64_t> out;
    for (const Stroke& stroke : strokes) out.push_back(stroke.id);
    return out;
}

using Ids = std::vector<std::uint64_t>;

TEST(LineIds, StayWithLinesThatMove)
{
    LineIds ids;
    EXPECT_EQ(
        ids_after(ids, {line_from({0, 0, 0}, {50, 0, 0}, 7), line_from({0, 9, 0}, {50, 9, 0}, 8)}),
        (Ids{7, 8}));
    EXPECT_EQ(ids_after(ids, {line_from({1, 9.5f, 0}, {51, 9.5f, 0}, 1),
                              line_from({0, 0.5f, 0.5f}, {50, 0.5f, 0.5f}, 2)}),
              (Ids{8, 7}));
}

TEST(LineIds, GoToTheLongestPartOfALineThatBreaks)
{
    LineIds ids;
    ids_after(ids, {line_from({0, 0, 0}, {50, 0, 0}, 7)});
    EXPECT_EQ(
        ids_after(ids, {line_from({0, 0, 0}, {15, 0, 0}, 3), line_from({16, 0, 0}, {50, 0, 0}, 4)}),
        (Ids{3, 7}));
}

TEST(LineIds, ComeBackWithALineThatWasJoinedToAnother)
{
    LineIds ids;
    const Stroke whole = line_from({0, 0, 0}, {50, 0, 0}, 1),
                 first = line_from({0, 0, 0}, {15, 0, 0}, 2),
                 second = line_from({16, 0, 0}, {50, 0, 0}, 3);
    EXPECT_EQ(ids_after(ids, {first, second}), (Ids{2, 3}));
    EXPECT_EQ(ids_after(ids, {whole}), (Ids{3}));
    EXPECT_EQ(ids_after(ids, {first, second}), (Ids{2, 3}));
}

TEST(LineIds, AreNeverTheSameForTwoLines)
{
    LineIds ids;
    ids_after(ids, {line_from({0, 0, 0}, {50, 0, 0}, 7)});
    EXPECT_EQ(ids_after(ids, {line_from({0, 0, 0}, {50, 0, 0}, 3),
                              line_from({0, 30, 0}, {50, 30, 0}, 7)}),
              (Ids{7, 8}));
}

} // namespace
} // namespace trivar::testing
