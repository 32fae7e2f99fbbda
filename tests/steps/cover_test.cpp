// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/parallel.h"
#include "core/base/rejected.h"
#include "core/commands/command.h"
#include "core/commands/objects/animate.h"
#include "core/commands/objects/arrange.h"
#include "core/commands/objects/import.h"
#include "core/commands/objects/primitives.h"
#include "core/commands/paste.h"
#include "core/commands/tiles/mix_tiles.h"
#include "core/commands/tiles/tiles.h"
#include "core/commands/volumes/lattice.h"
#include "core/commands/volumes/warp.h"
#include "core/document/document_digest.h"
#include "tests/support/scenes/commands.h"

#include <cstring>
#include <gmock/gmock.h>
#include <map>

namespace trivar {
namespace {

using namespace testing;

constexpr Id covered_base = 1, cover_tile = 2;

Evaluation evaluation_of(const Document& document, double frame = 1)
{
    return new_evaluator()(document, frame);
}

// A base as object 1, and a flat tile of four by four quads.
Document with_tile(const Command& base)
{
    return after(after(Document{}, base),
                 AddPlane{.name = "Tile", .shape = {{1, 1}, {4, 4}}, .transform = {}});
}

Document on_box()
{
    return with_tile(AddBox{.name = "Box", .shape = {{1, 1, 1}, {2, 2, 2}}, .transform = {}});
}

Document on_torus_cage(int levels)
{
    ImportModel import;
    import.file.path = std::string(TRIVAR_BINARY_DIR) + "/assets/models/cages/torus.obj";
    import.file.subdivisions = levels;
    return with_tile(import);
}

CoverWithTiles cover_by(TilePattern pattern, double size = 0.1)
{
    return {cover_tile, covered_base, {.pattern = pattern, .size = size}};
}

const EvaluatedObject& covering_in(const Evaluation& evaluation)
{
    return *evaluation.objects.at(cover_tile);
}

std::size_t vertices_in(const Evaluation& evaluation)
{
    std::size_t all = 0;
    for (const Part& part : covering_in(evaluation).parts) all += part.vertex_count();
    return all;
}

std::vector<glm::vec3> positions_in(const Evaluation& evaluation)
{
    std::vector<glm::vec3> out;
    for (const Part& part : covering_in(evaluation).parts)
        out.insert(out.end(), part.mesh()->positions.begin(), part.mesh()->positions.end());
    return out;
}

double largest_distance(const Evaluation& evaluation)
{
    double most = 0;
    for (const glm::vec3& p : positions_in(evaluation))
        most = std::max(most, static_cast<double>(glm::length(p)));
    return most;
}

// Edges of all tiles together that have one face, where vertices of equal bits are one.
std::size_t open_edges(const Evaluation& evaluation)
{
    std::map<std::array<std::uint32_t, 3>, std::size_t> known;
    std::map<std::pair<std::size_t, std::size_t>, int> uses;
    for (const Part& part : covering_in(evaluation).parts) {
        const Mesh& mesh = *part.mesh();
        std::vector<std::size_t> point;
        for (const glm::vec3& p : mesh.positions) {
            std::array<std::uint32_t, 3> bits{};
            std::memcpy(bits.data(), &p, sizeof bits);
            point.push_back(known.try_emplace(bits, known.size()).first->second);
        }
        for (std::size_t f = 0; f < mesh.face_count(); ++f)
            for (std::uint32_t c = mesh.face_begin[f]; c < mesh.face_begin[f + 1]; ++c) {
                const std::uint32_t next =
                    c + 1 < mesh.face_begin[f + 1] ? c + 1 : mesh.face_begin[f];
                ++uses[std::minmax(point[mesh.corners[c]], point[mesh.corners[next]])];
            }
    }
    return static_cast<std::size_t>(
        std::ranges::count_if(uses, [](const auto& edge) { return edge.second != 2; }));
}

// The poles of a ball are triangles: there a side of a cell has no length.
TEST(CoversOfTriangles, HaveNormalsThatGoWithTheFacesOfTheTiles)
{
    Document document =
        after(Document{}, AddSphere{.shape = {.radius = 1, .segments = 8, .rings = 4}});
    document = after(document, AddBox{.shape = {{1, 1, 0.2}, {2, 2, 1}}});
    for (const double size : {0.2, 1.0}) {
        CoverWithTiles cover = cover_by(TilePattern::grid, size);
        cover.cover.even_height = true;
        const Evaluation covered = evaluation_of(after(document, cover));
        std::size_t looked_at = 0;
        for (const Part& part : covering_in(covered).parts) {
            const Mesh& mesh = *part.mesh();
            for (const glm::uvec3& t : triangles(mesh)) {
                const glm::dvec3 a(mesh.positions[t.x]), b(mesh.positions[t.y]),
                    c(mesh.positions[t.z]), across = glm::cross(b - a, c - a);
                const double longest =
                    std::max({glm::distance(a, b), glm::distance(b, c), glm::distance(c, a)});
                if (glm::length(across) < 1e-3 * longest * longest) continue;
                for (const std::uint32_t v : {t.x, t.y, t.z})
                    EXPECT_GT(glm::dot(glm::normalize(across), glm::dvec3(mesh.normals[v])), 0.8);
                ++looked_at;
            }
        }
        EXPECT_GT(looked_at, 500u);
    }
}

TEST(Covers, LieAllOverTheFacesOfTheirBaseAndFollowIt)
{
    const Document document = after(
        on_box(),
        CoverWithTiles{cover_tile, covered_base, {.pattern = TilePattern::grid, .per_face = 1}});
    const Evaluation before = evaluation_of(document);
    EXPECT_THAT(covering_in(before).notices, ::testing::IsEmpty());
    EXPECT_EQ(vertices_in(before), 24 * 25u);
    EXPECT_NEAR(largest_distance(before), std::sqrt(0.75), 1e-6);
    EXPECT_EQ(open_edges(before), 0u);
    Transform there;
    there.translation = {3, 0, 1};
    there.rotation_deg = {0, 0, 90};
    there.scale = {2, 2, 1};
    const Evaluation moved = evaluation_of(after(document, SetTransform{covered_base, there}));
    const std::vector<glm::vec3> was = positions_in(before), now = positions_in(moved);
    ASSERT_EQ(was.size(), now.size());
    for (std::size_t v = 0; v < was.size(); ++v)
        EXPECT_LT(
            glm::distance(glm::dvec3(there.matrix() * glm::dvec4(was[v], 1)), glm::dvec3(now[v])),
            2e-6);
}

TEST(Covers, LieOnTheLimitSurfaceHoweverFinelyTheBaseIsShown)
{
    for (const TilePattern pattern : {TilePattern::grid, TilePattern::brick}) {
        const Evaluation coarse = evaluation_of(after(on_torus_cage(1), cover_by(pattern))),
                         fine = evaluation_of(after(on_torus_cage(3), cover_by(pattern)));
        EXPECT_THAT(covering_in(coarse).notices, ::testing::IsEmpty());
        EXPECT_GT(vertices_in(coarse), 100 * 25u);
        EXPECT_EQ(positions_in(coarse), positions_in(fine));
        EXPECT_FALSE(covering_in(coarse).parts.front().tiles == nullptr);
    }
}

TEST(Covers, HaveNoGapsInWhatIsExported)
{
    const auto open = [](const Document& document, TilePattern pattern) {
        return open_edges(evaluation_of(after(document, cover_by(pattern, 0.15))));
    };
    EXPECT_EQ(open(on_torus_cage(2), TilePattern::grid), 0u);
    EXPECT_EQ(open(on_box(), TilePattern::grid), 0u);
    // Bricks have vertices in the middles of their sides, where they meet those of other rows; on a
    // box, where rows end, half a brick would have them elsewhere.
    EXPECT_EQ(open(on_torus_cage(2), TilePattern::brick), 0u);
}

TEST(Covers, PutPatchesWhereTheirMeshIs)
{
    const Document raised =
        with_tile(AddTorus{.name = "Ring", .shape = {.segments = {16, 8}}, .transform = {}});
    const Evaluation all = evaluation_of(after(raised, cover_by(TilePattern::brick)));
    std::size_t patched = 0;
    for (const Part& part : covering_in(all).parts) {
        if (!part.tiles) continue;
        const std::vector<glm::vec3> drawn =
            bent_tiles(*part.tiles->model->mesh, *part.tiles->tiles).positions;
        const std::vector<glm::vec3>& exported = part.mesh()->positions;
        ASSERT_EQ(drawn.size(), exported.size());
        for (std::size_t v = 0; v < drawn.size(); ++v)
            EXPECT_LT(glm::distance(drawn[v], exported[v]), 5e-5);
        patched += part.tiles->tiles->size();
    }
    EXPECT_GT(patched, 50u);
}

TEST(Covers, GoWithABaseThatALatticeBends)
{
    const Document still = after(on_torus_cage(2), cover_by(TilePattern::grid));
    const Document bent = after(after(still, AddLattice{.objects = {covered_base}}),
                                WarpVolume{.object = 3, .warp = {.bend_deg = 40, .taper = 0.5}});
    const Evaluation all = evaluation_of(bent);
    EXPECT_EQ(vertices_in(all), vertices_in(evaluation_of(still)));
    EXPECT_NE(positions_in(all), positions_in(evaluation_of(still)));
    const Mesh& base = *all.objects.at(covered_base)->parts.at(0).mesh();
    double most = 0;
    const std::vector<glm::vec3> tiles = positions_in(all);
    for (std::size_t v = 0; v < tiles.size(); v += 37) {
        float least = 1e30f;
        for (const glm::vec3& p : base.positions)
            least = std::min(least, glm::distance(p, tiles[v]));
        most = std::max(most, static_cast<double>(least));
    }
    EXPECT_LT(most, 0.06); // the distance of the base's own vertices
}

TEST(Covers, OfAMirrorImageStandOutside)
{
    Document document = after(on_torus_cage(2), AddBox{.shape = {.size = {1, 1, 0.5}}});
    constexpr Id stud = 3;
    CoverWithTiles cover = cover_by(TilePattern::grid);
    cover.object = stud;
    Transform mirror;
    mirror.scale = {-1, 1, 1};
    document = after(document, cover);
    const auto box = [&](const Document& of) {
        return *evaluation_of(of).objects.at(stud)->bounds;
    };
    const Box before = box(document),
              now = box(after(document, SetTransform{covered_base, mirror}));
    EXPECT_NEAR(now.size().x, before.size().x, 1e-3);
    EXPECT_NEAR(now.size().z, before.size().z, 1e-3);
}

TEST(Covers, AreLoweredWhereTheyWouldFold)
{
    Document document = after(on_torus_cage(2), AddBox{.shape = {.size = {1, 1, 9}}});
    CoverWithTiles cover = cover_by(TilePattern::grid);
    cover.object = 3;
    document = after(document, cover);
    const auto notices = [](const Document& of) {
        return evaluation_of(of).objects.at(3)->notices;
    };
    EXPECT_THAT(notices(document), ::testing::Contains(::testing::HasSubstr("lowered")));
    EXPECT_THAT(notices(after(document, SetTiles{{3}, {.guard = false}})), ::testing::IsEmpty());
    EXPECT_THAT(notices(after(document, SetTiles{{3}, {.height = 0.05}})), ::testing::IsEmpty());
}

TEST(Covers, TakeKeysForTheirHeights)
{
    Document document = after(on_torus_cage(2), AddBox{.shape = {.size = {1, 1, 0.5}}});
    CoverWithTiles cover = cover_by(TilePattern::grid);
    cover.object = 3;
    document =
        after(after(document, cover),
              Animate{{{3,
                        {{.parameter = "tiles.cover.height_variation",
                          .keys = {{.frame = 1, .value = 0}, {.frame = 11, .value = 1}}}}}}});
    const auto at = [&](double frame) { return evaluation_of(document, frame).objects.at(3); };
    const auto a = at(1)->parts.at(0).mesh(), b = at(11)->parts.at(0).mesh();
    ASSERT_EQ(a->positions.size(), b->positions.size());
    EXPECT_NE(a->positions, b->positions);
}

TEST(Covers, GrowFromBelow)
{
    Document document = after(on_torus_cage(2), cover_by(TilePattern::grid));
    std::size_t before = 0;
    for (const double growth : {0.0, 0.3, 0.6, 1.0}) {
        const std::size_t now =
            vertices_in(evaluation_of(after(document, SetTiles{{cover_tile}, {.growth = growth}})));
        EXPECT_EQ(now == 0, growth == 0);
        EXPECT_GE(now, before);
        before = now;
    }
}

TEST(Covers, AreTheSameForAnyNumberOfThreads)
{
    const auto with = [](int threads) {
        const ThreadLimit limit(threads);
        return digest(evaluation_of(after(on_torus_cage(2), cover_by(TilePattern::hexagon))));
    };
    EXPECT_EQ(with(1), with(2));
}

TEST(Covers, StandBesidePaintedTilesAndGoWithoutThem)
{
    Document document = after(fitting_document(), ClearTiles{{8}});
    document = after(document, PaintTiles{8, 2, a_tile_stroke()});
    const CoverWithTiles cover{8, 2, {.pattern = TilePattern::grid, .size = 0.3}};
    const Document covered = after(document, cover);
    EXPECT_EQ(object(covered, 8).tiles->strokes, object(document, 8).tiles->strokes);
    const auto parts = [](const Document& of) {
        return evaluation_of(of).objects.at(8)->parts.size();
    };
    EXPECT_GT(parts(covered), parts(document));
    EXPECT_EQ(digest(after(covered, CoverWithTiles{8, 2, {}})), digest(document));
    const Document pasted = after(covered, copied(covered, {8}, ""));
    EXPECT_EQ(object(pasted, covered.next_id).tiles->cover, cover.cover);
    EXPECT_EQ(object(pasted, covered.next_id).tiles->strokes.size(), 1u);
}

TEST(Covers, AreMixedFromSeveralObjects)
{
    Document document = after(on_torus_cage(2), AddBox{.shape = {.size = {1, 1, 0.5}}});
    CoverWithTiles cover = cover_by(TilePattern::grid);
    const std::size_t flat = vertices_in(evaluation_of(after(document, cover)));
    cover.others = {{3, 1}};
    document = after(document, cover);
    const Evaluation mixed = evaluation_of(document);
    EXPECT_THAT(covering_in(mixed).notices, ::testing::IsEmpty());
    EXPECT_EQ(covering_in(mixed).parts.size(), 2u);
    EXPECT_NE(vertices_in(mixed), flat);
    std::size_t tiles = 0;
    for (const Part& part : covering_in(mixed).parts) tiles += part.tiles->tiles->size();
    EXPECT_EQ(tiles, flat / 25);
}

void expect_no_cover(const Document& document, const Command& command, const char* why)
{
    try {
        after(document, command);
        ADD_FAILURE() << "taken: " << why;
    } catch (const Rejected& rejected) {
        EXPECT_THAT(rejected.what(), ::testing::HasSubstr(why));
    }
}

TEST(Covers, RefuseWhatMakesNoSense)
{
    const Document document = fitting_document();
    const TileCover grid{.pattern = TilePattern::grid};
    expect_no_cover(document, CoverWithTiles{8, 8, grid}, "on itself");
    expect_no_cover(document, CoverWithTiles{2, 8, grid}, "depends on");
    expect_no_cover(document, CoverWithTiles{8, 1, grid}, "is painted on");
    expect_no_cover(document, CoverWithTiles{1, 4, grid}, "no surface");
    expect_no_cover(document, CoverWithTiles{3, 2, grid}, "lies on a stroke");
    expect_no_cover(document, CoverWithTiles{8, 99, grid}, "99");
    expect_no_cover(document, CoverWithTiles{1, 2, {}}, "choose a pattern");
    const auto with = [](auto change) {
        CoverWithTiles cover{8, 2, {.pattern = TilePattern::grid}};
        change(cover.cover);
        return cover;
    };
    expect_no_cover(document, with([](TileCover& c) { c.per_face = 5000; }), "per_face");
    expect_no_cover(document, with([](TileCover& c) { c.size = std::nan(""); }), "size");
    expect_no_cover(document, with([](TileCover& c) { c.size = 0; }), "size");
    expect_no_cover(document, with([](TileCover& c) { c.height_variation = 2; }),
                    "height_variation");
}

TEST(Covers, SayWhyThereIsNone)
{
    const auto notices = [](const Document& document) {
        const Evaluation all = evaluation_of(document);
        EXPECT_TRUE(covering_in(all).shows_nothing());
        return covering_in(all).notices;
    };
    EXPECT_THAT(notices(after(on_torus_cage(2), cover_by(TilePattern::grid, 1e-4))),
                ::testing::Contains(::testing::HasSubstr("tiles to cover it; at most 200,000")));
    CoverWithTiles crowded = cover_by(TilePattern::brick);
    crowded.cover.per_face = 1000;
    EXPECT_THAT(notices(after(on_torus_cage(2), crowded)),
                ::testing::Contains(::testing::HasSubstr("60,000,000 tiles to cover it")));
    ImportModel missing;
    missing.file.path = "nowhere.obj";
    EXPECT_THAT(notices(after(with_tile(missing), cover_by(TilePattern::grid))),
                ::testing::Contains(::testing::HasSubstr("no surface")));
    const Document document = after(on_torus_cage(2), cover_by(TilePattern::grid));
    EXPECT_THAT(notices(after(document, Delete{{covered_base}})),
                ::testing::Contains(::testing::HasSubstr("no longer")));
}

TEST(Covers, SayThatFacesAreTooSmallForTheirTiles)
{
    const auto notices = [](double size) {
        const Evaluation all = evaluation_of(
            after(with_tile(AddSphere{.name = "Ball", .shape = {0.5, 32, 16}, .transform = {}}),
                  cover_by(TilePattern::grid, size)));
        EXPECT_FALSE(covering_in(all).shows_nothing());
        return covering_in(all).notices;
    };
    EXPECT_THAT(notices(0.4), ::testing::Contains(::testing::HasSubstr("smaller than their size")));
    EXPECT_THAT(notices(0.08), ::testing::IsEmpty());
}

TEST(PaintedTiles, StandOnTheLimitSurfaceHoweverFinelyTheBaseIsShown)
{
    const Evaluation bare = evaluation_of(on_torus_cage(2));
    const Mesh& shown = *bare.objects.at(covered_base)->parts.at(0).rest;
    TileStroke stroke; // from a vertex, which subdivide() puts on the limit surface
    stroke.brush = TileBrush::fill;
    stroke.size = 0.08;
    stroke.samples = {{{glm::dvec3(shown.positions[0]), glm::dvec3(shown.normals[0])}}};
    const auto painted = [&](int levels) {
        return evaluation_of(
            after(on_torus_cage(levels), PaintTiles{cover_tile, covered_base, stroke}));
    };
    EXPECT_GT(vertices_in(painted(3)), 50 * 25u);
    EXPECT_EQ(positions_in(painted(3)), positions_in(painted(1)));
}

// Half a metre high on a plane of a metre, which two tiles cross; what they become is a fifth of
// it.
TEST(Covers, MorphWithTheirTile)
{
    const auto block = [](double height) {
        return AddBox{.name = "Block", .shape = {{0.1, 0.1, height}, {1, 1, 1}}, .transform = {}};
    };
    Document document =
        after(Document{}, AddPlane{.name = "Base", .shape = {{1, 1}, {2, 2}}, .transform = {}});
    document = after(after(document, block(0.1)), block(0.02));
    document = after(
        document,
        CoverWithTiles{cover_tile, covered_base, {.pattern = TilePattern::grid, .per_face = 1}});
    document = after(document, MorphTiles{cover_tile, 3});
    const auto height = [&](double morph) {
        const Document moved = after(document, SetTiles{{cover_tile}, {.morph = morph}});
        double highest = 0;
        for (const glm::vec3& p : positions_in(evaluation_of(moved)))
            highest = std::max(highest, static_cast<double>(p.z));
        return highest;
    };
    EXPECT_NEAR(height(0), 0.5, 1e-6);
    EXPECT_NEAR(height(0.5), 0.3, 1e-6);
    EXPECT_NEAR(height(1), 0.1, 1e-6);
    EXPECT_NEAR(height(-0.5), 0.7, 1e-6);
}

} // namespace
} // namespace trivar
