// SPDX-License-Identifier: GPL-3.0-or-later
// core/kernel on the device. tests/ffd/kernel_test.cpp holds the same text as C++ to the textbook,
// agreement_test.cpp the ways to each other.
#include "core/base/rejected.h"
#include "tests/gpu/deforming.h"

#include <gmock/gmock.h>

namespace trivar::gpu::testing {
namespace {

using trivar::testing::random_lattice;
using trivar::testing::scattered_points;
using trivar::testing::some_affine_map;
using trivar::testing::uneven_knots;

TEST_F(DeformedByTheDevice, MixedOrdersAndAllKnotsAreAsInDouble)
{
    const Mesh mesh = scattered_points(5000, 0, 0.999f);
    const auto expect_double = [&](const std::array<Knots, 3>& axes) {
        const std::vector<Stage> stages{stage_of(axes, 0.02)};
        const Mesh exact = trivar::testing::deform_in_double(mesh, {}, *stages.front().lattice);
        expect_equal(by_device(mesh, stages), {exact.positions, exact.normals, exact.tangents});
    };
    expect_double({Knots::uniform(4, 9), uneven_knots(3), Knots::uniform(3, 5)});
    expect_double({Knots::periodic(4, 6), Knots::uniform(3, 5), uneven_knots(4)});
    expect_double({Knots::periodic(3, 6, 0, 0.5, Closure::twisted), Knots::uniform(3, 5),
                   Knots::periodic(4, 5)});
}

TEST_F(DeformedByTheDevice, AStackOfVolumesIsComposedWithoutReadBack)
{
    const Mesh mesh = scattered_points(50000);
    glm::dmat4 half(0.5);
    half[3] = {0.25, 0.25, 0.25, 1};
    const std::vector<Stage> stages{
        stage_of(equal_axes(3, 5), 0.02, {half, some_affine_map()}),
        stage_of(equal_axes(4, 6), 0.02, {half * glm::inverse(some_affine_map()), glm::dmat4(1)}),
        stage_of(equal_axes(3, 4), 0.02, {glm::dmat4(1), half})};
    expect_equal(by_device(mesh, stages), by_processor(mesh, stages));
}

TEST_F(DeformedByTheDevice, TheBoxIsThatOfThePositions)
{
    const Mesh mesh = scattered_points(10000, -3, 2);
    const Stage stage = stage_of(equal_axes(3, 5), 0.3);
    const DeviceVertices from = uploaded_vertices(mesh);
    DeviceVertices to;
    deformer.deform(from, to, std::vector{stage});
    Box expected;
    for (const glm::vec3& p : read_back(to).positions) expected.add(p);
    EXPECT_EQ(deformer.box_of(to).lo, expected.lo);
    EXPECT_EQ(deformer.box_of(to).hi, expected.hi);
    EXPECT_LT(glm::distance(deformer.box_of(from, &stage).lo, expected.lo), 1e-6);
    EXPECT_LT(glm::distance(deformer.box_of(from, &stage).hi, expected.hi), 1e-6);
    EXPECT_EQ(deformer.box_of(from).lo, bounding_box(mesh).lo);
}

TEST_F(DeformedByTheDevice, AnUntouchedLatticeGivesTheVeryBitsBack)
{
    const Mesh mesh = scattered_points(5000, -1, 2);
    const auto still = make_ref(lattice_at_rest(equal_axes(4, 6), glm::dmat4(1)));
    const DeformedArrays out = by_device(mesh, {{still, {}}});
    EXPECT_EQ(trivar::testing::bits(out.positions), trivar::testing::bits(mesh.positions));
}

// Parameters that move along a closed axis change no upload: the animation of a walk.
TEST_F(DeformedByTheDevice, ParametersMoveWithoutUploads)
{
    const Mesh mesh = scattered_points(5000);
    Stage stage =
        stage_of({Knots::periodic(3, 8), Knots::uniform(3, 4), Knots::uniform(3, 4)}, 0.02);
    for (const double turns : {0.0, 0.3, 17.6, -1234.5}) {
        stage.embedding.to_uvw[3].x = turns;
        stage.embedding.to_uvw[0].x = 0.5;
        expect_equal(by_device(mesh, {stage}), by_processor(mesh, {stage}));
    }
    EXPECT_EQ(deformer.lattices().uploads(), 1u);
}

TEST_F(DeformedByTheDevice, WhatIsFarFromTheOriginKeepsItsDigitsRelativeToAnOther)
{
    const Mesh mesh = scattered_points(5000);
    glm::dmat4 far(1);
    far[3] = {1e6, -2e6, 3e5, 1};
    const Stage there = stage_of(equal_axes(3, 5), 0.02, {glm::dmat4(1), far});
    const Stage here{there.lattice, {}};
    const DeviceVertices from = uploaded_vertices(mesh);
    DeviceVertices to;
    deformer.deform(from, to, std::vector{there}, {}, glm::dvec3(far[3]));
    expect_equal(read_back(to), by_processor(mesh, {here}));
}

TEST_F(DeformedByTheDevice, StorageAndTexelsAreReadAlike)
{
    const Mesh mesh = scattered_points(5000);
    const Stage stage = stage_of(equal_axes(3, 5), 0.02);
    DeviceLimits limits = device_limits();
    limits.reads_texels = !limits.reads_texels;
    const DeformedArrays one = by_device(mesh, {stage});
    deformer = DeviceDeformer(limits);
    expect_equal(by_device(mesh, {stage}), one);
    expect_equal(by_vertex_shader(mesh, {stage}), one);
}

TEST_F(DeformedByTheDevice, MeshesLargerThanADispatchAreDeformedInSlices)
{
    const Mesh mesh = scattered_points(10000);
    const std::vector<Stage> stages{stage_of(equal_axes(3, 5), 0.02)};
    DeviceLimits limits = device_limits();
    limits.slice_vertices = 1024;
    deformer = DeviceDeformer(limits);
    expect_equal(by_device(mesh, stages), by_processor(mesh, stages));
}

TEST_F(DeformedByTheDevice, ALatticeUploadsOnceAndAChangedOneUploadsItself)
{
    const Mesh mesh = scattered_points(100);
    const Stage stage = stage_of(equal_axes(3, 5), 0.02);
    by_device(mesh, {stage});
    by_device(mesh, {stage});
    EXPECT_EQ(deformer.lattices().uploads(), 1u);
    const DeviceAxes* const axes = deformer.lattices().lattice(stage.lattice).axes.get();
    const Stage changed{make_ref(random_lattice(equal_axes(3, 5), 0.02, 2)), {}};
    by_device(mesh, {changed});
    EXPECT_EQ(deformer.lattices().uploads(), 2u);
    EXPECT_EQ(deformer.lattices().lattice(changed.lattice).axes.get(), axes);
}

// The thesis's ways, 4.3 and 4.4: right, and worth less.
TEST_F(DeformedByTheDevice, OrderRaisingAndDifferencesComeNear)
{
    const Mesh mesh = scattered_points(20000);
    const std::vector<Stage> stages{
        stage_of(equal_axes(3, 6), 0.02)}; // cubics take long to compile
    DeformedArrays exact = by_processor(mesh, stages);
    exact.tangents.clear();
    for (const Sum sum : {Sum::nested, Sum::raised, Sum::filtered}) {
        const DeformErrors d =
            errors_of(by_device(mesh, stages, {sum, NormalsBy::differences}), exact);
        EXPECT_LT(d.position, sum == Sum::filtered ? 1e-3 : 1e-6);
        EXPECT_LT(d.normal_deg, sum == Sum::filtered ? 180 : 3);
        EXPECT_GT(d.normal_deg, 0.005);
    }
}

TEST_F(DeformedByTheDevice, WhatTheDeviceCannotDoIsRefusedInASentence)
{
    using ::testing::HasSubstr;
    const auto sentence = [](auto&& body) -> std::string {
        try {
            body();
        } catch (const Rejected& error) {
            return error.what();
        }
        return "it was done";
    };
    const Mesh mesh = scattered_points(100);
    EXPECT_THAT(sentence([&] { by_device(mesh, {stage_of(equal_axes(5, 6), 0.1)}); }),
                HasSubstr("order 5"));
    const Knots torn = Knots::general(3, {0, 0, 0, 0.5, 0.5, 0.5, 1, 1, 1});
    const Method raised{Sum::raised, NormalsBy::nothing};
    EXPECT_THAT(sentence([&] {
                    by_device(mesh, {stage_of({torn, torn, torn}, 0.1)}, raised);
                }),
                HasSubstr("torn"));
    DeviceLimits limits = device_limits();
    limits.storage_block = limits.texels = 100;
    deformer = DeviceDeformer(limits);
    EXPECT_THAT(sentence([&] { by_device(mesh, {stage_of(equal_axes(4, 8), 0.1)}); }),
                HasSubstr("kB"));
    limits.gl_version = 33;
    EXPECT_THAT(sentence([&] { DeviceDeformer{limits}; }), HasSubstr("needs OpenGL 4.3"));
}

} // namespace
} // namespace trivar::gpu::testing
