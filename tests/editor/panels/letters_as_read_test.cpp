// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/panels/inspector/letters_as_read.h"

#include "core/text/installed_fonts.h"
#include "core/text/text_shape.h"

#include <gtest/gtest.h>

namespace trivar {
namespace {

TEST(LettersAsRead, AreTheFrontsOfTheLettersWithARimThatCloses)
{
    const TextShape shape{.text = "\u05E9\u05DC\u05D5\u05DD", .depth = 0.25};
    const TextBody text = text_body(shape, find_font(shape.font).font);
    const LetterFronts fronts = letter_fronts(text.mesh);
    double area = 0, round = 0, volume = 0;
    const auto cross = [](const glm::dvec2& a, const glm::dvec2& b) {
        return a.x * b.y - a.y * b.x;
    };
    for (const auto& [a, b, c] : fronts.triangles)
        area += cross(glm::dvec2(b - a), glm::dvec2(c - a)) / 2;
    for (const auto& [a, b] : fronts.rim) round += cross(a, b) / 2;
    const Mesh& mesh = text.mesh;
    for (std::size_t f = 0; f < mesh.face_count(); ++f)
        for (std::uint32_t c = mesh.face_begin[f] + 1; c + 1 < mesh.face_begin[f + 1]; ++c) {
            const auto p = [&](std::uint32_t k) {
                return glm::dvec3(mesh.positions[mesh.corners[k]]);
            };
            volume += glm::dot(p(mesh.face_begin[f]), glm::cross(p(c), p(c + 1))) / 6;
        }
    EXPECT_GT(area, 0.01);
    EXPECT_NEAR(area, round, 1e-5) << "Green's theorem";
    EXPECT_NEAR(area * shape.depth, volume, 1e-5);
}

TEST(LettersAsRead, AreShownWhereTheFieldDoesNotShowThem)
{
    for (const char* text : {"Text", "\u00E9\u00FC \u0416\u03A9", "\u1EA0 \u2013 \u20AC", ""})
        EXPECT_TRUE(field_shows(text)) << text;
    for (const char* text : {"\u05E9\u05DC\u05D5\u05DD", "a \u0645\u0631\u062D\u0628\u0627",
                             "\u0905", "\u4E2D", "\U0001F600"})
        EXPECT_FALSE(field_shows(text)) << text;
}

} // namespace
} // namespace trivar
