// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/rejected.h"
#include "core/level/voxel_field.h"
#include "core/silhouette/border_lines.h"
#include "core/silhouette/certified.h"
#include "tests/silhouette/scenes.h"

#include <gtest/gtest.h>
#include <random>

namespace trivar::testing {
namespace {

// A volume of bumps, and the part of it in a box that cuts some of them.
struct Parted {
    explicit Parted(const VoxelFieldOptions& options = {})
        : whole(grid(), options),
          part(whole, box)
    {
    }
    static Ref<VoxelGrid> grid()
    {
        const SampledField from = sampled("gauss", 32);
        VoxelGrid out;
        out.size = from.size;
        out.samples = in_single_precision(from.samples);
        return make_ref(std::move(out));
    }
    bool has(const glm::vec3& p_whole) const
    {
        return glm::all(glm::greaterThanEqual(p_whole, glm::vec3(box.first))) &&
               glm::all(glm::lessThanEqual(p_whole, glm::vec3(box.last)));
    }
    // How far a place of the part is from the nearest face of the box.
    float from_faces(const glm::vec3& p_part) const
    {
        const glm::vec3 near = glm::min(p_part, part.field().end() - p_part);
        return std::min({near.x, near.y, near.z});
    }
    const double value = sampled("gauss", 32).level;
    const SampleBox box{{5, 9, 3}, {22, 24, 26}};
    const glm::vec3 first{box.first};
    VoxelField whole, part;
};

float distance_to(const Silhouettes& curves, const glm::vec3& p)
{
    float out = 1e30f;
    for (std::size_t c = 0; c < curves.count(); ++c)
        for (std::size_t i = curves.first[c]; i < curves.first[c + 1]; ++i) {
            const bool last = i + 1 == curves.first[c + 1];
            const glm::vec3 &a = curves.points[i].p,
                            &b = curves.points[last ? curves.first[c] : i + 1].p;
            const glm::vec3 along = last && !curves.closed[c] ? glm::vec3(0) : b - a;
            const float t = glm::dot(p - a, along) / std::max(1e-12f, glm::dot(along, along));
            out = std::min(out, glm::distance(p, a + std::clamp(t, 0.0f, 1.0f) * along));
        }
    return out;
}

TEST(FieldPart, HasTheSameValuesAndSlopes)
{
    std::minstd_rand random(1);
    for (const FieldSpline spline : {FieldSpline::interpolating, FieldSpline::smoothing})
        for (const FieldOrder order :
             {FieldOrder::linear, FieldOrder::quadratic, FieldOrder::cubic}) {
            const Parted scene({.spline = spline, .order = order, .blur = 1});
            const glm::ivec3 size = scene.box.size();
            for (int n = 0; n < 500; ++n) {
                // Quarters of voxels are told without rounding; at the last samples the part takes
                // the piece before, and the whole the one behind.
                const auto place = [&](int count) {
                    return static_cast<float>(random() % static_cast<unsigned>(4 * count - 4)) / 4;
                };
                const glm::vec3 p(place(size.x), place(size.y), place(size.z));
                const ScalarJet<float> jet = scene.part.field().at<1>(p),
                                       there = scene.whole.field().at<1>(scene.first + p);
                ASSERT_EQ(jet.value, there.value);
                ASSERT_EQ(jet.gradient, there.gradient);
            }
        }
}

TEST(FieldPart, HasThePartOfALevelThatIsInTheBox)
{
    for (const FieldSpline spline : {FieldSpline::interpolating, FieldSpline::smoothing}) {
        const Parted scene({.spline = spline});
        const LevelMesh whole = scene.whole.level(scene.value),
                        part = scene.part.level(scene.value);
        const std::vector<std::uint32_t> corners = whole.triangles();
        std::size_t in_box = 0;
        for (std::size_t t = 0; t < whole.triangle_count(); ++t) {
            glm::vec3 middle(0);
            for (std::size_t c = 0; c < 3; ++c)
                middle += whole.positions[corners[3 * t + c]] / 3.0f;
            in_box += scene.has(middle);
        }
        EXPECT_EQ(part.triangle_count(), in_box);
        EXPECT_LT(in_box, whole.triangle_count());
        const auto before = [](const glm::vec3& a, const glm::vec3& b) { return a.x < b.x; };
        std::vector<glm::vec3> known = whole.positions;
        std::ranges::sort(known, before);
        for (const glm::vec3& p : part.positions) {
            constexpr float near = 1e-3f; // voxels
            const glm::vec3 at = p + scene.first;
            bool found = false;
            for (auto v = std::ranges::lower_bound(known, at - near, before);
                 v != known.end() && v->x <= at.x + near && !found; ++v)
                found = glm::distance(*v, at) <= near;
            ASSERT_TRUE(found);
        }
    }
}

TEST(FieldPart, HasTheSameSilhouettesUpToItsFaces)
{
    const Parted scene;
    const LevelMesh whole = scene.whole.level(scene.value), part = scene.part.level(scene.value);
    SilhouetteFinder find;
    for (ViewPoint view : some_views(scene.box.size(), 20)) {
        const SilhouetteOptions dense{.spacing = 0.02f};
        const Silhouettes ours = find(scene.part.field(), part, view, dense);
        const ViewPoint there{view.at + view.at.w * glm::dvec4(scene.first, 0)};
        const Silhouettes all = find(scene.whole.field(), whole, there, dense);
        EXPECT_GT(ours.points.size(), 0u);
        std::size_t inside = 0, found = 0;
        for (const SilhouettePoint& point : all.points) inside += scene.has(point.p);
        for (const SilhouettePoint& point : ours.points)
            // At its faces a curve ends where the mesh has it: Newton's method would leave the
            // grid.
            found += distance_to(all, point.p + scene.first) <
                     (scene.from_faces(point.p) > 0.25f ? 0.02f : 0.2f);
        EXPECT_EQ(found, ours.points.size());
        EXPECT_NEAR(static_cast<double>(inside), static_cast<double>(ours.points.size()),
                    0.02 * static_cast<double>(inside) + 10);
        for (std::size_t c = 0; c < ours.count(); ++c) {
            if (ours.closed[c]) continue;
            for (const std::size_t i : {ours.first[c], ours.first[c + 1] - 1}) {
                EXPECT_LT(scene.from_faces(ours.points[i].p), 0.1f) << "a loose end in the box";
            }
        }
    }
}

TEST(FieldPart, HasClosedBordersWhereTheBoxCutsTheBody)
{
    const Parted scene;
    EXPECT_EQ(border_lines(scene.whole.field(), scene.whole.level(scene.value)).count(), 0u)
        << "the bumps end within the whole";
    const Silhouettes border = border_lines(scene.part.field(), scene.part.level(scene.value));
    ASSERT_GT(border.count(), 2u);
    for (const SilhouettePoint& point : border.points) {
        EXPECT_EQ(scene.from_faces(point.p), 0);
        EXPECT_NEAR(scene.whole.field().at<0>(point.p + scene.first).value, scene.value, 1e-4);
    }
    for (const char closed : border.closed) EXPECT_TRUE(closed);
}

TEST(FieldPart, IsCertifiedAlike)
{
    const Parted scene;
    const auto certified = [&](const VoxelField& field, const glm::vec3& first) {
        return certified_silhouettes(field.field(), field.hulls(), static_cast<float>(scene.value),
                                     {glm::dvec4(glm::dvec3(first) + glm::dvec3(60, 40, 30), 1)},
                                     1);
    };
    const CertifiedSilhouettes part = certified(scene.part, glm::vec3(0)),
                               whole = certified(scene.whole, scene.first);
    EXPECT_EQ(part.loose_ends, 0u);
    EXPECT_LT(part.cells, whole.cells);
    for (const SilhouettePoint& point : part.curves.points)
        EXPECT_TRUE(std::ranges::any_of(whole.curves.points, [&](const SilhouettePoint& other) {
            return glm::distance(other.p, point.p + scene.first) < 0.2f;
        }));
}

} // namespace
} // namespace trivar::testing
