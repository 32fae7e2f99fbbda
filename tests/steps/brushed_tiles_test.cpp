// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/commands/command.h"
#include "core/commands/objects/primitives.h"
#include "core/commands/tiles/mix_tiles.h"
#include "core/commands/tiles/tiles.h"
#include "core/document/document_digest.h"
#include "core/export/rigid_tiles.h"
#include "tests/support/scenes/commands.h"

#include <gmock/gmock.h>

namespace trivar {
namespace {

using namespace testing;

constexpr Id round_base = 2, brushed = 13, flat_box = 14;

Ref<EvaluatedObject> layer_in(const Document& document)
{
    return new_evaluator()(document, 1).objects.at(brushed);
}

// A layer of cubes on a ball; beside it a flat box, which has the same vertices and faces.
Document cubes_on_ball(double size = 0.1)
{
    Document document = fitting_document();
    document = after(document, AddBox{.shape = {.size = glm::dvec3(0.2), .segments = {1, 1, 1}}});
    document = after(document, AddBox{.shape = {.size = {0.2, 0.2, 0.05}, .segments = {1, 1, 1}}});
    TileStroke stroke = a_tile_stroke();
    stroke.radius = 0.3;
    stroke.size = size;
    return after(document, PaintTiles{brushed, round_base, stroke, {}});
}

// The same with one more stroke over its middle.
Document brushed_over(TileStroke stroke, Document document = cubes_on_ball())
{
    const TileStroke over = a_tile_stroke();
    stroke.samples = over.samples;
    stroke.radius = 0.12;
    return after(document, PaintTiles{brushed, round_base, stroke, {}});
}

std::size_t lowered_in(const Document& document)
{
    const Ref<EvaluatedObject> layer = layer_in(document);
    std::size_t count = 0;
    for (const Part& part : layer->parts)
        for (const PlacedTile& tile : *part.tiles->tiles) count += tile.of_limit > 1;
    for (const std::string& notice : layer->notices)
        EXPECT_EQ(count > 0, notice.find("lowered") != notice.npos) << notice;
    return count;
}

TEST(BrushedTiles, ShowHowHighTheyMayBeBeforeOneOfThemIsLowered)
{
    // A box bent over the inner side of a torus folds when it is high.
    Document document = fitting_document();
    document = after(document, AddBox{.shape = {.size = glm::dvec3(0.2), .segments = {1, 1, 1}}});
    document = after(document, AddTorus{.shape = {.radius = 0.5, .tube = 0.2}});
    TileStroke stroke;
    for (int i = 0; i < 9; ++i) {
        const double angle = 0.1 * i;
        const glm::dvec3 out(std::cos(angle), std::sin(angle), 0);
        stroke.samples.push_back({{0.3 * out, -out}, 0.1 * i, 1}); // on the inner rim
    }
    stroke.radius = 0.1;
    stroke.size = 0.1;
    document = after(document, PaintTiles{brushed, flat_box, stroke, {}});
    const Ref<EvaluatedObject> layer = layer_in(document);
    const double limit = layer->height_limit;
    ASSERT_TRUE(std::isfinite(limit));
    EXPECT_GT(limit, 1);
    EXPECT_EQ(layer->stroke_limits, std::vector<double>{limit});
    EXPECT_EQ(lowered_in(document), 0u);
    const auto at_height = [&](double height) {
        return after(document, SetTiles{{brushed}, {.height = height}});
    };
    EXPECT_EQ(lowered_in(at_height(limit * (1 - 1e-9))), 0u);
    EXPECT_GT(lowered_in(at_height(limit * 1.001)), 0u);
    // The limit belongs to the layer as it stands, and not to how high it is now.
    EXPECT_NEAR(layer_in(at_height(3 * limit))->height_limit, limit, 1e-9 * limit);
    EXPECT_NEAR(layer_in(at_height(0))->height_limit, limit, 1e-9 * limit);
    // That of a stroke, in its own height.
    TileStroke higher = stroke;
    higher.height = limit * (1 - 1e-9);
    EXPECT_EQ(lowered_in(after(document, EditTileStroke{brushed, 1, higher})), 0u);
    EXPECT_FALSE(std::isfinite(
        layer_in(after(document, SetTiles{{brushed}, {.guard = false}}))->height_limit));
}

TEST(BrushedTiles, CarryTheirColourIntoTheMeshAndAreNoInstancesThen)
{
    TileStroke color;
    color.brush = TileBrush::color;
    color.color = {0.5, 0.25, 0};
    const Ref<EvaluatedObject> plain = layer_in(cubes_on_ball()),
                               colored = layer_in(brushed_over(color));
    EXPECT_TRUE(plain->parts.at(0).mesh()->colors.empty());
    const Part& part = colored->parts.at(0);
    const Mesh& mesh = *part.mesh();
    EXPECT_EQ(mesh.positions, plain->parts.at(0).mesh()->positions);
    const PlacedTiles& tiles = *part.tiles->tiles;
    ASSERT_EQ(mesh.colors.size(), mesh.vertex_count());
    const std::size_t per_tile = mesh.vertex_count() / tiles.size();
    std::size_t tinted = 0;
    for (std::size_t i = 0; i < tiles.size(); ++i) {
        EXPECT_EQ(mesh.colors[i * per_tile], glm::vec4(tiles[i].tint, 1));
        tinted += is_tinted(tiles[i]);
    }
    EXPECT_GT(tinted, 0u);
    EXPECT_LT(tinted, tiles.size());
    const std::vector<RigidTile> rigid = rigid_tiles({&part}, 1, in_single_precision);
    for (std::size_t i = 0; i < tiles.size(); ++i)
        EXPECT_EQ(rigid[i].way == RigidTile::Way::bent, is_tinted(tiles[i]));
}

TEST(BrushedTiles, BecomeTheOtherShapeWhereTheyWereBrushed)
{
    const Document document = after(cubes_on_ball(0.05), MorphTiles{brushed, flat_box});
    TileStroke morph;
    morph.brush = TileBrush::morph;
    morph.strength = 1;
    const auto heights = [&](const Document& of) { // about a side, and a quarter of it
        std::size_t high = 0, low = 0;
        const Ref<EvaluatedObject> layer = layer_in(of);
        for (const Part& part : layer->parts) {
            double top = 0;
            for (const glm::vec3& p : part.mesh()->positions)
                top = std::max(top, static_cast<double>(glm::length(p)) - 0.4);
            high += top > 0.045;
            low += top < 0.02;
        }
        return glm::ivec2(high, low);
    };
    EXPECT_EQ(heights(document), glm::ivec2(1, 0));
    const glm::ivec2 after_brush = heights(brushed_over(morph, document));
    EXPECT_GE(after_brush.x, 1);
    EXPECT_GE(after_brush.y, 1);
    // Where all have become the other shape a brush takes none further.
    const Document all = after(document, SetTiles{{brushed}, {.morph = 1}});
    EXPECT_EQ(heights(brushed_over(morph, all)).x, 0);
    morph.strength = -1; // and brings some back
    EXPECT_GE(heights(brushed_over(morph, all)).x, 1);
}

TEST(BrushedTiles, SayHowManyOverlapAndLeaveThemOutOnDemand)
{
    TileStroke twice = a_tile_stroke();
    twice.brush = TileBrush::line; // which lays tiles whatever is there
    twice.size = 0.1;
    const Document document = after(cubes_on_ball(), PaintTiles{brushed, round_base, twice, {}});
    const Ref<EvaluatedObject> all = layer_in(document);
    EXPECT_GT(all->overlapping, 1u);
    EXPECT_LE(all->overlapping, all->painted);
    const Document without = after(document, SetTiles{{brushed}, {.keep_overlaps = false}});
    const Ref<EvaluatedObject> rest = layer_in(without);
    EXPECT_THAT(rest->notices, ::testing::Contains(::testing::HasSubstr("overlap earlier ones")));
    EXPECT_LT(rest->parts.at(0).tiles->tiles->size(), all->parts.at(0).tiles->tiles->size());
    EXPECT_EQ(rest->overlapping, 0u);
}

// How far a vertex of a mesh may be from the mirror image of the nearest other one, metres.
double asymmetry(const Mesh& mesh)
{
    double most = 0;
    for (const glm::vec3& p : mesh.positions) {
        double nearest = 1e300;
        for (const glm::vec3& q : mesh.positions)
            nearest =
                std::min(nearest, static_cast<double>(glm::distance(p * glm::vec3(1, -1, 1), q)));
        most = std::max(most, nearest);
    }
    return most;
}

// Above 0 where faces and normals look out of a closed mesh, all of them.
double least_outward(const Mesh& mesh, std::size_t tiles)
{
    const std::size_t per_tile = mesh.vertex_count() / tiles;
    double least = 1e300;
    for (std::size_t t = 0; t < tiles; ++t) {
        glm::vec3 middle(0);
        for (std::size_t v = 0; v < per_tile; ++v)
            middle += mesh.positions[t * per_tile + v] / static_cast<float>(per_tile);
        for (std::size_t v = 0; v < per_tile; ++v) {
            const std::size_t at = t * per_tile + v;
            least = std::min(least, static_cast<double>(
                                        glm::dot(mesh.normals[at], mesh.positions[at] - middle)));
        }
    }
    return least;
}

TEST(BrushedTiles, AreMirrorImagesBeyondTheMirrorOnDemand)
{
    // A bar that lies askew in its box has another mirror image than itself.
    Document skew = fitting_document();
    skew = after(skew, AddBox{.shape = {.size = {0.2, 0.05, 0.05}, .segments = {1, 1, 1}},
                              .transform = {.rotation_deg = {0, 0, 25}}});
    const auto painted = [&](bool images, const TileLook& look = {}) {
        TileStroke stroke;
        stroke.brush = TileBrush::line;
        for (int i = 0; i < 5; ++i) {
            const double angle = 0.4 + 0.2 * i;
            const glm::dvec3 n{std::cos(angle), std::sin(angle), 0};
            stroke.samples.push_back({{0.4 * n, n}, 0.1 * i, 1});
        }
        stroke.size = 0.1;
        stroke.turn_variation_deg = 20;
        stroke.mirror = TileMirror::y;
        stroke.mirrors_tiles = images;
        const Document document = after(skew, PaintTiles{brushed, round_base, stroke, {}});
        return layer_in(after(document, SetTiles{{brushed}, look}));
    };
    const Ref<EvaluatedObject> alike = painted(false), images = painted(true);
    ASSERT_EQ(alike->parts.size(), 1u);
    ASSERT_EQ(images->parts.size(), 2u);
    EXPECT_EQ(images->tile_objects, (std::vector<Id>{brushed, brushed}));
    const auto all = [](const EvaluatedObject& layer) {
        Mesh out;
        for (const Part& part : layer.parts)
            out.positions.insert(out.positions.end(), part.mesh()->positions.begin(),
                                 part.mesh()->positions.end());
        return out;
    };
    EXPECT_GT(asymmetry(all(*alike)), 0.01);
    EXPECT_LT(asymmetry(all(*images)), 0.002); // triangles of the ball are not symmetrical
    // So they are however the layer turns, slides and cuts its tiles.
    const TileLook look{.turn_deg = 35, .slide_x = 0.3, .slide_y = 0.2, .cell_y0 = 0.3};
    EXPECT_LT(asymmetry(all(*painted(true, look))), 0.002);
    for (const Part& part : images->parts)
        EXPECT_GT(least_outward(*part.mesh(), part.tiles->tiles->size()), 0);
}

TEST(BrushedTiles, KeepTheDigestsOfScenesWithoutTheirNewFields)
{
    const auto digest_with = [](auto&& change) {
        TileStroke stroke = a_tile_stroke();
        change(stroke);
        return digest(after(cubes_on_ball(), PaintTiles{brushed, round_base, stroke, {}}));
    };
    const std::string usual = digest_with([](TileStroke&) {});
    EXPECT_EQ(usual, digest_with([](TileStroke& s) { s.point = {}, s.color = glm::dvec3(1); }));
    EXPECT_NE(usual, digest_with([](TileStroke& s) { s.point = {0, 0, 1}; }));
    EXPECT_NE(usual, digest_with([](TileStroke& s) { s.mirror = TileMirror::y; }));
    EXPECT_NE(usual, digest_with([](TileStroke& s) { s.mirrors_tiles = true; }));
    EXPECT_NE(usual, digest_with([](TileStroke& s) { s.area = TileArea::all; }));
    EXPECT_NE(usual, digest_with([](TileStroke& s) { s.factor = 0; }));
}

} // namespace
} // namespace trivar
