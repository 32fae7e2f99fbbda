// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/picture.h"

#include "ui/camera_control.h"

namespace trivar {

gpu::Picture picture_of(const Evaluated& evaluated, const Document& document, const Camera& camera)
{
    gpu::Picture picture;
    picture.camera = camera;
    picture.settings = *document.render;
    for (const auto& [id, ref] : evaluated.objects)
        for (const Part& part : ref->parts) {
            gpu::Instance instance;
            instance.mesh = part.mesh;
            instance.to_world = part.to_world;
            instance.materials = ref->materials;
            instance.id = id;
            picture.instances.push_back(std::move(instance));
        }
    return picture;
}

Camera picture_camera(const Evaluated& evaluated, const Document& document, glm::ivec2 size_px)
{
    const auto bookmark = document.bookmarks.find("picture");
    if (bookmark != document.bookmarks.end()) return ui::reshaped(bookmark->second, size_px);
    Camera camera;
    camera.size_px = size_px;
    Box all;
    for (const auto& [id, ref] : evaluated.objects) all.add(ref->bounds);
    return ui::framed(ui::seen_from(camera, glm::normalize(glm::dvec3(0.45, -1, 0.55))), all);
}

} // namespace trivar
