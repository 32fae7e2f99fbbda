// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/gpu/support.h"

#include <cstdlib>

// A draft leaves out nothing that is seen.
namespace trivar::gpu::testing {
namespace {

// In triangles, of which those are known that are the skins of bodies.
Mesh cut(const Mesh& mesh)
{
    Mesh out = mesh;
    out.corners.clear();
    out.face_begin = {0};
    for (const glm::uvec3& t : triangles(mesh)) add_face(out, std::array{t.x, t.y, t.z});
    out.points = points_by_position(out.positions);
    return out;
}

// The same to look at, but with a triangle less somewhere inside, so that it is no body.
Mesh not_closed(Mesh mesh)
{
    const auto first = static_cast<std::uint32_t>(mesh.positions.size());
    for (int i = 0; i < 3; ++i) {
        mesh.positions.emplace_back(0.01f * static_cast<float>(i), 0, 0.01f * (i == 2 ? 1.0f : 0));
        mesh.normals.emplace_back(0, -1, 0);
        for (auto& set : mesh.uvs) set.emplace_back(0);
    }
    add_face(mesh, std::array{first, first + 1, first + 2});
    mesh.points = points_by_position(mesh.positions);
    return mesh;
}

} // namespace

class Drafts : public WithContext {
protected:
    Renderer renderer;

    static Picture draft_of(const Instance& instance)
    {
        Picture picture;
        picture.draft = true;
        picture.camera.eye = {0, -6, 3};
        picture.instances = {instance};
        return picture;
    }
};

TEST_F(Drafts, ShowBodiesByTheirFronts)
{
    const Mesh body = cut(torus_mesh(1, 0.4, {64, 32}));
    const Image alone = renderer.render(draft_of(instance_of(body)), {160, 120});
    const Image with_backs = renderer.render(draft_of(instance_of(not_closed(body))), {160, 120});
    int different = 0; // where a triangle's edge passes through the middle of a pixel
    for (int y = 0; y < 120; ++y)
        for (int x = 0; x < 160; ++x) {
            const glm::ivec3 off = glm::abs(rgb_at(alone, {x, y}) - rgb_at(with_backs, {x, y}));
            different += std::max({off.x, off.y, off.z}) > 8;
        }
    EXPECT_LE(different, 160 * 120 / 500);
}

TEST_F(Drafts, ShowABodyFromWithin)
{
    Instance body = instance_of(cut(box_mesh({20, 20, 20}, {2, 2, 2})));
    body.id = 7;
    renderer.draw(draft_of(body), {48, 48});
    EXPECT_EQ(renderer.pick({24, 24}), 7);
}

TEST_F(Drafts, ShowWhatOneCanSeeThroughAsItWillBe)
{
    Material glass;
    glass.base_color = {0.1f, 0.5f, 0.2f, 0.5f};
    glass.alpha = Material::Alpha::blend;
    Picture picture = draft_of(instance_of(box_mesh({2, 2, 2}, {1, 1, 1}), glm::dmat4(1), glass));
    picture.settings.shadows = picture.settings.ambient_occlusion = false;
    const glm::ivec3 draft = rgb_at(renderer.render(picture, {64, 64}), {32, 32});
    picture.draft = false;
    picture.samples = 1;
    const glm::ivec3 full = rgb_at(renderer.render(picture, {64, 64}), {32, 32});
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(draft[c], full[c], 2);
}

} // namespace trivar::gpu::testing
