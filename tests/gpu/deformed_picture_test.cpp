// SPDX-License-Identifier: GPL-3.0-or-later
// Pictures of meshes that the renderer deforms, beside those of meshes that were deformed before.
#include "gpu/ffd/way_times.h"
#include "tests/gpu/support.h"
#include "tests/support/splines.h"

#include <gmock/gmock.h>

namespace trivar::gpu::testing {
namespace {

constexpr glm::ivec2 picture_px{160, 120};

Stage volume_stage(int order, double size, const Embedding& embedding = {}, unsigned seed = 1)
{
    const Knots knots = Knots::uniform(order, order + 2);
    return {make_ref(Lattice{trivar::testing::random_volume({knots, knots, knots}, seed, size),
                             glm::dmat4(1)}),
            embedding};
}

// Maps the box [-1, 1]^3 to the parameters.
Embedding in_a_box()
{
    glm::dmat4 half(0.5);
    half[3] = {0.5, 0.5, 0.5, 1};
    return {half, glm::dmat4(1)};
}

Picture picture_with(const Ref<Mesh>& mesh, const std::vector<Stage>& stages, DeformBy by)
{
    Picture picture;
    picture.camera.eye = {2, -4, 3};
    picture.samples = 1;
    picture.deform_by = by;
    Instance instance;
    instance.mesh = mesh;
    instance.stages = stages;
    instance.id = 7;
    picture.instances.push_back(instance);
    picture.instances.push_back(instance_of(plane_mesh({6, 6}, {1, 1}), moved(0, 0, -1.5)));
    return picture;
}

// The same, deformed beforehand.
Picture expected_of(const Ref<Mesh>& mesh, const std::vector<Stage>& stages)
{
    Mesh out = *mesh;
    for (const Stage& stage : stages) out = deform(out, stage.embedding, *stage.lattice);
    return picture_with(make_ref(std::move(out)), {}, DeformBy::processor);
}

// How many pixels differ by more than a little.
int different_pixels(const Image& a, const Image& b)
{
    int count = 0;
    for (std::size_t i = 0; i < a.rgba.size(); i += 4)
        for (std::size_t c = 0; c < 3; ++c)
            if (std::abs(int{a.rgba[i + c]} - int{b.rgba[i + c]}) > 3) {
                ++count;
                break;
            }
    return count;
}

constexpr std::array every_way{DeformBy::processor, DeformBy::one_phase, DeformBy::two_phases};

class DeformedPictures : public WithContext {
protected:
    // How many the picture deforms that is drawn now.
    std::size_t deformed_vertices(const Picture& picture)
    {
        renderer.draw(picture, picture_px);
        for (const Timings::Stage& stage : renderer.timings().stages)
            if (stage.name == "deform on device") return stage.vertices;
        return 0;
    }
    Renderer renderer;
    const Ref<Mesh> torus = make_ref(torus_mesh(0.6, 0.25, {48, 24}));
};

TEST_F(DeformedPictures, AreTheSameWhereverTheyAreDeformed)
{
    const std::vector<Stage> stages{volume_stage(3, 0.2, in_a_box())};
    const Image expected = renderer.render(expected_of(torus, stages), picture_px);
    const Image still = renderer.render(picture_with(torus, {}, DeformBy::processor), picture_px);
    EXPECT_GT(different_pixels(still, expected), 500);
    for (const DeformBy by : every_way) {
        const Image got = renderer.render(picture_with(torus, stages, by), picture_px);
        EXPECT_LE(different_pixels(got, expected), 8);
        EXPECT_EQ(renderer.notice(), "");
        EXPECT_EQ(renderer.pick({80, 45}), 7);
    }
}

// The lerps of the shader lose a few digits, the steps of normals some more.
TEST_F(DeformedPictures, AreNearlyTheSameByTheFormulasOfTheThesis)
{
    const std::vector<Stage> stages{volume_stage(3, 0.2, in_a_box())};
    const Image expected = renderer.render(expected_of(torus, stages), picture_px);
    for (const DeformBy by : {DeformBy::differences, DeformBy::raised, DeformBy::filtered}) {
        const Image got = renderer.render(picture_with(torus, stages, by), picture_px);
        EXPECT_LE(different_pixels(got, expected), 200) << static_cast<int>(by);
        EXPECT_EQ(renderer.notice(), "");
    }
}

TEST_F(DeformedPictures, ComposeStacksAndShowTheirEdges)
{
    const std::vector<Stage> stages{volume_stage(3, 0.2, in_a_box()),
                                    volume_stage(4, 0.15, in_a_box(), 2)};
    for (const bool wire : {false, true}) {
        Picture expected = expected_of(torus, stages);
        expected.settings.wire = wire;
        const Image image = renderer.render(expected, picture_px);
        for (const DeformBy by : every_way) {
            Picture picture = picture_with(torus, stages, by);
            picture.settings.wire = wire;
            EXPECT_LE(different_pixels(renderer.render(picture, picture_px), image), 12);
        }
    }
}

TEST_F(DeformedPictures, AreDeformedAnewOnlyWhenSomethingChanged)
{
    Picture picture = picture_with(torus, {volume_stage(3, 0.2, in_a_box())}, DeformBy::two_phases);
    EXPECT_EQ(deformed_vertices(picture), torus->vertex_count());
    picture.camera.eye = {-2, -4, 3};
    EXPECT_EQ(deformed_vertices(picture), 0u);
    picture.instances.front().stages.front().embedding.to_uvw[3].x += 0.1;
    EXPECT_EQ(deformed_vertices(picture), torus->vertex_count());
}

TEST_F(DeformedPictures, AreNotDeformedAnewBecauseAnotherIsHiddenOrStandsElsewhere)
{
    for (const DeformBy by : every_way) {
        Picture picture = picture_with(torus, {volume_stage(3, 0.2, in_a_box())}, by);
        for (int slot = 1; slot < 4; ++slot) {
            picture.instances.push_back(picture.instances.front());
            picture.instances.back().part.mesh = slot;
        }
        EXPECT_EQ(deformed_vertices(picture), 4 * torus->vertex_count());
        picture.instances.erase(picture.instances.begin());
        std::ranges::reverse(picture.instances);
        EXPECT_EQ(deformed_vertices(picture), 0u);
        picture.instances.erase(picture.instances.begin() + 1);
        EXPECT_EQ(deformed_vertices(picture), 0u);
    }
}

TEST_F(DeformedPictures, ShowEachOfTwoThatHaveTheSameKey)
{
    Picture picture = picture_with(torus, {volume_stage(3, 0.2, in_a_box())}, DeformBy::processor);
    Picture alone = picture;
    picture.instances.push_back(picture.instances.front());
    picture.instances.back().to_world = moved(0, 0, 1);
    picture.instances.back().stages = {volume_stage(3, 0.2, in_a_box(), 2)};
    alone.instances.push_back(picture.instances.back());
    alone.instances.back().part.mesh = 1;
    EXPECT_EQ(renderer.render(picture, picture_px).rgba, Renderer().render(alone, picture_px).rgba);
}

TEST_F(DeformedPictures, FallToTheProcessorWhereTheDeviceCannotAndSayWhy)
{
    const std::vector<Stage> stages{volume_stage(5, 0.2, in_a_box())};
    const Image expected = renderer.render(expected_of(torus, stages), picture_px);
    const Picture picture = picture_with(torus, stages, DeformBy::two_phases);
    for (int i = 0; i < 2; ++i) {
        EXPECT_LE(different_pixels(renderer.render(picture, picture_px), expected), 8);
        EXPECT_THAT(renderer.notice(), ::testing::HasSubstr("order 5"));
    }
}

TEST_F(DeformedPictures, TellWhatEveryWayTakes)
{
    for (const int order : {3, 5}) {
        const Picture picture =
            picture_with(torus, {volume_stage(order, 0.2, in_a_box())}, DeformBy::two_phases);
        WayTimer time;
        for (std::size_t i = 0; i < deform_names.size(); ++i) {
            const auto by = static_cast<DeformBy>(i);
            const WayTime way = time(picture, by);
            EXPECT_EQ(way.by, by);
            if (order == 5 && by != DeformBy::processor) {
                EXPECT_THAT(way.why_not, ::testing::HasSubstr("order 5"));
                continue;
            }
            EXPECT_EQ(way.why_not, "");
            EXPECT_EQ(way.vertices, torus->vertex_count());
            EXPECT_GT(way.time_ms, 0);
            ASSERT_EQ(way.off.has_value(), by != DeformBy::processor) << deform_names[i];
            if (!way.off) continue;
            const bool ours = by == DeformBy::one_phase || by == DeformBy::two_phases;
            EXPECT_LT(way.off->position, ours ? 1e-6 : 1e-5) << deform_names[i];
            EXPECT_LT(way.off->normal_deg, ours ? 0.05 : 3) << deform_names[i];
        }
    }
}

} // namespace
} // namespace trivar::gpu::testing
