// SPDX-License-Identifier: GPL-3.0-or-later
// core/kernel on the device. tests/ffd/kernel_test.cpp holds the same text as C++ to the textbook.
#include "core/base/rejected.h"
#include "gpu/ffd/device_deformer.h"
#include "gpu/framebuffer.h"
#include "gpu/vertex_array.h"
#include "tests/ffd/samples.h"
#include "tests/gpu/support.h"

#include <epoxy/gl.h>
#include <gmock/gmock.h>

namespace trivar::gpu::testing {
namespace {

using trivar::testing::angle_deg;
using trivar::testing::random_lattice;
using trivar::testing::scattered_points;
using trivar::testing::some_affine_map;
using trivar::testing::uneven_knots;

Stage stage_of(const std::array<Knots, 3>& axes, double size, const Embedding& embedding = {})
{
    return {make_ref(random_lattice(axes, size)), embedding};
}

std::array<Knots, 3> equal_axes(int order, int count)
{
    const Knots knots = Knots::uniform(order, count);
    return {knots, knots, knots};
}

// The largest difference: of positions as a share of the box, of normals and tangents in degrees.
struct Differences {
    double position = 0, normal_deg = 0, tangent_deg = 0;
};

Differences differences(const Deformed& a, const Deformed& b)
{
    Box box;
    for (const glm::vec3& p : b.positions) box.add(p);
    Differences out;
    EXPECT_EQ(a.positions.size(), b.positions.size());
    EXPECT_EQ(a.normals.size(), b.normals.size());
    EXPECT_EQ(a.tangents.size(), b.tangents.size());
    for (std::size_t i = 0; i < a.positions.size(); ++i)
        out.position = std::max(
            out.position, glm::distance(glm::dvec3(a.positions[i]), glm::dvec3(b.positions[i])) /
                              glm::length(box.size()));
    for (std::size_t i = 0; i < a.normals.size(); ++i)
        out.normal_deg = std::max(out.normal_deg, angle_deg(a.normals[i], b.normals[i]));
    for (std::size_t i = 0; i < a.tangents.size(); ++i) {
        EXPECT_EQ(a.tangents[i].w, b.tangents[i].w);
        out.tangent_deg = std::max(out.tangent_deg,
                                   angle_deg(glm::vec3(a.tangents[i]), glm::vec3(b.tangents[i])));
    }
    return out;
}

void expect_equal(const Deformed& a, const Deformed& b)
{
    const Differences d = differences(a, b);
    EXPECT_LT(d.position, 1e-6);
    EXPECT_LT(d.normal_deg, 0.05);
    EXPECT_LT(d.tangent_deg, 0.05);
}

class DeformedByTheDevice : public WithContext {
protected:
    DeviceDeformer deformer;

    Deformed by_device(const Mesh& mesh, std::vector<Stage> stages, const Method& method = {})
    {
        const DeviceVertices from = uploaded_vertices(mesh);
        DeviceVertices to;
        deformer.deform(from, to, stages, method);
        return read_back(to);
    }

    // What the vertex shader makes of it as it draws.
    Deformed by_vertex_shader(const Mesh& mesh, const Stage& stage)
    {
        const DeviceVertices from = uploaded_vertices(mesh);
        DeviceVertices to;
        to.positions.reserve(from.positions.bytes());
        to.normals.reserve(from.normals.bytes());
        to.tangents.reserve(from.tangents.bytes());
        deformer.bind(stage, from.bounds, glm::dvec3(0));
        const PackedAxes& axes = deformer.lattices().lattice(stage.lattice).axes->packed;
        const Program program(
            deform_program({axes.order, {}, true, deformer.reads_texels(), false}));
        program.use();
        VertexArray vertices;
        vertices.attribute(0, from.positions, 3, sizeof(glm::vec3));
        vertices.attribute(1, from.normals, 3, sizeof(glm::vec3));
        vertices.attribute(2, from.tangents, 4, sizeof(glm::vec4));
        vertices.bind();
        const Framebuffer nowhere({}, nullptr);
        nowhere.bind();
        glEnable(GL_RASTERIZER_DISCARD);
        for (const auto& [at, buffer] :
             {std::pair{0u, to.positions.name()}, std::pair{1u, to.normals.name()},
              std::pair{2u, to.tangents.name()}})
            glBindBufferBase(GL_TRANSFORM_FEEDBACK_BUFFER, at, buffer);
        glBeginTransformFeedback(GL_POINTS);
        glDrawArrays(GL_POINTS, 0, static_cast<GLsizei>(from.count));
        glEndTransformFeedback();
        glDisable(GL_RASTERIZER_DISCARD);
        glBindFramebuffer(GL_FRAMEBUFFER, 0);
        return read_back(to);
    }
};

Deformed by_processor(const Mesh& mesh, const std::vector<Stage>& stages)
{
    Mesh out = mesh;
    for (const Stage& stage : stages) out = deform(out, stage.embedding, *stage.lattice);
    return {out.positions, out.normals, out.tangents};
}

TEST_F(DeformedByTheDevice, AMillionPointsAreWhereTheProcessorPutsThem)
{
    const Mesh mesh = scattered_points(1'000'000, -0.02f, 1.02f);
    for (const int order : {3, 4}) {
        const std::vector<Stage> stages{stage_of(equal_axes(order, 8), 0.02)};
        expect_equal(by_device(mesh, stages), by_processor(mesh, stages));
    }
}

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

// With order 2 the normal jumps at knots, and a point beside one may fall on its other side.
TEST_F(DeformedByTheDevice, OrderTwoIsAsOnTheProcessor)
{
    const Mesh mesh = scattered_points(20000);
    for (const auto& axes :
         {equal_axes(2, 5),
          std::array{Knots::uniform(4, 5), Knots::uniform(3, 5), Knots::uniform(2, 5)}}) {
        const std::vector<Stage> stages{stage_of(axes, 0.02)};
        const Deformed device = by_device(mesh, stages), processor = by_processor(mesh, stages);
        EXPECT_LT(differences(device, processor).position, 1e-6);
        std::size_t off = 0;
        for (std::size_t i = 0; i < mesh.vertex_count(); ++i)
            off += angle_deg(device.normals[i], processor.normals[i]) > 0.05;
        EXPECT_LE(off, 4u);
    }
}

TEST_F(DeformedByTheDevice, TheVertexShaderGivesTheSame)
{
    const Mesh mesh = scattered_points(20000, -0.1f, 1.1f);
    const Stage stage = stage_of(equal_axes(3, 6), 0.02, {some_affine_map(), some_affine_map()});
    const Deformed two_phase = by_device(mesh, {stage}), one_phase = by_vertex_shader(mesh, stage);
    expect_equal(one_phase, two_phase);
    expect_equal(one_phase, by_processor(mesh, {stage}));
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
    const Deformed out = by_device(mesh, {{still, {}}});
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
    const Deformed one = by_device(mesh, {stage});
    deformer = DeviceDeformer(limits);
    expect_equal(by_device(mesh, {stage}), one);
    expect_equal(by_vertex_shader(mesh, stage), one);
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
    Deformed exact = by_processor(mesh, stages);
    exact.tangents.clear();
    for (const Sum sum : {Sum::nested, Sum::raised, Sum::filtered}) {
        const Differences d =
            differences(by_device(mesh, stages, {sum, NormalsBy::differences}), exact);
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
