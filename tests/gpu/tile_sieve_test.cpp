// SPDX-License-Identifier: GPL-3.0-or-later
// The graphics card chooses the tiles that the processor chooses.
#include "gpu/passes/tools.h"
#include "tests/gpu/support.h"
#include "tests/patches/patches.h"
#include "tests/support/buffer_traffic.h"
#include "tests/support/draw_calls.h"

#include <epoxy/gl.h>
#include <set>

namespace trivar::gpu::testing {
namespace {

using trivar::testing::random_tiles;

Ref<TileModel> model_of(const Mesh& mesh)
{
    return tile_model(in_unit_cell(mesh, glm::dmat4(1), {{0, 0, -0.15}, 1, 0.3}));
}

Instance layer_of(const Ref<TileModel>& model, int count, double room, int id)
{
    std::mt19937 random(static_cast<unsigned>(count));
    std::uniform_real_distribution<double> place(-room, room);
    std::vector<PlacedTile> tiles;
    for (int i = 0; i < count; ++i)
        tiles.push_back(trivar::testing::random_tile(
            random, {place(random), place(random), place(random)}, 0.3));
    Instance out = instance_of(*model->mesh);
    out.mesh = model->mesh;
    out.tiles = tile_set(model, make_ref(PlacedTiles::cut(tiles)));
    out.id = id;
    return out;
}

// A layer cut to its first tiles.
Instance first_of(const Instance& layer, std::size_t count)
{
    std::vector<PlacedTile> tiles = layer.tiles->tiles->all();
    tiles.resize(std::min(count, tiles.size()));
    Instance out = layer;
    out.tiles = tile_set(layer.tiles->model, make_ref(PlacedTiles::cut(tiles)), layer.tiles);
    return out;
}

class ChosenTiles : public WithContext {
protected:
    // Lists hold the tiles that are drawn, by instance and level.
    using Lists = std::vector<std::vector<std::vector<std::uint32_t>>>;

    static std::vector<std::uint32_t> numbers_in(const Buffer& buffer)
    {
        std::vector<std::uint32_t> out(buffer.bytes() / sizeof(std::uint32_t));
        buffer.read(std::as_writable_bytes(std::span(out)));
        return out;
    }
    static std::vector<std::uint32_t> list_of(const MirroredCopies& seen)
    {
        std::size_t count = static_cast<std::size_t>(seen.upright), begin = 0;
        if (seen.chosen) {
            const std::size_t command = 8 * seen.first_command;
            count = numbers_in(seen.chosen->commands)[command + 1];
            begin = seen.level * seen.chosen->capacity;
        }
        if (count == 0) return {};
        const std::vector<std::uint32_t> all =
            numbers_in(seen.chosen ? seen.chosen->rows : seen.rows);
        const auto first = all.begin() + static_cast<std::ptrdiff_t>(begin);
        return {first, first + static_cast<std::ptrdiff_t>(count)};
    }
    static Lists lists_of(const TileMirror& tiles, const Picture& picture)
    {
        Lists out;
        for (std::size_t i = 0; i < picture.instances.size(); ++i) {
            out.emplace_back();
            if (const DrawnTiles* drawn = tiles.of(i))
                for (const DrawnTiles::Level& level : drawn->levels)
                    out.back().push_back(level.chosen ? list_of(level.seen)
                                                      : std::vector<std::uint32_t>());
        }
        return out;
    }
    // Walls at different distances, in squares of a few texels.
    static std::vector<float> depths_of_walls(const glm::dmat4& projection, glm::ivec2 size,
                                              std::mt19937& random)
    {
        std::uniform_real_distribution<double> distance(2, 16);
        std::vector<float> squares, out;
        for (int i = 0; i < 64; ++i) {
            const glm::dvec4 p = projection * glm::dvec4(0, 0, -distance(random), 1);
            squares.push_back(static_cast<float>(0.5 * p.z / p.w + 0.5));
        }
        for (int y = 0; y < size.y; ++y)
            for (int x = 0; x < size.x; ++x)
                out.push_back(
                    squares[static_cast<std::size_t>(8 * (8 * y / size.y) + 8 * x / size.x)]);
        return out;
    }
    // Draws the picture by both; returns how unlike the pictures are, in bytes.
    static std::size_t unlike(const Picture& picture, Renderer& by_processor, Renderer& by_card)
    {
        by_processor.choose_tiles_on_card(false);
        by_card.choose_tiles_on_card(true);
        const Image a = by_processor.render(picture, {160, 120}),
                    b = by_card.render(picture, {160, 120});
        glFinish();
        EXPECT_EQ(by_processor.tile_counts(), by_card.tile_counts());
        std::size_t out = 0;
        for (std::size_t i = 0; i < a.rgba.size(); ++i) out += a.rgba[i] != b.rgba[i];
        return out;
    }
};

TEST_F(ChosenTiles, AreTheSameByTheCardToTheLastOne)
{
    const Instance rings = layer_of(model_of(torus_mesh(0.35, 0.15, {48, 24})), 1500, 4, 1);
    Instance balls = layer_of(model_of(sphere_mesh(0.4, 24, 16)), 700, 3, 2);
    balls.to_world = glm::scale(moved(1, 0, 0.5), glm::dvec3(-1, 1, 1.5));
    std::mt19937 random(11);
    std::uniform_real_distribution<double> share(0, 1);
    Mirror mirror;
    Programs programs;
    TileMirror by_processor, by_card;
    by_processor.choose_on_card(false);
    by_card.choose_on_card(true);
    std::size_t drawn = 0, hidden = 0, outside = 0, changed = 0;
    std::set<std::size_t> levels;
    Lists before;
    Picture picture;
    for (int i = 0; i < 40; ++i) {
        const std::size_t some = i % 7 == 3 ? 900 : i % 7 == 5 ? 1100 : 1500;
        picture.instances = {first_of(rings, some), balls};
        picture.draft = i % 9 != 8;
        Camera camera; // most pictures are a little nearer or further than the one before
        const double turn = 0.7 * (i / 8), away = 7 + 3 * std::sin(0.9 * i) + share(random);
        camera.eye = {away * std::cos(turn), away * std::sin(turn), 3 * share(random)};
        camera.perspective = i % 5 != 4;
        camera.size_px = {320, 200};
        const glm::dmat4 projection = projection_matrix(camera, 0.1, 60);
        const glm::dmat4 to_clip = projection * view_matrix(camera);
        const glm::ivec2 size(37 + i, 21);
        const std::vector<float> depths = depths_of_walls(projection, size, random);
        Texture2D texture(GL_R32F, size);
        texture.bind(0);
        glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
        glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, size.x, size.y, GL_RED, GL_FLOAT, depths.data());
        DevicePyramid pyramid;
        pyramid.write(programs, texture);
        const DepthPyramid same(depths, size);
        std::vector<float> found(same.depths().size());
        ASSERT_EQ(pyramid.depths().bytes(), found.size() * sizeof(float));
        pyramid.depths().read(std::as_writable_bytes(std::span(found)));
        ASSERT_TRUE(std::ranges::equal(found, same.depths()));

        const bool walls = i % 3 != 2;
        by_processor.update(picture, camera, mirror, programs);
        by_processor.show(walls ? same : DepthPyramid(), to_clip);
        by_card.update(picture, camera, mirror, programs);
        ASSERT_TRUE(by_card.on_card());
        by_card.show(walls ? &pyramid : nullptr, to_clip, programs);
        const Lists lists = lists_of(by_card, picture);
        ASSERT_EQ(lists_of(by_processor, picture), lists) << "picture " << i;
        glFinish();
        const TileCounts counts = by_card.counts();
        EXPECT_EQ(counts, by_processor.counts()) << "picture " << i;
        drawn += counts.drawn;
        hidden += counts.hidden;
        outside += counts.outside();
        for (std::size_t l = 0; l < counts.by_level.size(); ++l)
            if (counts.by_level[l] > 0) levels.insert(l);
        changed += lists != before;
        before = lists;
    }
    EXPECT_GT(drawn, 5000u);
    EXPECT_GT(hidden, 3000u);
    EXPECT_GT(outside, 5000u);
    EXPECT_GT(levels.size(), 3u);
    EXPECT_GT(changed, 30u);
}

TEST_F(ChosenTiles, MakeTheSamePicturesByTheCard)
{
    Picture picture;
    Material two;
    two.base_color = {0.8f, 0.3f, 0.2f, 1};
    Mesh ring = torus_mesh(0.35, 0.15, {24, 12});
    for (std::size_t f = 0; f < ring.face_count() / 2; ++f) ring.face_material.push_back(0);
    ring.face_material.resize(ring.face_count(), 1);
    picture.instances = {layer_of(model_of(ring), 500, 2, 7),
                         instance_of(box_mesh({3, 0.2, 3}, glm::ivec3(1)), moved(0, -2.5, 0))};
    picture.instances.front().materials = make_ref(std::vector<Material>{{}, two});
    picture.settings.ground = false; // that of drafts may lag
    picture.samples = 1;
    Renderer by_processor, by_card;
    std::size_t hidden = 0;
    for (const bool draft : {true, false})
        for (const double away : {5.0, 4.6, 14.0, 5.2}) {
            picture.draft = draft;
            picture.camera.eye = {0.4 * away, -away, 0.3 * away};
            EXPECT_EQ(unlike(picture, by_processor, by_card), 0u) << draft << " " << away;
            hidden += by_card.tile_counts().hidden;
        }
    EXPECT_GT(hidden, 100u);
    Picture edges = picture, outlined = picture, glass = picture;
    edges.settings.wire = true;
    outlined.instances.front().highlighted = true;
    glass.instances.front().opacity = 0.5f;
    for (const Picture& other : {edges, outlined, glass, picture})
        EXPECT_EQ(unlike(other, by_processor, by_card), 0u);
}

TEST_F(ChosenTiles, AreNotReadBackAndTakeNoMoreCalls)
{
    Picture picture;
    picture.instances = {layer_of(model_of(torus_mesh(0.35, 0.15, {32, 16})), 900, 2, 7)};
    picture.draft = true;
    std::array<int, 2> calls{};
    for (const bool on_card : {false, true}) {
        Renderer renderer;
        renderer.choose_tiles_on_card(on_card);
        renderer.draw(picture, {160, 120});
        trivar::testing::BufferTraffic traffic;
        const trivar::testing::DrawCalls drawn;
        picture.camera.eye.x += 0.3;
        renderer.draw(picture, {160, 120});
        calls[on_card] = drawn.count;
        EXPECT_LE(traffic.read_back, LateCounts::kinds * sizeof(std::uint32_t)) << on_card;
        if (on_card) {
            EXPECT_LT(traffic.largest_written(), 4096u) << "nothing for each tile";
        }
    }
    EXPECT_GT(calls[0], 1);
    EXPECT_LE(calls[1], calls[0] + 2 * TileRule::most_levels) << "a call for each level";
}

} // namespace
} // namespace trivar::gpu::testing
