// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/files/formats.h"
#include "core/mesh/primitives.h"

namespace trivar::testing {

inline Image checker_image()
{
    Image image;
    image.name = "checker";
    image.size_px = {4, 2};
    for (int i = 0; i < 8; ++i) {
        const auto value = static_cast<std::uint8_t>(30 * i);
        image.rgba.insert(image.rgba.end(), {value, 100, 200, 255});
    }
    return image;
}

// A box of six groups and two materials, one textured.
inline Model box_model()
{
    Mesh mesh = box_mesh({1, 2, 3}, {1, 2, 1});
    mesh.face_material.assign(mesh.face_count(), 0);
    mesh.face_material.back() = 1;
    for (std::size_t f = 0; f < mesh.face_count(); ++f)
        mesh.face_group.push_back(f < mesh.face_count() / 2 ? 0 : 1);
    mesh.group_names = {"first", "second"};
    Material red, blue;
    red.name = "red";
    red.base_color = {0.8f, 0.1f, 0.1f, 1};
    red.roughness = 0.25f;
    red.base_color_texture.image = make_ref(checker_image());
    blue.name = "blue";
    blue.base_color = {0.1f, 0.1f, 0.8f, 0.5f};
    blue.metallic = 1;
    blue.alpha = Material::Alpha::blend;
    return single_mesh_model("box", std::move(mesh), {red, blue});
}

inline std::string bytes_of(const Model& model, const std::string& extension)
{
    if (extension == ".obj") return write_obj(model, "model").obj;
    if (extension == ".ply") return write_ply(model);
    if (extension == ".stl") return write_stl(model);
    if (extension == ".off") return write_off(model);
    return write_glb(model);
}

} // namespace trivar::testing
