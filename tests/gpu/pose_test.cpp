// SPDX-License-Identifier: GPL-3.0-or-later
// Poses by the device beside those by the processor, alone and before volumes.
#include "gpu/ffd/deform_timer.h"
#include "gpu/ffd/device_poser.h"
#include "tests/gpu/support.h"
#include "tests/support/rigged.h"
#include "tests/support/splines.h"

#include <gmock/gmock.h>
#include <random>

namespace trivar::gpu::testing {
namespace {

using trivar::testing::rigged_model;

// A pose that turns, moves and stretches joints at random, and some weight of every target.
Pose random_pose(const Mesh& mesh, std::size_t joints, unsigned seed)
{
    std::mt19937 random(seed);
    std::uniform_real_distribution<float> number(-1, 1);
    Pose pose;
    for (std::size_t k = 0; k < joints; ++k) {
        glm::mat4& joint = pose.joints.emplace_back(1);
        for (int c = 0; c < 4; ++c)
            for (int r = 0; r < 3; ++r) joint[c][r] += 0.3f * number(random);
    }
    for (std::size_t t = 0; t < mesh.morph_targets.size(); ++t)
        pose.morph_weights.push_back(number(random));
    return pose;
}

// A ball whose vertices go with random joints and have random targets.
Mesh random_rig(int targets, bool skinned, bool tangents)
{
    Mesh mesh = sphere_mesh(1, 200, 100);
    std::mt19937 random(5);
    std::uniform_real_distribution<float> number(-0.2f, 0.2f);
    const auto any = [&] { return glm::vec3(number(random), number(random), number(random)); };
    for (const glm::vec3& n : mesh.normals)
        if (tangents)
            mesh.tangents.emplace_back(glm::normalize(glm::cross(n, glm::vec3(0.3f, 0.5f, 0.8f))),
                                       1);
    for (std::size_t v = 0; v < mesh.vertex_count(); ++v) {
        if (!skinned) break;
        Mesh::Influences by;
        float sum = 0;
        for (std::size_t k = 0; k < 4; ++k) {
            by.joints[k] = static_cast<std::uint16_t>(random() % 9);
            sum += by.weights[static_cast<int>(k)] = number(random) + 0.21f;
        }
        by.weights /= sum;
        mesh.influences.push_back(by);
    }
    for (int t = 0; t < targets; ++t) {
        Mesh::MorphTarget& target = mesh.morph_targets.emplace_back();
        for (std::size_t v = 0; v < mesh.vertex_count(); ++v) {
            target.positions.push_back(any());
            if (t > 0) target.normals.push_back(any());
            if (t > 1) target.tangents.push_back(any());
        }
    }
    return mesh;
}

class Poses : public WithContext {
protected:
    Renderer renderer;
};

TEST_F(Poses, AreThoseOfTheProcessor)
{
    for (const bool skinned : {true, false})
        for (const int targets : {0, 1, 2, 3})
            for (const bool tangents : {true, false}) {
                const Ref<Mesh> mesh = make_ref(random_rig(targets, skinned, tangents));
                const Ref<PosedMesh> posed =
                    posed_later(mesh, random_pose(*mesh, skinned ? 9 : 0, 3));
                Programs programs;
                DevicePoser poser(programs);
                const DeviceVertices from = uploaded_vertices(*mesh);
                DeviceVertices to;
                poser.pose(from, to, *posed);
                const Mesh& exact = **posed->mesh;
                const DeformErrors off =
                    errors_of(read_back(to), {exact.positions, exact.normals, exact.tangents});
                EXPECT_LT(off.position, 1e-6) << skinned << targets << tangents;
                EXPECT_LT(off.normal_deg, 0.05) << skinned << targets << tangents;
                for (const glm::vec3& p : exact.positions)
                    ASSERT_LT(to.bounds.distance(glm::dvec3(p)), 1e-5);
            }
}

Picture picture_with(const Ref<PosedMesh>& posed, const std::vector<Stage>& stages, DeformBy by)
{
    Picture picture;
    picture.camera.eye = {1, -6, 4};
    picture.camera.target = {1.5, 0, 0};
    picture.samples = 1;
    picture.deform_by = by;
    Instance instance;
    instance.mesh = posed->rest;
    instance.posed = posed;
    instance.stages = stages;
    instance.id = 7;
    if (by == DeformBy::processor) { // beforehand
        Mesh out = **posed->mesh;
        for (const Stage& stage : stages) out = deform(out, stage.embedding, *stage.lattice);
        instance.mesh = make_ref(std::move(out));
        instance.posed = nullptr;
        instance.stages.clear();
    }
    picture.instances.push_back(instance);
    return picture;
}

Ref<PosedMesh> bent_bar(const Model& model, double time_s)
{
    return posed_later(model.meshes[0],
                       pose_of(model, 0, stance_at(model, &model.clips[0], time_s)));
}

int unlike(const Image& a, const Image& b)
{
    int count = 0;
    for (std::size_t i = 0; i < a.rgba.size(); i += 4)
        count += std::abs(int{a.rgba[i]} - int{b.rgba[i]}) > 3 ? 1 : 0;
    return count;
}

TEST_F(Poses, AreDrawnAloneInAVolumeAndInAStack)
{
    const Model model = rigged_model();
    const Knots knots = Knots::uniform(3, 5);
    glm::dmat4 to_uvw(1.0 / 6);
    to_uvw[3] = {0.2, 0.5, 0.5, 1};
    const Stage stage{
        make_ref(
            Lattice{trivar::testing::random_volume({knots, knots, knots}, 1, 0.3), glm::dmat4(1)}),
        {to_uvw, glm::dmat4(1)}};
    constexpr glm::ivec2 size_px{160, 120};
    for (const std::vector<Stage>& stages :
         {std::vector<Stage>{}, std::vector<Stage>{stage}, std::vector<Stage>{stage, stage}}) {
        const auto shown = [&](double time, DeformBy by) {
            return renderer.render(picture_with(bent_bar(model, time), stages, by), size_px);
        };
        const Image straight = shown(0, DeformBy::processor), bent = shown(1, DeformBy::processor);
        EXPECT_GT(unlike(straight, bent), 500);
        for (const DeformBy by : {DeformBy::two_phases, DeformBy::one_phase}) {
            EXPECT_LE(unlike(shown(0, by), straight), 8) << stages.size();
            EXPECT_LE(unlike(shown(1, by), bent), 8) << stages.size();
            EXPECT_EQ(renderer.notice(), "");
        }
    }
}

} // namespace
} // namespace trivar::gpu::testing
