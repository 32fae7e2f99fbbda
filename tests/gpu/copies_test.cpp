// SPDX-License-Identifier: GPL-3.0-or-later
// Copies of a mesh, drawn by one call, beside instances of it, drawn one by one.
#include "tests/gpu/support.h"
#include "tests/support/buffer_traffic.h"
#include "tests/support/draw_calls.h"
#include "tests/support/splines.h"

#include <functional>
#include <limits>
#include <set>

namespace trivar::gpu::testing {
namespace {

constexpr glm::ivec2 copies_px{160, 120};

// Two rows of turned and scaled copies; every third mirrors.
std::vector<Copy> some_copies()
{
    std::vector<Copy> out;
    for (int i = 0; i < 10; ++i) {
        Copy copy;
        const double size = 0.3 + 0.02 * i;
        copy.to_instance = glm::rotate(moved(i % 5 - 2, i / 5, 0.3), 0.7 * i, {0.2, 0.3, 1});
        copy.to_instance =
            glm::scale(copy.to_instance, glm::dvec3(i % 3 == 0 ? -size : size, size, 1.3 * size));
        copy.id = 100 + i;
        out.push_back(copy);
    }
    return out;
}

// A picture of copies, and what it must look like.
struct Pair {
    Picture copies, instances;
    explicit Pair(const Instance& one, const std::vector<Copy>& copies_of_it = some_copies())
    {
        copies.camera.eye = {1, -6, 4};
        copies.samples = 1;
        instances = copies;
        copies.instances = {one};
        copies.instances.front().copies = make_ref(copies_of_it);
        for (const Copy& copy : copies_of_it) {
            instances.instances.push_back(one);
            Instance& each = instances.instances.back();
            each.to_world = one.to_world * copy.to_instance;
            each.id = copy.id ? copy.id : one.id;
            each.part.piece = static_cast<int>(instances.instances.size());
        }
        // The shadow map is fitted to the boxes of what is drawn, which of copies are one: here to
        // that of a room around them.
        each([](Picture& picture) {
            picture.instances.push_back(
                instance_of(box_mesh({9, 9, 0.2}, glm::ivec3(1)), moved(0, 0, -0.6)));
            picture.instances.push_back(
                instance_of(box_mesh({9, 0.2, 4}, glm::ivec3(1)), moved(0, 4, 1)));
        });
    }
    void each(const std::function<void(Picture&)>& change)
    {
        change(copies);
        change(instances);
    }
};

class Copies : public WithContext {
protected:
    // The most that a channel of both pictures differs by, of 255.
    static int difference(const Pair& pair)
    {
        const Image a = Renderer().render(pair.copies, copies_px);
        const Image b = Renderer().render(pair.instances, copies_px);
        int most = 0;
        for (std::size_t i = 0; i < a.rgba.size(); ++i)
            most = std::max(most, std::abs(int{a.rgba[i]} - int{b.rgba[i]}));
        return most;
    }
    static Image without(Picture picture)
    {
        picture.instances.clear();
        return Renderer().render(picture, copies_px);
    }
    const Instance torus = instance_of(torus_mesh(0.8, 0.35, {24, 12}));
    Renderer renderer;
};

TEST_F(Copies, AreDrawnAsSoManyInstancesAre)
{
    Material gold;
    gold.base_color = {0.8f, 0.5f, 0.1f, 1};
    gold.metallic = 1;
    const glm::dmat4 turned = glm::rotate(moved(0.2, 0, 0.1), 0.3, {0, 0, 1});
    Instance one = instance_of(torus_mesh(0.8, 0.35, {24, 12}), turned, gold);
    for (const double mirror : {1.0, -1.0}) {
        one.to_world = glm::scale(turned, glm::dvec3(mirror, 1, 1));
        Pair pair(one);
        EXPECT_EQ(difference(pair), 0);
        pair.each([](Picture& picture) { picture.draft = true; });
        EXPECT_EQ(difference(pair), 0);
        EXPECT_NE(renderer.render(pair.copies, copies_px).rgba, without(pair.copies).rgba);
    }
}

TEST_F(Copies, ShowTexturesNormalMapsAndCutOutsAsInstancesDo)
{
    Image checks;
    checks.size_px = {8, 8};
    for (int i = 0; i < 64; ++i) {
        const bool lit = (i / 8 + i) % 2 == 0;
        for (const int c : {lit ? 220 : 90, lit ? 140 : 160, 220, lit ? 255 : 40})
            checks.rgba.push_back(static_cast<std::uint8_t>(c));
    }
    Material material;
    material.base_color_texture.image = make_ref(checks);
    material.normal_texture.image = material.base_color_texture.image;
    for (const Material::Alpha alpha : {Material::Alpha::opaque, Material::Alpha::mask}) {
        material.alpha = alpha;
        Instance one = instance_of(torus_mesh(0.8, 0.35, {24, 12}), glm::dmat4(1), material);
        EXPECT_EQ(difference(Pair(one)), 0);
    }
}

TEST_F(Copies, AreSeenThroughAsInstancesAre)
{
    Instance glass = torus;
    glass.opacity = 0.4f;
    Pair pair(glass);
    EXPECT_LE(difference(pair), 1);
    pair.each([](Picture& picture) { picture.draft = true; });
    EXPECT_LE(difference(pair), 1);
}

TEST_F(Copies, ShowTheirEdgesAsInstancesDo)
{
    Pair pair(torus);
    pair.each([](Picture& picture) { picture.settings.wire = true; });
    EXPECT_LE(difference(pair), 2) << "how dark edges are follows the size of a copy";
}

TEST_F(Copies, AreDeformedOnceAsInstancesAre)
{
    const Knots knots = Knots::uniform(3, 5);
    glm::dmat4 half(0.5);
    half[3] = {0.5, 0.5, 0.5, 1};
    Instance one = torus;
    one.stages = {{make_ref(Lattice{trivar::testing::random_volume({knots, knots, knots}, 1, 0.2),
                                    glm::dmat4(1)}),
                   {half, glm::dmat4(1)}}};
    for (const DeformBy by : {DeformBy::processor, DeformBy::one_phase, DeformBy::two_phases}) {
        Pair pair(one);
        pair.each([by](Picture& picture) { picture.deform_by = by; });
        EXPECT_EQ(difference(pair), 0) << static_cast<int>(by);
        Renderer anew;
        anew.draw(pair.copies, copies_px);
        std::size_t vertices = 0;
        for (const Timings::Stage& stage : anew.timings().stages)
            if (stage.name == "deform on device") vertices += stage.vertices;
        EXPECT_EQ(vertices, torus.mesh->vertex_count());
    }
}

TEST_F(Copies, ArePickedOneByOneWhetherSolidOrSeenThrough)
{
    for (const float opacity : {1.0f, 0.5f}) {
        Instance one = torus;
        one.opacity = opacity;
        Pair pair(one);
        Renderer of_instances;
        renderer.draw(pair.copies, copies_px);
        of_instances.draw(pair.instances, copies_px);
        std::set<int> seen;
        int unlike = 0;
        for (int y = 0; y < copies_px.y; ++y)
            for (int x = 0; x < copies_px.x; ++x) {
                const int id = renderer.pick({x, y});
                unlike += id != of_instances.pick({x, y});
                seen.insert(id);
            }
        EXPECT_EQ(unlike, 0);
        EXPECT_EQ(seen.size(), 11u) << "each of them and nothing";
    }
}

TEST_F(Copies, WithoutAnIdAreTheirInstanceToThePicker)
{
    Instance one = torus;
    one.id = 7;
    Pair pair(one, {Copy{.to_instance = moved(-1, 0, 0)}, Copy{moved(1, 0, 0), 8}});
    renderer.draw(pair.copies, copies_px);
    EXPECT_EQ(renderer.pick_in({0, 0}, copies_px), (std::vector<int>{7, 8}));
}

TEST_F(Copies, ThrowTheirShadowsWhereTheyStand)
{
    Pair pair(torus);
    EXPECT_EQ(difference(pair), 0);
    const Image lit = renderer.render(pair.copies, copies_px);
    std::vector<Copy> others = some_copies(); // the same renderer, so maps must be drawn anew
    for (Copy& copy : others) copy.to_instance[3].y -= 0.5;
    pair.copies.instances.front().copies = make_ref(others);
    EXPECT_EQ(renderer.render(pair.copies, copies_px).rgba,
              Renderer().render(pair.copies, copies_px).rgba);
    EXPECT_NE(renderer.image().rgba, lit.rgba);
}

TEST_F(Copies, HaveOutlinesAllOrSomeOfThem)
{
    Pair pair(torus);
    pair.each([](Picture& picture) {
        for (Instance& each : picture.instances) each.highlighted = each.mesh->vertex_count() > 100;
    });
    EXPECT_EQ(difference(pair), 0);
    pair.copies.instances.front().highlighted = false;
    pair.copies.instances.front().outlined_copies = {3, 7, 8, 999};
    for (std::size_t i = 0; i < some_copies().size(); ++i)
        pair.instances.instances[i].highlighted = i == 3 || i == 7 || i == 8;
    EXPECT_EQ(difference(pair), 0);
    Pair plain(torus);
    EXPECT_NE(renderer.render(pair.copies, copies_px).rgba,
              Renderer().render(plain.copies, copies_px).rgba);
}

TEST_F(Copies, ShowAValueEach)
{
    std::vector<Copy> valued = some_copies();
    for (std::size_t i = 0; i < valued.size(); ++i) valued[i].value = static_cast<float>(i) / 9;
    Pair pair(torus, valued);
    pair.each([](Picture& picture) {
        picture.value_colors = ValueColors{.diverging = false, .ratios = false, .range = {0, 1}};
    });
    for (std::size_t i = 0; i < valued.size(); ++i)
        pair.instances.instances[i].values =
            make_ref(std::vector<float>(torus.mesh->vertex_count(), valued[i].value));
    EXPECT_EQ(difference(pair), 0);
    valued[4].value = std::numeric_limits<float>::quiet_NaN();
    const Image shown = renderer.render(pair.copies, copies_px);
    pair.copies.instances.front().copies = make_ref(valued);
    EXPECT_NE(renderer.render(pair.copies, copies_px).rgba, shown.rgba) << "all are grey";
}

TEST_F(Copies, ThatAreNowhereAreLeftOut)
{
    std::vector<Copy> with = some_copies();
    const double nan = std::numeric_limits<double>::quiet_NaN();
    with.insert(with.begin() + 2, Copy{glm::dmat4(nan), 999});
    const Pair pair(torus), odd(torus, with);
    EXPECT_EQ(renderer.render(odd.copies, copies_px).rgba,
              Renderer().render(pair.copies, copies_px).rgba);
    Picture none = pair.copies;
    none.instances.resize(1);
    none.instances.front().copies = make_ref(std::vector<Copy>());
    EXPECT_EQ(renderer.render(none, copies_px).rgba, without(none).rgba);
}

TEST_F(Copies, AreAsFineFarFromTheOrigin)
{
    Pair pair(torus);
    pair.copies.instances.resize(1);
    const Image here = renderer.render(pair.copies, copies_px);
    const glm::dvec3 away(0, 0, 1 << 20); // exact in both
    pair.copies.camera.eye += away;
    pair.copies.camera.target += away;
    std::vector<Copy> moved_away = some_copies();
    for (Copy& copy : moved_away) copy.to_instance[3] += glm::dvec4(away, 0);
    pair.copies.instances.front().copies = make_ref(moved_away);
    EXPECT_EQ(renderer.render(pair.copies, copies_px).rgba, here.rgba);
}

TEST_F(Copies, AreUploadedAnewOnlyWhereTheyStandElsewhere)
{
    Pair pair(torus);
    Instance& one = pair.copies.instances.front();
    const std::size_t row_bytes = 4 * (3 * 4 + 3 * 3 + 2);
    const auto uploads = [&] {
        const trivar::testing::BufferTraffic traffic;
        renderer.draw(pair.copies, copies_px);
        return std::ranges::count(traffic.written, some_copies().size() * row_bytes);
    };
    EXPECT_EQ(uploads(), 1);
    pair.copies.camera.eye.x += 1;
    EXPECT_EQ(uploads(), 0);
    one.to_world = moved(0.1, 0, 0);
    EXPECT_EQ(uploads(), 1);
    Instance beside = one; // two that share their copies keep both
    beside.to_world = moved(0.2, 0, 0);
    pair.copies.instances.push_back(beside);
    EXPECT_EQ(uploads(), 1);
    EXPECT_EQ(uploads(), 0);
}

TEST_F(Copies, AreOneCallAPassHoweverManyThereAre)
{
    std::vector<int> calls;
    for (const int across : {3, 30}) {
        std::vector<Copy> many;
        for (int i = 0; i < across * across; ++i)
            many.push_back({glm::scale(moved(i % across, i / across, 0), glm::dvec3(0.3)), i + 1});
        Pair pair(torus, many);
        pair.copies.instances.resize(1);
        Renderer anew;
        const trivar::testing::DrawCalls drawn;
        anew.draw(pair.copies, copies_px);
        calls.push_back(drawn.count);
    }
    EXPECT_EQ(calls[0], calls[1]);
    EXPECT_LE(calls[0], 5) << "fronts, backs, shadow and both of the contact map";
}

} // namespace
} // namespace trivar::gpu::testing
