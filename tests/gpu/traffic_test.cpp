// SPDX-License-Identifier: GPL-3.0-or-later
// What pictures of deformed meshes send to the device and take back, counted in bytes.
#include "core/base/rejected.h"
#include "core/ffd/packed_volume.h"
#include "tests/gpu/deforming.h"
#include "tests/support/buffer_traffic.h"

namespace trivar::gpu::testing {
namespace {

constexpr glm::ivec2 counted_px{80, 60};
constexpr std::size_t few_kb = 16 << 10; // what a picture's camera, light and passes take

class Traffic : public WithContext {
protected:
    Traffic()
    {
        picture.camera.eye = {0, -5, 2};
        picture.samples = 1;
        picture.deform_by = DeformBy::two_phases;
        picture.settings.ground = false;
        Instance instance;
        instance.mesh = torus;
        instance.id = 7;
        picture.instances.push_back(instance);
    }
    std::vector<Stage>& stages() { return picture.instances.front().stages; }
    Stage stage(double size) const { return stage_of(equal_axes(3, 9), size, in_box); }
    void draw()
    {
        traffic.forget();
        renderer.draw(picture, counted_px);
    }
    const Embedding in_box = [] { // from [-1, 1]^3 to the parameters
        glm::dmat4 half(0.5);
        half[3] = {0.5, 0.5, 0.5, 1};
        return Embedding{half, glm::dmat4(1)};
    }();
    const Ref<Mesh> torus = make_ref(torus_mesh(0.6, 0.25, {96, 48}));
    const std::size_t mesh_bytes = torus->vertex_count() * sizeof(glm::vec3);
    Renderer renderer;
    Picture picture;
    trivar::testing::BufferTraffic traffic;
};

TEST_F(Traffic, OfAStaticMeshIsOneUpload)
{
    draw();
    EXPECT_GE(traffic.largest_written(), mesh_bytes);
    const std::size_t kept = renderer.uploaded_bytes();
    picture.camera.eye = {3, -4, 2};
    draw();
    EXPECT_LT(traffic.bytes_written(), few_kb);
    EXPECT_EQ(traffic.read_back, 0u);
    EXPECT_EQ(renderer.uploaded_bytes(), kept);
}

TEST_F(Traffic, OfAChangedLatticeIsTheLattice)
{
    for (const DeformBy by : {DeformBy::two_phases, DeformBy::one_phase}) {
        picture.deform_by = by;
        stages() = {stage(0.1)};
        draw();
        draw();
        EXPECT_LT(traffic.bytes_written(), few_kb);
        EXPECT_EQ(traffic.read_back, 0u);
        stages() = {stage(0.2)};
        draw();
        const std::size_t lattice_bytes =
            packed_points(stages().front().lattice->displacement).size() * sizeof(glm::vec4);
        EXPECT_EQ(std::ranges::count(traffic.written, lattice_bytes), 1);
        EXPECT_LT(traffic.bytes_written() - lattice_bytes, few_kb);
        EXPECT_EQ(traffic.read_back, 24u) << "the box alone comes back";
        EXPECT_EQ(renderer.notice(), "");
    }
}

TEST_F(Traffic, OfAStackHasNoVertices)
{
    for (const DeformBy by : {DeformBy::two_phases, DeformBy::one_phase}) {
        picture.deform_by = by;
        stages() = {stage(0.1), stage(0.15), stage(0.05)};
        draw();
        stages().front().embedding.to_uvw[3].x += 0.01;
        draw();
        EXPECT_LT(traffic.bytes_written(), few_kb);
        EXPECT_EQ(traffic.read_back, 24u);
        EXPECT_EQ(renderer.notice(), "");
    }
}

// A volume that moves all by 1.5 in x: the mesh is where it is seen and no more where it was.
TEST_F(Traffic, OfPickingIsOnTheDeformedSurface)
{
    Lattice moved = *stage(0).lattice;
    for (glm::dvec3& d : moved.displacement.points) d = {1.5, 0, 0};
    const auto id_at = [&](const glm::dvec3& p_world) {
        Camera camera = picture.camera;
        camera.size_px = counted_px;
        return renderer.pick(glm::ivec2(project(camera, p_world).p_px));
    };
    const glm::dvec3 on_it(0, -0.6, 0.2);
    draw();
    EXPECT_EQ(id_at(on_it), 7);
    EXPECT_EQ(id_at(on_it + glm::dvec3(1.5, 0, 0)), 0);
    stages() = {{make_ref(moved), in_box}};
    for (const DeformBy by : {DeformBy::processor, DeformBy::two_phases, DeformBy::one_phase}) {
        picture.deform_by = by;
        draw();
        EXPECT_EQ(id_at(on_it), 0) << static_cast<int>(by);
        EXPECT_EQ(id_at(on_it + glm::dvec3(1.5, 0, 0)), 7) << static_cast<int>(by);
    }
}

TEST_F(Traffic, ThatTheDeviceHasNoRoomForIsRefusedAndTheNextPictureDrawn)
{
    glDisable(GL_DEBUG_OUTPUT); // which would fail the test for what it says
    traffic.room = 50'000;
    EXPECT_THROW(renderer.draw(picture, counted_px), Rejected);
    EXPECT_LT(renderer.uploaded_bytes(), traffic.room) << "no half of it is kept";
    traffic.room = 1 << 30;
    draw();
    EXPECT_EQ(renderer.pick(counted_px / 2 + glm::ivec2(0, 8)), 7);
}

} // namespace
} // namespace trivar::gpu::testing
