// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/parallel.h"
#include "tests/casting/cast_ray.h"
#include "tests/casting/volumes.h"
#include "tests/gpu/support.h"

#include <algorithm>
#include <cmath>

namespace trivar::gpu::testing {
namespace {

using trivar::testing::red_and_blue;

constexpr glm::ivec2 cast_px{96, 72};
constexpr glm::ivec3 cast_size{25, 21, 23};
constexpr glm::dvec3 cast_middle(12, 10, 11);

Casting shells_of(FieldOrder order, bool bytes)
{
    const auto value = [](const glm::dvec3& p) { return trivar::testing::shells(p, cast_middle); };
    const Ref<VoxelGrid> grid = bytes ? trivar::testing::bytes_of(cast_size, value)
                                      : trivar::testing::grid_of(cast_size, value);
    return casting_of(trivar::testing::field_of(grid, order), red_and_blue(), 0, 200);
}

// Khronos PBR Neutral at an exposure of 1, as tonemap.glsl has it.
glm::vec3 tone_mapped_here(glm::vec3 c)
{
    const float least = std::min({c.r, c.g, c.b});
    c -= least < 0.08f ? least - least * least / 0.16f : 0.04f;
    const float peak = std::max({c.r, c.g, c.b});
    if (peak <= 0.76f) return c;
    const float pressed = 1 - 0.24f * 0.24f / (peak + 1 - 1.52f);
    return glm::mix(glm::vec3(pressed), c * (pressed / peak), 1 / (0.15f * (peak - pressed) + 1));
}

int as_byte(float linear)
{
    const float s =
        linear <= 0.0031308f ? 12.92f * linear : 1.055f * std::pow(linear, 1 / 2.4f) - 0.055f;
    return static_cast<int>(s * 255 + 0.5f);
}

// On black, voxels of a tenth of a unit, oblique.
class VolumesCast : public WithContext {
protected:
    VolumesCast()
    {
        picture.camera.eye = {3.1, -4.2, 2.3};
        picture.camera.target = {0, 0, 0};
        picture.camera.fov_y = 0.5;
        picture.camera.height_world = 2.9;
        picture.camera.size_px = cast_px;
        picture.settings.ground = false;
        picture.backdrop = Backdrop{};
        picture.samples = 1;
        show(shells_of(FieldOrder::cubic, false));
    }
    void show(Casting casting)
    {
        const glm::dmat4 turned = glm::rotate(glm::dmat4(1), 0.7, glm::dvec3(0.3, 0.5, 1));
        const glm::vec3 end(cast_size - 1);
        picture.volumes = {
            {.data = make_ref(std::move(casting)),
             .to_world = glm::translate(glm::scale(turned, glm::dvec3(0.08)), -cast_middle),
             .high = end,
             .shading = 0,
             .id = 7}};
    }
    Image drawn() { return renderer.render(picture, cast_px); }
    // The ray through the middle of a pixel on the processor, with its tone and encoding.
    glm::ivec3 cast_here(glm::ivec2 p_px, FieldOrder order) const
    {
        const CastVolume& volume = picture.volumes.front();
        const ::trivar::Ray ray = ray_through(picture.camera, glm::dvec2(p_px) + 0.5);
        const glm::dmat4 to_voxels = glm::inverse(volume.to_world);
        const glm::dvec3 from(to_voxels * glm::dvec4(ray.origin, 1)),
            along = glm::dmat3(to_voxels) * glm::normalize(ray.direction);
        const glm::dvec3 a = (glm::dvec3(volume.low) - from) / along,
                         b = (glm::dvec3(volume.high) - from) / along;
        const glm::dvec3 near = glm::min(a, b), far = glm::max(a, b);
        const double begin = std::max({near.x, near.y, near.z}),
                     end = std::min({far.x, far.y, far.z}), pace = 0.5 / glm::length(along);
        if (begin >= end) return glm::ivec3(0);
        const CastLight light = cast_ray(*volume.data,
                                         {.from = from + begin * along,
                                          .along = along,
                                          .end = static_cast<float>(end - begin),
                                          .pace = static_cast<float>(pace),
                                          .thickness = static_cast<float>(glm::length(along))},
                                         order);
        if (light.opacity <= 0) return glm::ivec3(0);
        const glm::vec3 color = tone_mapped_here(light.color / light.opacity) * light.opacity;
        return {as_byte(color.r), as_byte(color.g), as_byte(color.b)};
    }
    // The greatest and the mean difference of the picture from rays on the processor, in steps of
    // 8 bits.
    glm::dvec2 off(const Image& image, FieldOrder order) const
    {
        int most = 0;
        double sum = 0;
        for (int y = 0; y < cast_px.y; ++y)
            for (int x = 0; x < cast_px.x; ++x) {
                const glm::ivec3 d = glm::abs(rgb_at(image, {x, y}) - cast_here({x, y}, order));
                most = std::max({most, d.r, d.g, d.b});
                sum += (d.r + d.g + d.b) / 3.0;
            }
        return {most, sum / (cast_px.x * cast_px.y)};
    }
    Picture picture;
    Renderer renderer;
};

TEST_F(VolumesCast, AreWhatSingleRaysGatherInBothProjections)
{
    for (const bool on_card : {true, false})
        for (const bool perspective : {true, false})
            for (const FieldOrder order :
                 {FieldOrder::linear, FieldOrder::quadratic, FieldOrder::cubic})
                for (const bool bytes : {true, false}) {
                    renderer.cast_on_card(on_card);
                    picture.camera.perspective = perspective;
                    show(shells_of(order, bytes));
                    const glm::dvec2 difference = off(drawn(), order);
                    // Rays begin with another step; at the rim a pixel may be inside or outside.
                    EXPECT_LE(difference.x, 12) << on_card << perspective << int(order);
                    EXPECT_LE(difference.y, 0.6) << on_card << perspective << int(order);
                }
}

TEST_F(VolumesCast, AreTheSameOnTheCardAsOnTheProcessorWithLightToo)
{
    picture.volumes[0].shading = 1;
    picture.volumes[0].density = 3;
    for (const bool draft : {true, false}) {
        picture.draft = draft;
        renderer.cast_on_card(true);
        const Image on_card = drawn();
        renderer.cast_on_card(false);
        const Image on_processor = drawn();
        int most = 0;
        double sum = 0;
        for (std::size_t i = 0; i < on_card.rgba.size(); ++i) {
            const int d = std::abs(on_card.rgba[i] - on_processor.rgba[i]);
            most = std::max(most, d);
            sum += d;
        }
        EXPECT_LE(most, 16) << draft;
        EXPECT_LE(sum / static_cast<double>(on_card.rgba.size()), 0.2) << draft;
    }
}

TEST_F(VolumesCast, AreTheSamePictureEachTimeForAnyNumberOfThreads)
{
    for (const bool on_card : {true, false})
        for (const bool draft : {true, false}) {
            renderer.cast_on_card(on_card);
            picture.draft = draft;
            const Image first = drawn();
            const ThreadLimit one(1);
            Renderer other;
            other.cast_on_card(on_card);
            EXPECT_EQ(other.render(picture, cast_px).rgba, first.rgba);
        }
}

TEST_F(VolumesCast, LookNearlyTheSameInDrafts)
{
    const Image full = drawn();
    picture.draft = true;
    const Image draft = drawn();
    double sum = 0;
    for (std::size_t i = 0; i < full.rgba.size(); ++i)
        sum += std::abs(full.rgba[i] - draft.rgba[i]);
    EXPECT_LT(sum / static_cast<double>(full.rgba.size()), 4);
    EXPECT_NE(full.rgba, draft.rgba);
}

TEST_F(VolumesCast, StopAtSurfacesAndHideWhatIsBehindThem)
{
    const Image alone = drawn();
    const glm::ivec2 middle = cast_px / 2;
    Material white;
    white.base_color = {0.9f, 0.9f, 0.9f, 1};
    const auto wall_at = [&](double away) {
        const glm::dvec3 at = glm::normalize(picture.camera.eye) * away;
        picture.instances = {instance_of(sphere_mesh(0.3, 24, 12), moved(at.x, at.y, at.z), white)};
        return rgb_at(drawn(), middle);
    };
    for (const int way : {0, 1, 2, 3}) {
        renderer.cast_on_card(way < 2);
        picture.camera.perspective = way % 2 == 0;
        const glm::ivec3 before = wall_at(1.6), within = wall_at(0.3), behind = wall_at(-2);
        EXPECT_GT(before.g, 120) << "nothing veils it";
        EXPECT_GT(within.g + 10, behind.g);
        EXPECT_LT(within.g, before.g);
        EXPECT_LT(behind.g, before.g / 2);
    }
}

TEST_F(VolumesCast, AreCutOffByTheirBox)
{
    picture.volumes[0].high.x = 0.5f * static_cast<float>(cast_size.x - 1);
    const glm::dvec2 difference = off(drawn(), FieldOrder::cubic);
    EXPECT_LE(difference.x, 12);
    EXPECT_LE(difference.y, 0.6);
}

TEST_F(VolumesCast, ArePickedWhereTheyHideMoreThanHalf)
{
    picture.volumes[0].density = 20;
    drawn();
    EXPECT_EQ(renderer.pick(cast_px / 2), 7);
    EXPECT_EQ(renderer.pick({1, 1}), 0);
    picture.volumes[0].density = 0.01f;
    drawn();
    EXPECT_EQ(renderer.pick(cast_px / 2), 0);
}

TEST_F(VolumesCast, AreAsDenseAtAnyScale)
{
    const Image one = drawn();
    picture.volumes[0].to_world =
        glm::scale(glm::dmat4(1), glm::dvec3(50)) * picture.volumes[0].to_world;
    picture.camera.eye *= 50;
    int most = 0;
    const Image large = drawn();
    for (std::size_t i = 0; i < one.rgba.size(); ++i)
        most = std::max(most, std::abs(one.rgba[i] - large.rgba[i]));
    EXPECT_LE(most, 3);
}

TEST_F(VolumesCast, AreLitWhereTheirValuesChange)
{
    Casting ball = casting_of(
        trivar::testing::field_of(trivar::testing::grid_of(
            cast_size,
            [](const glm::dvec3& p) { return 200 - 12 * glm::distance(p, cast_middle); })),
        std::vector<TransferPoint>{{100, {0.8f, 0.8f, 0.8f}, 0}, {110, {0.8f, 0.8f, 0.8f}, 0.9}}, 0,
        200);
    show(std::move(ball));
    const auto spread = [&] {
        const Image image = drawn();
        int least = 255, most = 0;
        for (int x = cast_px.x / 2 - 10; x <= cast_px.x / 2 + 10; x += 2)
            for (int y = cast_px.y / 2 - 10; y <= cast_px.y / 2 + 10; y += 2) {
                least = std::min(least, rgb_at(image, {x, y}).g);
                most = std::max(most, rgb_at(image, {x, y}).g);
            }
        return most - least;
    };
    EXPECT_LT(spread(), 6);
    picture.volumes[0].shading = 1;
    EXPECT_GT(spread(), 30);
}

TEST_F(VolumesCast, TakeNoMoreMemoryThanTheirSamplesAndCoefficients)
{
    renderer.cast_on_card(true);
    picture.draft = true;
    drawn();
    const std::size_t voxels = 25 * 21 * 23, bricks = 2 * 6 * 5 * 6, table = 1025 * 16;
    EXPECT_EQ(renderer.uploaded_bytes(), 2 * voxels + bricks + table);
    picture.draft = false;
    drawn();
    EXPECT_EQ(renderer.uploaded_bytes(), 2 * voxels + 2 * (27 * 23 * 25) + bricks + table);
    picture.volumes.clear();
    drawn();
    EXPECT_EQ(renderer.uploaded_bytes(), 0u);
}

} // namespace
} // namespace trivar::gpu::testing
