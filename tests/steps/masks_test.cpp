// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/rejected.h"
#include "core/commands/command.h"
#include "core/commands/objects/animate.h"
#include "core/commands/objects/arrange.h"
#include "core/commands/objects/import.h"
#include "core/commands/objects/unwrap.h"
#include "core/commands/paste.h"
#include "core/commands/tiles/heights.h"
#include "core/commands/tiles/mask_tiles.h"
#include "core/commands/tiles/tiles.h"
#include "core/files/pictures/image.h"
#include "core/scene/moved_history.h"
#include "tests/support/fixtures.h"
#include "tests/support/scenes/commands.h"

#include <cstring>
#include <gmock/gmock.h>
#include <map>
#include <set>

namespace trivar {
namespace {

using namespace testing;
using ::testing::HasSubstr, ::testing::IsEmpty;

constexpr Id masked_ball = 2, masked_layer = 8, laid_pot = 3; // of fitting_document()
constexpr Id masked_base = 1, masked_tile = 2;                // of masked_cover()

// Small cylinders, filled over all of the ball.
Document masked_painting()
{
    Document document = after(fitting_document(), ClearTiles{{masked_layer}});
    TileStroke fill = a_tile_stroke();
    fill.brush = TileBrush::fill;
    fill.size = 0.1;
    return after(document, PaintTiles{masked_layer, masked_ball, fill});
}

// Flat tiles all over a torus.
Document masked_cover()
{
    const Document torus = after(Document{}, AddTorus{.shape = {0.5, 0.2, {24, 12}}});
    const Document both = after(torus, AddPlane{.shape = {{1, 1}, {4, 4}}, .transform = {}});
    CoverWithTiles cover{masked_tile, masked_base, {.pattern = TilePattern::grid, .per_face = 2}};
    return after(both, cover);
}

Document with_mask(const Document& document, const TileMask& mask, Id layer = masked_layer)
{
    return after(document, MaskTiles{layer, 0, mask});
}

TileMask even_mask(MaskDrives drives, double factor)
{
    return {.drives = drives, .low = factor, .high = factor};
}

Ref<EvaluatedObject> layer_shown(const Document& document, Id layer = masked_layer,
                                 double frame = 1)
{
    return new_evaluator()(document, frame).objects.at(layer);
}

// The middles of the patches.
std::vector<glm::dvec3> tile_places(const EvaluatedObject& layer)
{
    std::vector<glm::dvec3> out;
    for (const Part& part : layer.parts)
        for (const PlacedTile& tile : *part.tiles->tiles)
            out.push_back(tile_point(tile.patch, {0.5, 0.5, 0}).p);
    return out;
}

std::set<std::array<float, 3>> points_shown(const EvaluatedObject& layer)
{
    std::set<std::array<float, 3>> out;
    for (const Part& part : layer.parts)
        for (const glm::vec3& p : part.mesh()->positions) out.insert({p.x, p.y, p.z});
    return out;
}

// Sides of faces that no other face has, where points of the same bits are one.
int open_sides(const EvaluatedObject& layer)
{
    std::map<std::array<float, 3>, int> points;
    std::map<std::pair<int, int>, int> uses;
    for (const Part& part : layer.parts) {
        const Mesh& mesh = *part.mesh();
        std::vector<int> point;
        for (const glm::vec3& p : mesh.positions)
            point.push_back(
                points.try_emplace({p.x, p.y, p.z}, static_cast<int>(points.size())).first->second);
        for (std::size_t f = 0; f < mesh.face_count(); ++f)
            for (std::uint32_t c = mesh.face_begin[f]; c < mesh.face_begin[f + 1]; ++c) {
                const std::uint32_t next =
                    c + 1 < mesh.face_begin[f + 1] ? c + 1 : mesh.face_begin[f];
                ++uses[std::minmax(point[mesh.corners[c]], point[mesh.corners[next]])];
            }
    }
    return static_cast<int>(
        std::ranges::count_if(uses, [](const auto& each) { return each.second == 1; }));
}

// A picture whose left half is black.
std::string half_white(const TemporaryFolder& folder)
{
    Image image;
    image.size_px = {64, 8};
    for (int i = 0; i < 64 * 8; ++i)
        for (const int channel : {0, 1, 2, 3})
            image.rgba.push_back(channel == 3 || i % 64 >= 32 ? 255 : 0);
    write_image(image, folder.file("half.png"));
    return folder.file("half.png");
}

void expect_no_mask(const Document& document, const Command& command, const char* why)
{
    try {
        after(document, command);
        ADD_FAILURE() << "taken";
    } catch (const Rejected& rejected) {
        EXPECT_THAT(rejected.what(), HasSubstr(why));
    }
}

TEST(TileMasks, LeaveOutTilesAndMoveNone)
{
    const Document all = masked_painting();
    std::vector<glm::dvec3> before = tile_places(*layer_shown(all));
    for (const double density : {0.6, 0.25, 0.0}) {
        const auto now =
            tile_places(*layer_shown(with_mask(all, even_mask(MaskDrives::density, density))));
        EXPECT_NEAR(static_cast<double>(now.size()) /
                        static_cast<double>(tile_places(*layer_shown(all)).size()),
                    density, 0.1);
        for (const glm::dvec3& p : now) EXPECT_NE(std::ranges::find(before, p), before.end());
        before = now;
    }
}

TEST(TileMasks, AreFactorsOfTheLook)
{
    for (const bool cover : {false, true}) {
        const Document all = cover ? masked_cover() : masked_painting();
        const Id layer = cover ? masked_tile : masked_layer;
        const auto same = [&](const TileMask& mask, const TileLook& look) {
            EXPECT_EQ(digest(new_evaluator()(with_mask(all, mask, layer), 1)),
                      digest(new_evaluator()(after(all, SetTiles{{layer}, look}), 1)));
        };
        same(even_mask(MaskDrives::height, 2), {.height = 2});
        same(even_mask(MaskDrives::density, 1), {});
        if (!cover) same(even_mask(MaskDrives::scale, 0.5), {.scale = 0.5});
    }
}

TEST(TileMasks, LeaveHolesInACoverAndTheOtherTilesAsTheyWere)
{
    const Document all = masked_cover();
    const auto whole = points_shown(*layer_shown(all, masked_tile)),
               rest = points_shown(*layer_shown(
                   with_mask(all, even_mask(MaskDrives::density, 0.5), masked_tile), masked_tile));
    EXPECT_LT(rest.size(), whole.size());
    EXPECT_GT(rest.size(), whole.size() / 4);
    EXPECT_TRUE(std::ranges::includes(whole, rest));
}

TEST(TileMasks, KeepACoverWithoutGapsWhereTheyDriveItsHeight)
{
    // The tile is bent up in its middle, and its sides are raised.
    Document document = masked_cover();
    document = after(document, SetTransform{masked_tile, {.rotation_deg = {0, 0, 90}}});
    document = after(document, SetTiles{{masked_tile}, {.sink = -0.5}});
    EXPECT_EQ(open_sides(*layer_shown(document, masked_tile)), 0);
    const TileMask slope{.drives = MaskDrives::height,
                         .low = 0.25,
                         .high = 3,
                         .begin = {-0.7, 0, 0},
                         .end = {0.7, 0.1, 0}};
    const Document sloped = with_mask(document, slope, masked_tile);
    EXPECT_EQ(open_sides(*layer_shown(sloped, masked_tile)), 0);
}

TEST(TileMasks, ReadAnImageAlongAnAxisAndByTextureCoordinates)
{
    const TemporaryFolder folder;
    TileMask mask{.from = MaskFrom::image, .image = half_white(folder), .lies = MaskLies::along_y};
    const Document all = masked_painting();
    const auto xs = [&](const TileMask& with) {
        const Ref<EvaluatedObject> layer = layer_shown(with_mask(all, with));
        EXPECT_THAT(layer->notices, IsEmpty());
        std::pair<int, int> sides;
        for (const glm::dvec3& p : tile_places(*layer)) {
            if (std::abs(p.x) < 0.02 || std::abs(p.x) > 0.37) continue; // at its borders
            ++(p.x > 0 ? sides.second : sides.first);
        }
        return sides;
    };
    EXPECT_EQ(xs(mask).first, 0);
    EXPECT_GT(xs(mask).second, 10);
    mask.inverted = true;
    EXPECT_GT(xs(mask).first, 10);
    EXPECT_EQ(xs(mask).second, 0);
    // Round a sphere u goes about the axis: half of it has all tiles.
    mask.lies = MaskLies::uv;
    const std::size_t half = tile_places(*layer_shown(with_mask(all, mask))).size();
    EXPECT_NEAR(static_cast<double>(half),
                static_cast<double>(tile_places(*layer_shown(all)).size()) / 2,
                static_cast<double>(half) / 4);
}

TEST(TileMasks, GoRoundTheStrokeOfAnotherObjectWhileItIsThere)
{
    const Document all = masked_painting();
    TileMask mask{.from = MaskFrom::curve, .curve = laid_pot, .start = 0.1, .stop = 0.3};
    const Document masked = with_mask(all, mask);
    const std::size_t count = tile_places(*layer_shown(all)).size();
    const std::size_t near = tile_places(*layer_shown(masked)).size();
    EXPECT_GT(near, 0u);
    EXPECT_LT(near, count);
    mask.stop = 0.6;
    EXPECT_GT(tile_places(*layer_shown(with_mask(all, mask))).size(), near);
    const Document lost = after(masked, Delete{{laid_pot}});
    EXPECT_EQ(object(lost, masked_layer).tiles->masks[0].curve, 0);
    const Ref<EvaluatedObject> layer = layer_shown(lost);
    EXPECT_THAT(layer->notices, ::testing::Contains(HasSubstr("curve is no longer there")));
    EXPECT_EQ(tile_places(*layer).size(), count);
}

TEST(TileMasks, SayWhatTheyLackAndDoNothingThen)
{
    const Document all = masked_painting();
    const std::size_t count = tile_places(*layer_shown(all)).size();
    const Ref<EvaluatedObject> layer =
        layer_shown(with_mask(all, {.from = MaskFrom::image, .image = "/none/there.png"}));
    EXPECT_THAT(layer->notices, ::testing::Contains(HasSubstr("mask 1: ")));
    EXPECT_THAT(layer->lacks, ::testing::SizeIs(1));
    EXPECT_EQ(tile_places(*layer).size(), count);
}

TEST(TileMasks, AreRefusedInASentence)
{
    const Document all = masked_painting();
    expect_no_mask(all, MaskTiles{masked_ball, 0, {}}, "no layer of tiles");
    expect_no_mask(all, MaskTiles{masked_layer, 1, {}}, "none of number 1");
    expect_no_mask(all, MaskTiles{masked_layer, 0, {.from = MaskFrom::image}}, "no picture");
    const auto round = [](Id curve) {
        return MaskTiles{masked_layer, 0, {.from = MaskFrom::curve, .curve = curve}};
    };
    expect_no_mask(all, round(masked_layer), "no curve");
    expect_no_mask(all, round(1), "lies on a stroke");
    expect_no_mask(all, round(99), "99");
    Document full = all;
    for (std::size_t k = 0; k < most_masks; ++k) full = with_mask(full, {});
    expect_no_mask(full, MaskTiles{masked_layer, 0, {}}, "at most");
    expect_no_mask(all, RemoveTileMasks{masked_layer, {1}}, "none of number 1");
    EXPECT_THROW(check(MaskTiles{masked_layer, 0, {.low = std::nan("")}}), Rejected);
}

TEST(TileMasks, HaveKeysThatGoWithThem)
{
    Document document = with_mask(masked_painting(), even_mask(MaskDrives::height, 2));
    document = with_mask(document, even_mask(MaskDrives::density, 1));
    document = after(document, Animate{{{masked_layer,
                                         {{"tiles.masks.1.low", {{1, 0}, {11, 1, Tween::linear}}},
                                          {"tiles.masks.1.high", {{1, 0}, {11, 1, Tween::linear}}},
                                          {"tiles.masks.0.low", {{1, 3}}}}}}});
    const std::size_t late = tile_places(*layer_shown(document, masked_layer, 11)).size();
    EXPECT_EQ(tile_places(*layer_shown(document)).size(), 0u);
    EXPECT_GT(late, 20u);
    document = after(document, RemoveTileMasks{masked_layer, {1}});
    const Tracks& tracks = object(document, masked_layer).tracks;
    ASSERT_EQ(tracks.size(), 2u);
    EXPECT_EQ(tracks[0].parameter, "tiles.masks.0.high");
    EXPECT_EQ(tracks[1].parameter, "tiles.masks.0.low");
    EXPECT_EQ(tile_places(*layer_shown(document)).size(), 0u);
}

TEST(TileMasks, ArePastedWithWhatTheyGoRound)
{
    const Document document =
        with_mask(masked_painting(), {.from = MaskFrom::curve, .curve = laid_pot});
    const Document pasted = after(document, copied(document, {laid_pot, masked_layer}, "/models"));
    const Tiling& tiling = *object(pasted, document.next_id + 1).tiles;
    ASSERT_EQ(tiling.masks.size(), 1u);
    EXPECT_EQ(tiling.masks[0].curve, document.next_id);
    const Document alone = after(document, copied(document, {masked_layer}, "/models"));
    EXPECT_EQ(object(alone, document.next_id).tiles->masks,
              object(document, masked_layer).tiles->masks);
}

TEST(Displace, PutsEachPointAtItsHeightOverThePlane)
{
    const TemporaryFolder folder;
    DeepImage hills{{16, 16}, {}};
    for (int i = 0; i < 256; ++i)
        for (const int channel : {i * 255, i * 255, i * 255, 65535})
            hills.rgba.push_back(static_cast<std::uint16_t>(channel));
    write_file(folder.path() / "hills.png", encoded_image(hills, ".png"));
    const GreyImage image = read_grey_image(folder.file("hills.png"));
    const Document plane = after(Document{}, AddPlane{.shape = {{2, 2}, {1, 1}}, .transform = {}});
    const HeightShape shape{
        .image = folder.file("hills.png"), .height = 0.5, .level = 0.25, .segments = 20};
    const Document displaced = after(plane, Displace{.base = 1, .shape = shape});
    EXPECT_TRUE(object(displaced, 1).hidden);
    const Ref<EvaluatedObject> layer = layer_shown(displaced, 2);
    EXPECT_THAT(layer->notices, IsEmpty());
    std::size_t count = 0;
    for (const Part& part : layer->parts)
        for (const glm::vec3& p : part.mesh()->positions) {
            ++count;
            const double value = grey_at(image, glm::dvec2(p) / 2.0 + 0.5, ImageEdge::repeat);
            EXPECT_NEAR(p.z, 0.5 * (value - 0.25), 2e-6);
        }
    EXPECT_EQ(count, 21u * 21u);
    // Larger with its base.
    const Document large = after(displaced, SetTransform{1, {.scale = glm::dvec3(3)}});
    double highest = 0;
    const Ref<EvaluatedObject> larger = layer_shown(large, 2);
    for (const Part& part : larger->parts)
        for (const glm::vec3& p : part.mesh()->positions)
            highest = std::max(highest, static_cast<double>(p.z));
    EXPECT_GT(highest, 3 * 0.5 * 0.6);
}

TEST(Displace, LiesOverTheUvsOfAnyMesh)
{
    const TemporaryFolder folder;
    DeepImage hills{{16, 16}, {}}, black{{1, 1}, {0, 0, 0, 65535}};
    for (int i = 0; i < 256; ++i)
        for (const int channel : {i * 255, i * 255, i * 255, 65535})
            hills.rgba.push_back(static_cast<std::uint16_t>(channel));
    write_file(folder.path() / "hills.png", encoded_image(hills, ".png"));
    write_file(folder.path() / "black.png", encoded_image(black, ".png"));
    const GreyImage image = read_grey_image(folder.file("hills.png"));
    AddTorus torus;
    torus.shape = {.radius = 1, .tube = 0.4, .segments = {24, 12}};
    Document ring = after(Document{}, torus);
    ring = after(ring, Unwrap{.objects = {1}, .unwrapping = Unwrapping{}});
    const auto shown = [&](const std::string& name, double height, double level) {
        const Document displaced = after(ring, Displace{.base = 1,
                                                        .shape = {.image = folder.file(name),
                                                                  .height = height,
                                                                  .level = level,
                                                                  .segments = 5,
                                                                  .lies = HeightsLie::uv}});
        const Ref<EvaluatedObject> layer = layer_shown(displaced, 2);
        EXPECT_THAT(layer->notices, IsEmpty());
        EXPECT_EQ(layer->parts.size(), 1u);
        return layer->parts.front().mesh();
    };
    // P, and P + N, by sheets that are even.
    const Ref<Mesh> p = shown("black.png", 0, 0), with_n = shown("black.png", 0.01, -1),
                    all = shown("hills.png", 0.05, 0.25);
    ASSERT_EQ(all->vertex_count(), 24u * 12u * 36u);
    ASSERT_EQ(p->vertex_count(), all->vertex_count());
    double most = 0;
    for (std::size_t v = 0; v < all->vertex_count(); ++v) {
        const double h =
            0.05 * (grey_at(image, glm::dvec2(all->uvs.front()[v]), ImageEdge::repeat) - 0.25);
        const glm::dvec3 at(p->positions[v]), n = (glm::dvec3(with_n->positions[v]) - at) / 0.01;
        EXPECT_NEAR(glm::length(n), 1, 1e-4); // of single precision
        most = std::max(most, glm::distance(at + h * n, glm::dvec3(all->positions[v])));
    }
    EXPECT_LT(most, 2e-6); // of single precision
}

TEST(Displace, LiesOverEachFaceOfWhatHasNoUvs)
{
    const TemporaryFolder folder;
    const DeepImage grey{{1, 1}, {32768, 32768, 32768, 65535}};
    write_file(folder.path() / "grey.png", encoded_image(grey, ".png"));
    write_file(folder.path() / "sheet.off", "OFF\n4 1 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n4 0 1 2 3\n");
    ImportModel import;
    import.file.path = folder.file("sheet.off");
    const Document sheet = after(Document{}, import);
    const Ref<EvaluatedObject> layer =
        layer_shown(after(sheet, Displace{.base = 1,
                                          .shape = {.image = folder.file("grey.png"),
                                                    .height = 0.1,
                                                    .segments = 4,
                                                    .lies = HeightsLie::uv}}),
                    2);
    EXPECT_THAT(layer->notices, ::testing::Contains(HasSubstr("has no UVs")));
    ASSERT_EQ(layer->parts.size(), 1u);
    for (const glm::vec3& p : layer->parts[0].mesh()->positions) EXPECT_NEAR(p.z, 0.05, 1e-4);
}

TEST(TileMasks, FindTheirPictureWhereTheSceneHasMoved)
{
    History history;
    history.run(AddTorus{});
    history.run(AddPlane{});
    history.run(CoverWithTiles{masked_tile, masked_base, {.pattern = TilePattern::grid}});
    history.run(MaskTiles{masked_tile, 0, {.from = MaskFrom::image, .image = "pictures/a.png"}});
    history.run(AddHeights{.shape = {.image = "pictures/b.png"}});
    EXPECT_TRUE(imports_by_relative_path(history));
    std::vector<std::string> files;
    moved(history, "/scenes/old", "/scenes/new")
        .retell(
            [&](const History::Step& step) {
                if (const auto* mask = step.command.as<MaskTiles>())
                    files.push_back(mask->mask.image);
                if (const auto* heights = step.command.as<AddHeights>())
                    files.push_back(heights->shape.image);
            },
            [] {});
    EXPECT_THAT(files, ::testing::ElementsAre("../old/pictures/a.png", "../old/pictures/b.png"));
}

TEST(Displace, SaysWhenItsPictureIsMissing)
{
    const Document plane = after(Document{}, AddPlane{});
    const Document displaced =
        after(plane, Displace{.base = 1, .shape = {.image = "/none/there.png"}});
    const Ref<EvaluatedObject> layer = layer_shown(displaced, 2);
    EXPECT_THAT(layer->lacks, ::testing::Not(IsEmpty()));
    EXPECT_THROW(
        prepare(Displace{.base = 1, .shape = {.image = "/none/there.png"}}, AssetStore(".")),
        Rejected);
    expect_no_mask(plane, Displace{.base = 1}, "no picture");
    expect_no_mask(plane, Displace{.base = 7, .shape = {.image = "a.png"}}, "7");
}

} // namespace
} // namespace trivar
