// SPDX-License-Identifier: GPL-3.0-or-later
// One phase and two phases are where the processor is, vertex by vertex, on a million points each.
#include "tests/gpu/deforming.h"

#include <random>

namespace trivar::gpu::testing {
namespace {

using trivar::testing::scattered_points;
using trivar::testing::some_affine_map;
using trivar::testing::uneven_knots;

constexpr std::size_t million = 1'000'000;

// Coordinates all over [lo, hi], a tenth of them the very knots and ends of an axis.
Mesh points_at_knots_too(const std::array<Knots, 3>& axes, float lo, float hi)
{
    Mesh mesh = scattered_points(million, lo, hi);
    std::mt19937 random(7);
    for (int axis = 0; axis < 3; ++axis) {
        const std::vector<double> breaks = axes[static_cast<std::size_t>(axis)].breaks();
        for (glm::vec3& p : mesh.positions)
            if (random() % 10 == 0) p[axis] = static_cast<float>(breaks[random() % breaks.size()]);
    }
    return mesh;
}

// Whether a derivative jumps so near to t that rounding decides which side is taken: at the knots
// of an axis of order 2, and where the slack of open ends is over (core/kernel/axis.glsl).
bool beside_a_jump(const Knots& knots, double t)
{
    constexpr double slack = 1e-6, rounding = 1e-6;
    const double length = knots.end() - knots.begin();
    const bool open = knots.closure() == Closure::open;
    const double beyond = std::max(knots.begin() - t, t - knots.end()) / length;
    if (open && beyond > -slack) return std::abs(beyond - slack) < rounding && beyond != 0;
    if (knots.order() > 2) return false;
    const double turn = open ? t : t - length * std::floor((t - knots.begin()) / length);
    for (const double k : knots.breaks())
        if (std::abs(turn - k) < rounding * length) return true;
    return false;
}

// Normals and tangents of points beside a jump are the other's: they may be either side's.
DeformedArrays settled(DeformedArrays found, const DeformedArrays& other, const Mesh& mesh,
                       const Stage& stage)
{
    for (std::size_t i = 0; i < mesh.vertex_count(); ++i) {
        const glm::dvec3 uvw(stage.embedding.to_uvw * glm::dvec4(mesh.positions[i], 1));
        bool beside = false;
        for (int axis = 0; axis < 3; ++axis)
            beside = beside || beside_a_jump(stage.lattice->displacement.axes[axis], uvw[axis]);
        if (!beside) continue;
        found.normals[i] = other.normals[i];
        found.tangents[i] = other.tangents[i];
    }
    return found;
}

class DeformedInEveryWay : public DeformedByTheDevice {
protected:
    void expect_agreement(const Mesh& mesh, const Stage& stage)
    {
        const DeformedArrays processor = by_processor(mesh, {stage});
        expect_equal(settled(by_vertex_shader(mesh, {stage}), processor, mesh, stage), processor);
        expect_equal(settled(by_device(mesh, {stage}), processor, mesh, stage), processor);
    }
};

TEST_F(DeformedInEveryWay, AMillionPointsAgreeAcrossKnotsAndBeyondEnds)
{
    for (const int order : {2, 3, 4}) {
        const std::array<Knots, 3> axes = equal_axes(order, 8);
        expect_agreement(points_at_knots_too(axes, -0.1f, 1.1f), stage_of(axes, 0.02));
    }
}

TEST_F(DeformedInEveryWay, AMillionPointsAgreeOnUnevenKnotsAndOrdersOfAllKinds)
{
    const std::array<Knots, 3> axes{uneven_knots(4), Knots::uniform(2, 6), uneven_knots(3)};
    expect_agreement(points_at_knots_too(axes, -0.1f, 1.1f), stage_of(axes, 0.02));
}

TEST_F(DeformedInEveryWay, AMillionPointsAgreeRoundClosedAndTwistedAxes)
{
    const auto closed = [](int order, Closure closure) {
        return Knots::periodic(order, order + 4, 0, 1, closure);
    };
    const std::array<Knots, 3> ring{closed(3, Closure::periodic), Knots::uniform(4, 6),
                                    Knots::uniform(3, 5)},
        band{closed(4, Closure::twisted), Knots::uniform(3, 6), Knots::uniform(3, 4)},
        knot{closed(2, Closure::twisted), closed(3, Closure::twisted),
             closed(4, Closure::periodic)};
    for (const std::array<Knots, 3>& axes : {ring, band, knot})
        expect_agreement(points_at_knots_too(axes, -2, 3), stage_of(axes, 0.02));
}

TEST_F(DeformedInEveryWay, AMillionPointsAgreeThroughTwoVolumes)
{
    const Mesh mesh = scattered_points(million, -0.1f, 1.1f);
    glm::dmat4 half(0.5);
    half[3] = {0.25, 0.25, 0.25, 1};
    const std::array<Knots, 3> band{Knots::periodic(3, 6, 0, 1, Closure::twisted),
                                    Knots::uniform(4, 6), Knots::uniform(3, 5)};
    const std::vector<Stage> stages{
        stage_of(equal_axes(3, 6), 0.02, {half, some_affine_map()}),
        stage_of(band, 0.02, {half * glm::inverse(some_affine_map()), glm::dmat4(1)})};
    const DeformedArrays processor = by_processor(mesh, stages);
    expect_equal(by_vertex_shader(mesh, stages), processor);
    expect_equal(by_device(mesh, stages), processor);
}

} // namespace
} // namespace trivar::gpu::testing
