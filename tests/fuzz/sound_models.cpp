// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/fuzz/sound_models.h"

#include "core/mesh/primitives.h"
#include "tests/files/curves.h"
#include "tests/files/sample_models.h"
#include "tests/support/rigged.h"

#include <glm/gtc/matrix_transform.hpp>

namespace trivar::testing {
namespace {

Model textured_box()
{
    Model model = box_model();
    Material& red = model.materials.front();
    for (Texture* texture : {&red.metallic_roughness_texture, &red.normal_texture,
                             &red.occlusion_texture, &red.emissive_texture})
        *texture = red.base_color_texture;
    return model;
}

Model colored_ball()
{
    Mesh mesh = sphere_mesh(0.5, 6, 4);
    for (const glm::vec3& p : mesh.positions) mesh.colors.emplace_back(p + 0.5f, 1);
    Model model = single_mesh_model("ball", std::move(mesh));
    model.nodes.push_back({"ball again", 0, glm::translate(glm::dmat4(1), {1, 0, 0}), 0});
    return model;
}

Model concave_polygon()
{
    Mesh mesh;
    mesh.positions = {{0, 0, 0}, {2, 0, 0}, {2, 1, 0}, {1, 1, 0}, {1, 2, 0}, {0, 2, 0}};
    add_face(mesh, std::array<std::uint32_t, 6>{0, 1, 2, 3, 4, 5});
    mesh.normals = smooth_normals(mesh);
    return single_mesh_model("corner", std::move(mesh));
}

Model wired_box()
{
    Model model =
        single_mesh_model("box", box_mesh({1, 1, 1}, {1, 1, 1}), curves_model().materials);
    model.curves = curves_model().curves;
    model.nodes.front().curves = 0;
    return model;
}

} // namespace

std::vector<Model> sound_models()
{
    return {textured_box(), colored_ball(), concave_polygon(), rigged_model(), wired_box()};
}

} // namespace trivar::testing
