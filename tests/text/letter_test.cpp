// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/text/letter.h"

#include "core/base/digest.h"
#include "core/base/parallel.h"
#include "core/mesh/closed_body.h"
#include "core/text/installed_fonts.h"
#include "tests/mesh/edges.h"
#include "tests/plane/areas.h"

#include <gtest/gtest.h>

using namespace trivar;
using trivar::testing::count_edges;
using trivar::testing::EdgeCount;
using trivar::testing::volume;

namespace {

const Font& serif()
{
    static const Font font = find_font("DejaVu Serif").font;
    return font;
}

Region outline(const Font& font, char32_t letter, double tolerance = 0.001)
{
    const Font::Glyph glyph = font.glyph(font.line(std::u32string(1, letter), 0).glyphs.at(0).glyph,
                                         tolerance * em_units);
    return united(glyph.loops, glyph.even_odd);
}

double area_em(const Region& region)
{
    return static_cast<double>(trivar::testing::doubled_area(region)) / 2 / em_units / em_units;
}

int holes(const Region& region)
{
    int count = 0;
    for (const Loop& loop : region) count += trivar::testing::doubled_area({loop}) < 0 ? 1 : 0;
    return count;
}

int euler(const Mesh& mesh)
{
    const EdgeCount edges = count_edges(mesh);
    return edges.points - edges.edges + static_cast<int>(mesh.face_count());
}

void expect_closed(const Mesh& mesh)
{
    const EdgeCount edges = count_edges(mesh);
    EXPECT_EQ(edges.open, 0);
    EXPECT_EQ(edges.against, 0);
    EXPECT_EQ(edges.crowded, 0);
    EXPECT_TRUE(is_closed_body(mesh));
    EXPECT_GT(volume(mesh), 0);
}

Loop box(int x0, int y0, int x1, int y1)
{
    return {{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}};
}

double longest_edge(const Mesh& mesh)
{
    double longest = 0;
    for (std::size_t f = 0; f < mesh.face_count(); ++f)
        for (std::uint32_t c = mesh.face_begin[f]; c < mesh.face_begin[f + 1]; ++c) {
            const std::uint32_t next = c + 1 < mesh.face_begin[f + 1] ? c + 1 : mesh.face_begin[f];
            longest = std::max<double>(longest, glm::distance(mesh.positions[mesh.corners[c]],
                                                              mesh.positions[mesh.corners[next]]));
        }
    return longest;
}

constexpr std::u32string_view many =
    U"ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789"
    U"&@%$#?!;ÄÖÜäéñçßÅØæλΩЖשעح\u0639\u0645\uFDFA";

} // namespace

TEST(Letter, IsClosedAndLooksOutwardsWithEveryBevel)
{
    const Font& sans = find_font("DejaVu Sans").font;
    for (const Extrusion& extrusion :
         {Extrusion{.bevel = 0}, Extrusion{.bevel = 0.01, .bevel_steps = 1},
          Extrusion{.bevel = 0.03, .bevel_steps = 4}, Extrusion{.bevel = 0.5, .bevel_steps = 8},
          Extrusion{.depth = 0.4, .bevel = 0.15, .bevel_steps = 1, .max_edge = 0.03}})
        for (const Font* font : {&sans, &serif()})
            for (const char32_t letter : many) {
                SCOPED_TRACE(static_cast<unsigned>(letter));
                const std::optional<Mesh> body = letter_body(outline(*font, letter), extrusion);
                ASSERT_TRUE(body);
                expect_closed(*body);
                validate(*body, "letter");
            }
}

TEST(Letter, HasTheVolumeOfItsAreaTimesItsDepth)
{
    for (const char32_t letter : many) {
        const Region region = outline(serif(), letter);
        const Mesh body = letter_body(region, {.depth = 0.3}).value();
        EXPECT_NEAR(volume(body) / (area_em(region) * 0.3), 1, 1e-4) << unsigned(letter);
    }
}

// Two for each piece, less two for each hole through it.
TEST(Letter, HasTheEulerNumberOfItsPiecesAndHoles)
{
    for (const auto& [letter, expected] :
         {std::pair(U'I', 2), {U'O', 0}, {U'B', -2}, {U'i', 4}, {U'%', 2}, {U'8', -2}}) {
        const Region region = outline(serif(), letter);
        const int pieces = static_cast<int>(region.size()) - holes(region);
        EXPECT_EQ(2 * pieces - 2 * holes(region), expected);
        for (const double bevel : {0.0, 0.02, 0.4})
            EXPECT_EQ(euler(letter_body(region, {.bevel = bevel, .bevel_steps = 3}).value()),
                      expected)
                << bevel;
    }
}

TEST(Letter, KeepsItsEdgesShortForBending)
{
    for (const double longest : {0.2, 0.1, 0.03})
        for (const char32_t letter : std::u32string_view(U"AgM@\uFDFA")) {
            const Mesh body =
                letter_body(outline(serif(), letter), {.depth = 0.5, .max_edge = longest}).value();
            EXPECT_LE(longest_edge(body), longest * 1.0001) << unsigned(letter);
        }
}

// A chamfer of b takes a wedge b wide and b high from the rim before and behind: of a square with
// side a, 2 (a^2 b - (a^3 - (a - 2 b)^3) / 6).
TEST(Letter, LosesTheVolumeOfAChamfer)
{
    const double a = 1, b = 0.1, depth = 0.5;
    const Mesh body =
        letter_body({box(0, 0, em_units, em_units)}, {.depth = depth, .bevel = b}).value();
    const double inner = a - 2 * b;
    EXPECT_NEAR(volume(body),
                a * a * depth - 2 * (a * a * b - (a * a * a - inner * inner * inner) / 6), 1e-5);
    expect_closed(body);
}

TEST(Letter, StaysWithinItsOutlineAndItsDepth)
{
    const Region region = outline(serif(), U'R');
    const Box plain = bounding_box(letter_body(region, {.depth = 0.3}).value());
    const Box bevelled =
        bounding_box(letter_body(region, {.depth = 0.3, .bevel = 0.05, .bevel_steps = 4}).value());
    EXPECT_EQ(plain.lo, bevelled.lo);
    EXPECT_EQ(plain.hi.x, bevelled.hi.x);
    EXPECT_EQ(plain.hi.y, bevelled.hi.y);
    EXPECT_NEAR(plain.hi.z, 0.3, 1e-7);
    EXPECT_LE(bevelled.hi.z, plain.hi.z);
}

// The front is a height over the plane: seen from before, no face of it looks away.
TEST(Letter, FoldsNoBevelOver)
{
    for (const double bevel : {0.01, 0.05, 0.2})
        for (const int steps : {1, 5})
            for (const char32_t letter : many) {
                const Region region = outline(serif(), letter);
                const Mesh body =
                    letter_body(region, {.depth = 0.6, .bevel = bevel, .bevel_steps = steps})
                        .value();
                double seen = 0;
                for (std::size_t f = 0; f < body.face_count(); ++f) {
                    const glm::dvec3 n = area_normal(body, f);
                    if (n.z > 0) seen += n.z / 2;
                }
                EXPECT_NEAR(seen / area_em(region), 1, 1e-4) << unsigned(letter);
            }
}

TEST(Letter, HasNormalsAlongCurvesAndBreaksThemAtCorners)
{
    const Mesh square = letter_body({box(0, 0, em_units, em_units)}, {.depth = 0.3}).value();
    for (const glm::vec3& n : square.normals)
        EXPECT_EQ(std::abs(n.x) + std::abs(n.y) + std::abs(n.z), 1);
    for (const double bevel : {0.0, 0.02}) {
        const Mesh round =
            letter_body(outline(serif(), U'O'), {.bevel = bevel, .bevel_steps = 6}).value();
        for (std::size_t f = 0; f < round.face_count(); ++f) {
            const glm::dvec3 n = glm::normalize(area_normal(round, f));
            for (std::uint32_t c = round.face_begin[f]; c < round.face_begin[f + 1]; ++c) {
                const glm::dvec3 normal(round.normals[round.corners[c]]);
                EXPECT_NEAR(glm::length(normal), 1, 1e-6);
                EXPECT_GT(glm::dot(n, normal), 0.9);
            }
        }
    }
}

TEST(Letter, PartsWhatTouchesInAPoint)
{
    const int a = em_units / 4;
    const Region touching = united({box(0, 0, a, a), box(a, a, 2 * a, 2 * a)});
    const Mesh body = letter_body(touching, {}).value();
    expect_closed(body);
    EXPECT_EQ(euler(body), 4);
}

TEST(Letter, IsTheUnionOfContoursThatOverlap)
{
    const int a = em_units / 4;
    const Region cross = united({box(0, a, 3 * a, 2 * a), box(a, 0, 2 * a, 3 * a)});
    EXPECT_EQ(cross.size(), 1u);
    EXPECT_EQ(trivar::testing::doubled_area(cross), std::int64_t(a) * a * 10);
    expect_closed(letter_body(cross, {}).value());
}

TEST(Letter, IsTheSameBitsEachTime)
{
    const Region region = outline(serif(), U'&');
    const Extrusion extrusion{.bevel = 0.03, .bevel_steps = 4};
    EXPECT_EQ(letter_body(region, extrusion), letter_body(region, extrusion));
}
