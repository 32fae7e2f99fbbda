// SPDX-License-Identifier: GPL-3.0-or-later
#include "gpu/mirror.h"
#include "tests/gpu/support.h"

#include <optional>

namespace trivar::gpu::testing {

class TheMirror : public WithContext {
protected:
    Mirror mirror;
};

TEST_F(TheMirror, UploadsEqualRefsOnce)
{
    const auto mesh = make_ref(box_mesh({1, 1, 1}, {1, 1, 1}));
    const auto copy = make_ref(Mesh(*mesh)); // another identity
    const auto serial = mirror.mesh(mesh).serial;
    EXPECT_EQ(mirror.mesh(mesh).serial, serial);
    EXPECT_NE(mirror.mesh(copy).serial, serial);
    EXPECT_EQ(mirror.mesh_count(), 2u);
}

TEST_F(TheMirror, KeepsNoMeshAliveAndDropsTheDead)
{
    auto mesh = make_ref(box_mesh({1, 1, 1}, {1, 1, 1}));
    const std::weak_ptr<const Mesh> watched = mesh;
    mirror.mesh(mesh);
    mirror.drop_dead();
    EXPECT_EQ(mirror.mesh_count(), 1u);
    mesh.reset();
    EXPECT_TRUE(watched.expired());
    mirror.drop_dead();
    EXPECT_EQ(mirror.mesh_count(), 0u);
}

// An allocator may hand a dead mesh's address to the next one; a Ref without ownership does so
// for certain.
TEST_F(TheMirror, IsNotFooledByAnAddressUsedAgain)
{
    std::optional<Mesh> place(box_mesh({1, 1, 1}, {1, 1, 1}));
    const auto at_place = [&] { return Ref<Mesh>(&*place, [](const Mesh*) {}); };
    Ref<Mesh> mesh = at_place();
    const auto serial = mirror.mesh(mesh).serial;
    mesh = at_place();
    EXPECT_NE(mirror.mesh(mesh).serial, serial);
    EXPECT_EQ(mirror.mesh_count(), 1u);
}

TEST_F(TheMirror, KeepsTheFacesOfMeshesOfTrianglesThatComeAndGo)
{
    Mesh triangle;
    triangle.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    add_face(triangle, std::array{0u, 1u, 2u});
    auto mesh = make_ref(Mesh(triangle));
    const MirroredFaces* faces = mirror.mesh(mesh).faces.get();
    EXPECT_GT(faces->indices.bytes(), 0u);
    for (int frame = 1; frame < 4; ++frame) {
        triangle.positions.front().z = static_cast<float>(frame);
        mesh = make_ref(Mesh(triangle));
        mirror.drop_dead();
        EXPECT_EQ(mirror.mesh(mesh).faces.get(), faces);
    }
    triangle.face_material = {1};
    EXPECT_NE(mirror.mesh(make_ref(Mesh(triangle))).faces.get(), faces);
}

TEST_F(TheMirror, SortsTrianglesByMaterial)
{
    Mesh box = box_mesh({1, 1, 1}, {1, 1, 1});
    box.face_material = {1, 0, 1, 0, 1, 2};
    const auto mesh = make_ref(std::move(box));
    const auto& parts = mirror.mesh(mesh).parts();
    ASSERT_EQ(parts.size(), 3u);
    const std::array<int, 3> corners{2 * 6, 3 * 6, 6}; // two triangles a side
    int next = 0;
    for (std::size_t i = 0; i < 3; ++i) {
        EXPECT_EQ(parts[i].material, i);
        EXPECT_EQ(parts[i].first, next);
        EXPECT_EQ(parts[i].count, corners[i]);
        next += parts[i].count;
    }
}

TEST_F(TheMirror, RemembersTheBoxOfAMatrix)
{
    const auto mesh = make_ref(box_mesh({2, 2, 2}, {1, 1, 1}));
    for (int i = 0; i < 40; ++i) {
        const Box box = mirror.box_world(mesh, moved(i % 20, 0, 0));
        EXPECT_EQ(box.lo.x, i % 20 - 1);
        EXPECT_EQ(box.hi.x, i % 20 + 1);
    }
}

TEST_F(TheMirror, UploadsAnImageOnceForEachUse)
{
    Image image;
    image.size_px = {2, 2};
    image.rgba.assign(16, 128);
    auto ref = make_ref(image);
    const unsigned color = mirror.texture(ref, true).name();
    EXPECT_EQ(mirror.texture(ref, true).name(), color);
    EXPECT_NE(mirror.texture(ref, false).name(), color);
    EXPECT_EQ(mirror.texture_count(), 2u);
    ref.reset();
    mirror.drop_dead();
    EXPECT_EQ(mirror.texture_count(), 0u);
}

TEST_F(TheMirror, SortsTheEdgesOfAMeshAndOfWhatItBecomesOnce)
{
    const Ref<Mesh> rest = make_ref(box_mesh(glm::dvec3(1), glm::ivec3(2)));
    Mesh moved = *rest;
    for (glm::vec3& p : moved.positions) p.x += 1;
    const Ref<Mesh> deformed = make_ref(std::move(moved));
    const MirroredEdges& edges = mirror.edges(deformed, rest);
    EXPECT_EQ(edges.indices, mirror.edges(rest, rest).indices);
    EXPECT_GT(edges.indices->count, 0);
}

} // namespace trivar::gpu::testing
