// SPDX-License-Identifier: GPL-3.0-or-later
// Tiles that the vertex stage bends, beside the mesh of all of them that the processor bends.
#include "gpu/ffd/blind_draw.h"
#include "gpu/tiles/tile_mirror.h"
#include "tests/gpu/support.h"
#include "tests/patches/patches.h"
#include "tests/support/buffer_traffic.h"
#include "tests/support/draw_calls.h"

#include <epoxy/gl.h>
#include <functional>

namespace trivar::gpu::testing {
namespace {

constexpr glm::ivec2 tiles_px{160, 120};

// One level, so that both ways draw the same triangles.
Ref<TileModel> ring_model(bool levels = false)
{
    Mesh unit =
        in_unit_cell(torus_mesh(0.35, 0.15, {24, 12}), glm::dmat4(1), {{0, 0, -0.15}, 1, 0.3});
    unit.tangents.resize(unit.vertex_count());
    for (std::size_t v = 0; v < unit.vertex_count(); ++v)
        unit.tangents[v] = {glm::normalize(glm::cross(glm::vec3(0.1f, 0.2f, 1), unit.normals[v])),
                            1};
    const Ref<TileModel> model = tile_model(std::move(unit));
    if (levels) return model;
    return make_ref(TileModel{model->mesh, model->box, Lazy<std::vector<TileLevel>>([model] {
                                  return std::vector<TileLevel>{{model->mesh, 0}};
                              })});
}

// Rows of tiles on a wavy ground of that many sides across.
std::vector<PlacedTile> tiles_on_waves(int across, double side = 0.5)
{
    std::vector<PlacedTile> out;
    const auto ground = [](double x, double y) {
        return glm::dvec3(x, y, 0.15 * std::sin(2 * x) + 0.1 * std::cos(3 * y));
    };
    for (int i = 0; i < across * across; ++i) {
        const glm::dvec2 corner =
            side * (glm::dvec2(i % across, i / across) - across / 2.0) + 0.05 * side;
        std::array<glm::dvec3, 16> p, n;
        for (std::size_t k = 0; k < 16; ++k) {
            const glm::dvec2 at =
                corner + 0.9 * side * glm::dvec2(patch_nodes[k % 4], patch_nodes[k / 4]);
            const double h = 1e-4;
            p[k] = ground(at.x, at.y);
            n[k] = glm::normalize(glm::cross(ground(at.x + h, at.y) - ground(at.x - h, at.y),
                                             ground(at.x, at.y + h) - ground(at.x, at.y - h)));
        }
        out.push_back({{through_nodes(p), through_nodes(n)}, side, -0.02 * side});
    }
    return out;
}

// A picture of tiles, and the same of their mesh.
struct TilePair {
    Picture tiles, mesh;
    explicit TilePair(const Ref<TileSet>& set = tile_set(ring_model(),
                                                         make_ref(PlacedTiles(tiles_on_waves(6)))),
                      const glm::dmat4& to_world = glm::dmat4(1), Material material = {})
    {
        tiles.camera.eye = {1, -5, 4};
        tiles.samples = 1;
        mesh = tiles;
        tiles.instances = {instance_of(*set->model->mesh, to_world, material)};
        Instance& one = tiles.instances.front();
        one.mesh = set->model->mesh;
        one.tiles = set;
        one.id = 7;
        mesh.instances = {one};
        mesh.instances.front().tiles = nullptr;
        mesh.instances.front().mesh = *set->mesh;
        each([](Picture& picture) {
            picture.instances.push_back(
                instance_of(box_mesh({9, 9, 0.2}, glm::ivec3(1)), moved(0, 0, -0.6)));
        });
    }
    void each(const std::function<void(Picture&)>& change)
    {
        change(tiles);
        change(mesh);
    }
};

class TilesOnCard : public WithContext {
protected:
    // The share of pixels in which a channel differs by more than that, of 255. Where a position is
    // another by its last bit, an edge may fall on the other side of a pixel's middle.
    static double unlike(const Image& a, const Image& b, int more_than = 3)
    {
        std::size_t count = 0;
        for (std::size_t i = 0; i < a.rgba.size(); i += 4) {
            int most = 0;
            for (std::size_t k = i; k < i + 4; ++k)
                most = std::max(most, std::abs(int{a.rgba[k]} - int{b.rgba[k]}));
            count += most > more_than;
        }
        return 4.0 * static_cast<double>(count) / static_cast<double>(a.rgba.size());
    }
    static double unlike(const TilePair& pair)
    {
        return unlike(Renderer().render(pair.tiles, tiles_px),
                      Renderer().render(pair.mesh, tiles_px));
    }
    static constexpr double few = 0.003;
    Renderer renderer;
};

TEST_F(TilesOnCard, HaveTheirVerticesWhereTheProcessorBendsThem)
{
    const Ref<TileModel> model = ring_model();
    const Mesh& unit = *model->mesh;
    for (const glm::dvec3 near : {glm::dvec3(0), glm::dvec3(1e5, -2e5, 3e4)}) {
        const Ref<PlacedTiles> tiles =
            make_ref(PlacedTiles(trivar::testing::random_tiles(30, near)));
        const Ref<TileSet> set = tile_set(model, tiles);
        TilePatches patches;
        patches.write(tiles, set->box);
        std::vector<std::uint32_t> numbers;
        for (std::uint32_t i = 0; i < tiles->size(); ++i) numbers.push_back(i);
        MirroredCopies rows = uploaded(numbers);
        rows.patches = std::shared_ptr<const TilePatches>(&patches, [](const TilePatches*) {});
        Mirror mirror;
        const MirroredMesh& mesh = mirror.mesh(model->mesh);
        rows.feed(mesh.vertices, 0, false);
        Programs programs;
        const Program& program =
            programs.use(vertex_program({"COPIES", "TILES"}, VertexOutputs::tangents));
        program.set("to_scene", glm::mat4(1));
        program.set("normal_to_scene", glm::mat3(1));
        glm::mat4 behind_the_eye(0);
        behind_the_eye[3].w = -1;
        program.set("scene_to_clip", behind_the_eye);
        patches.bind();
        mesh.vertices.bind();
        const Framebuffer nowhere({}, nullptr);
        nowhere.bind();
        const std::size_t count = unit.vertex_count() * tiles->size();
        std::array<Buffer, 3> out;
        for (unsigned k = 0; k < 3; ++k) {
            out[k].reserve(count * (k < 2 ? sizeof(glm::vec3) : sizeof(glm::vec4)));
            glBindBufferBase(GL_TRANSFORM_FEEDBACK_BUFFER, k, out[k].name());
        }
        glBeginTransformFeedback(GL_POINTS);
        glDrawArraysInstanced(GL_POINTS, 0, static_cast<int>(unit.vertex_count()),
                              static_cast<int>(tiles->size()));
        glEndTransformFeedback();
        for (unsigned k = 0; k < 3; ++k) glBindBufferBase(GL_TRANSFORM_FEEDBACK_BUFFER, k, 0);
        glBindFramebuffer(GL_FRAMEBUFFER, 0);
        std::vector<glm::vec3> positions(count), normals(count);
        std::vector<glm::vec4> tangents(count);
        out[0].read(std::as_writable_bytes(std::span(positions)));
        out[1].read(std::as_writable_bytes(std::span(normals)));
        out[2].read(std::as_writable_bytes(std::span(tangents)));
        const double size = glm::length(set->box.size());
        const Mesh bent = bent_tiles(unit, *tiles);
        for (std::size_t i = 0; i < count; ++i) {
            const std::size_t v = i % unit.vertex_count();
            const trivar::testing::BentPoint truth = trivar::testing::bent_point(
                (*tiles)[i / unit.vertex_count()], unit.positions[v], unit.normals[v]);
            EXPECT_LT(glm::distance(glm::dvec3(positions[i]) + patches.origin(), truth.p),
                      1e-6 * size);
            EXPECT_LT(glm::distance(glm::dvec3(normals[i]), truth.normal), 1e-4);
            EXPECT_LT(glm::distance(glm::vec3(tangents[i]), glm::vec3(bent.tangents[i])), 1e-4f);
            EXPECT_EQ(tangents[i].w, bent.tangents[i].w);
        }
    }
}

TEST_F(TilesOnCard, AreDrawnAsTheirMeshIs)
{
    Material gold;
    gold.base_color = {0.8f, 0.5f, 0.1f, 1};
    gold.metallic = 1;
    const glm::dmat4 turned = glm::rotate(moved(0.2, 0, 0.1), 0.3, {0, 0, 1});
    const Ref<TileSet> set = tile_set(ring_model(), make_ref(PlacedTiles(tiles_on_waves(6))));
    for (const double mirror : {1.0, -1.0}) {
        TilePair pair(set, glm::scale(turned, glm::dvec3(mirror, 1, 1)), gold);
        EXPECT_LT(unlike(pair), few);
        pair.each([](Picture& picture) { picture.draft = true; });
        EXPECT_LT(unlike(pair), few);
    }
    TilePair none;
    none.mesh.instances.erase(none.mesh.instances.begin());
    EXPECT_GT(unlike(none), 0.1);
}

TEST_F(TilesOnCard, ShowTexturesCutOutsGlassAndWoodAsTheirMeshDoes)
{
    Image checks;
    checks.size_px = {8, 8};
    for (int i = 0; i < 64; ++i) {
        const bool lit = (i / 8 + i) % 2 == 0;
        for (const int c : {lit ? 220 : 90, lit ? 140 : 160, 220, lit ? 255 : 40})
            checks.rgba.push_back(static_cast<std::uint8_t>(c));
    }
    const Ref<TileSet> set = tile_set(ring_model(), make_ref(PlacedTiles(tiles_on_waves(6))));
    for (const Material::Alpha alpha : {Material::Alpha::opaque, Material::Alpha::mask}) {
        Material material;
        material.base_color_texture.image = make_ref(checks);
        material.normal_texture.image = material.base_color_texture.image;
        material.alpha = alpha;
        EXPECT_LT(unlike(TilePair(set, glm::dmat4(1), material)), 2 * few);
    }
    Material wood;
    wood.filling = Filling::wood;
    EXPECT_LT(unlike(TilePair(set, glm::dmat4(1), wood)), 2 * few);
    TilePair glass(set);
    glass.each([](Picture& picture) { picture.instances.front().opacity = 0.4f; });
    EXPECT_LT(unlike(glass), 2 * few);
}

TEST_F(TilesOnCard, AreTintedAsTheVerticesOfTheirMeshAre)
{
    std::vector<PlacedTile> tiles = tiles_on_waves(6);
    for (std::size_t i = 0; i < tiles.size(); i += 2)
        tiles[i].tint = {1, 0.2f, 0.1f * static_cast<float>(i % 7)};
    for (std::size_t i = 0; i < tiles.size(); i += 3) tiles[i].tint_over = 1;
    Mesh colored = *ring_model()->mesh;
    for (const glm::vec3& p : colored.positions) colored.colors.emplace_back(p.x, p.y, 0.5f, 1);
    const Ref<TileSet> set = tile_set(tile_model(colored), make_ref(PlacedTiles(tiles)));
    ASSERT_FALSE((*set->mesh)->colors.empty());
    Material wood;
    wood.filling = Filling::wood;
    EXPECT_LT(unlike(TilePair(set)), few);
    EXPECT_LT(unlike(TilePair(tile_set(ring_model(), make_ref(PlacedTiles(tiles))))), few);
    EXPECT_LT(unlike(TilePair(set, glm::dmat4(1), wood)), 2 * few);
    TilePair pair(set);
    for (PlacedTile& tile : tiles) tile.tint = glm::vec3(1), tile.tint_over = 0;
    pair.tiles.instances.front().tiles = tile_set(set->model, make_ref(PlacedTiles(tiles)));
    EXPECT_GT(unlike(pair), 0.02);
}

TEST_F(TilesOnCard, ShowTheirEdgesAsTheirMeshDoes)
{
    TilePair pair;
    pair.each([](Picture& picture) {
        picture.settings.wire = true;
        picture.camera.eye = {0.5, -2, 1.6}; // how dark they are follows the size of what has them
    });
    EXPECT_LT(
        unlike(Renderer().render(pair.tiles, tiles_px), Renderer().render(pair.mesh, tiles_px), 40),
        0.02);
}

TEST_F(TilesOnCard, ArePickedAsTheirObject)
{
    for (const float opacity : {1.0f, 0.5f}) {
        TilePair pair;
        pair.each([&](Picture& picture) { picture.instances.front().opacity = opacity; });
        Renderer of_mesh;
        renderer.draw(pair.tiles, tiles_px);
        of_mesh.draw(pair.mesh, tiles_px);
        int unlike = 0, seen = 0;
        for (int y = 0; y < tiles_px.y; y += 3)
            for (int x = 0; x < tiles_px.x; x += 3) {
                const int id = renderer.pick({x, y});
                unlike += id != of_mesh.pick({x, y});
                seen += id == 7;
            }
        EXPECT_LE(unlike, 2);
        EXPECT_GT(seen, 200);
    }
}

TEST_F(TilesOnCard, AreAsFineFarFromTheOrigin)
{
    const glm::dvec3 away(1 << 20, 0, 0);
    TilePair here;
    here.each([](Picture& picture) { picture.instances.resize(1); });
    std::vector<PlacedTile> far = tiles_on_waves(6);
    for (PlacedTile& tile : far)
        for (glm::dvec3& p : tile.patch.p) p += away;
    TilePair there(tile_set(ring_model(), make_ref(PlacedTiles(far))));
    there.tiles.instances.resize(1);
    there.tiles.camera.eye += away;
    there.tiles.camera.target += away;
    EXPECT_LT(
        unlike(renderer.render(there.tiles, tiles_px), Renderer().render(here.tiles, tiles_px)),
        few);
}

TEST_F(TilesOnCard, CastTheirShadowsWhetherTheyAreSeenOrNot)
{
    TilePair pair;
    pair.each([](Picture& picture) { // at the ground beside them
        picture.camera.eye = {2.2, -2.5, 1.2};
        picture.camera.target = {2.4, -1.2, -0.5};
        picture.camera.fov_y = 0.5;
    });
    EXPECT_LT(unlike(pair), few);
    renderer.draw(pair.tiles, tiles_px);
    EXPECT_LT(renderer.tile_counts().drawn, renderer.tile_counts().tiles);
}

TEST_F(TilesOnCard, AreLeftOutWhereTheCameraDoesNotSeeThem)
{
    TilePair pair(tile_set(ring_model(), make_ref(PlacedTiles(tiles_on_waves(40, 0.2)))));
    renderer.draw(pair.tiles, tiles_px);
    EXPECT_EQ(renderer.tile_counts().tiles, 1600u);
    EXPECT_EQ(renderer.tile_counts().all_vertices, 1600 * ring_model()->mesh->vertex_count());
    const auto look_from = [&](const glm::dvec3& eye, const glm::dvec3& target) {
        pair.each([&](Picture& picture) {
            picture.camera.eye = eye;
            picture.camera.target = target;
        });
        EXPECT_LT(
            unlike(renderer.render(pair.tiles, tiles_px), Renderer().render(pair.mesh, tiles_px)),
            0.02); // the shadow map is fitted to what is seen
    };
    look_from({0.3, -0.8, 0.8}, {0.3, 0.2, 0});
    EXPECT_GT(renderer.tile_counts().drawn, 3u);
    EXPECT_LT(renderer.tile_counts().drawn, 400u);
    look_from({0, 0, 3}, {0, 3, 6}); // nothing of them
    EXPECT_EQ(renderer.tile_counts().drawn, 0u);
}

TEST_F(TilesOnCard, AreLeftOutOfDraftsWhereSomethingHidesThem)
{
    TilePair pair(tile_set(ring_model(), make_ref(PlacedTiles(tiles_on_waves(30, 0.2)))));
    pair.each([](Picture& picture) {
        picture.camera.eye = {0, -12, 0.6};
        picture.settings.ground = false; // that of drafts may lag
        picture.instances.back() =
            instance_of(box_mesh({9, 0.2, 4}, glm::ivec3(1)), moved(0, 0, 0));
        picture.draft = true;
    });
    const auto of_mesh = [&] { return Renderer().render(pair.mesh, tiles_px); };
    EXPECT_LT(unlike(renderer.render(pair.tiles, tiles_px), of_mesh()), few);
    EXPECT_GT(renderer.tile_counts().drawn, 400u);
    EXPECT_LT(renderer.tile_counts().drawn, 600u) << "the wall stands before half of the 900";
    const auto all_of_them = [&](const char* why) {
        EXPECT_LT(unlike(renderer.render(pair.tiles, tiles_px), of_mesh()), few) << why;
        EXPECT_EQ(renderer.tile_counts().drawn, 900u) << why;
    };
    pair.each([](Picture& picture) { picture.draft = false; });
    all_of_them("a picture that is no draft shows all there is");
    pair.each([](Picture& picture) {
        picture.draft = true;
        picture.instances.back().opacity = 0.5f;
    });
    all_of_them("what is seen through hides nothing");
    pair.each([](Picture& picture) { picture.instances.pop_back(); });
    all_of_them("nothing is before them");
}

TEST_F(TilesOnCard, AreSimplerInDraftsWhereTheyAreSmall)
{
    TilePair pair(tile_set(ring_model(true), make_ref(PlacedTiles(tiles_on_waves(20, 0.25)))));
    pair.each([](Picture& picture) { picture.camera.eye = {3, -15, 12}; });
    EXPECT_LT(unlike(pair), few) << "pictures that are no drafts show all there is";
    pair.each([](Picture& picture) { picture.draft = true; });
    const Image drawn = renderer.render(pair.tiles, tiles_px),
                truth = Renderer().render(pair.mesh, tiles_px);
    double sum = 0;
    for (std::size_t i = 0; i < drawn.rgba.size(); ++i)
        sum += std::abs(int{drawn.rgba[i]} - int{truth.rgba[i]});
    EXPECT_LT(sum / static_cast<double>(drawn.rgba.size()), 3) << "of 255, in the mean";
    const TileCounts& counts = renderer.tile_counts();
    EXPECT_EQ(counts.drawn, 400u);
    EXPECT_LT(5 * counts.vertices, counts.all_vertices);
    pair.tiles.camera.eye = {0.1, -0.4, 0.5};
    renderer.draw(pair.tiles, tiles_px);
    EXPECT_GT(renderer.tile_counts().vertices,
              renderer.tile_counts().drawn * ring_model()->mesh->vertex_count() / 8);
}

TEST_F(TilesOnCard, AreUploadedOnceAndThenOnlyWhereTheyDiffer)
{
    constexpr std::size_t tile_bytes = 416;
    std::vector<PlacedTile> tiles = tiles_on_waves(20);
    const Ref<TileModel> model = ring_model();
    TilePair pair(tile_set(model, make_ref(PlacedTiles(tiles))));
    Instance& one = pair.tiles.instances.front();
    trivar::testing::BufferTraffic traffic;
    renderer.draw(pair.tiles, tiles_px);
    EXPECT_EQ(std::ranges::count(traffic.written, 400 * tile_bytes), 1);
    traffic.forget();
    pair.tiles.camera.eye.x += 0.1;
    renderer.draw(pair.tiles, tiles_px);
    EXPECT_LT(traffic.bytes_written(), 40 * tile_bytes);
    for (const std::size_t i : {17u, 18u, 200u})
        for (glm::dvec3& p : tiles[i].patch.p) p.z += 0.01;
    tiles.push_back(tiles.back());
    one.tiles = tile_set(model, make_ref(PlacedTiles(tiles)));
    traffic.forget();
    renderer.draw(pair.tiles, tiles_px);
    EXPECT_EQ(std::ranges::count(traffic.written, 2 * tile_bytes), 1);
    EXPECT_EQ(std::ranges::count(traffic.written, tile_bytes), 2) << "one changed and one new";
    EXPECT_GE(std::ranges::count(traffic.written, sizeof(std::uint32_t)), 1)
        << "one more number of a tile, not the numbers of all";
    EXPECT_LT(
        unlike(renderer.render(pair.tiles, tiles_px), Renderer().render(pair.tiles, tiles_px)),
        few);
}

TEST_F(TilesOnCard, AreOneCallAPassHoweverManyThereAre)
{
    std::vector<int> calls;
    for (const int across : {3, 15}) {
        TilePair pair(tile_set(ring_model(), make_ref(PlacedTiles(tiles_on_waves(across)))));
        pair.tiles.instances.resize(1);
        Renderer anew;
        const trivar::testing::DrawCalls drawn;
        anew.draw(pair.tiles, tiles_px);
        calls.push_back(drawn.count);
    }
    EXPECT_EQ(calls[0], calls[1]);
    EXPECT_LE(calls[0], 5);
}

TEST_F(TilesOnCard, HaveOneOutlineRoundThemAll)
{
    TilePair pair;
    pair.each([](Picture& picture) {
        picture.instances.resize(1);
        picture.instances.front().highlighted = true;
        picture.outline.color = {1, 0, 0, 1};
        picture.camera.eye = {0, -1, 8};
    });
    const auto red = [](const Image& image) {
        int count = 0;
        for (std::size_t i = 0; i < image.rgba.size(); i += 4)
            count += image.rgba[i] > 150 && image.rgba[i + 1] < 60 && image.rgba[i + 2] < 60;
        return count;
    };
    const int round_all = red(renderer.render(pair.tiles, tiles_px)),
              round_each = red(Renderer().render(pair.mesh, tiles_px));
    EXPECT_GT(round_all, 300);
    EXPECT_LT(2 * round_all, round_each);
}

} // namespace
} // namespace trivar::gpu::testing
