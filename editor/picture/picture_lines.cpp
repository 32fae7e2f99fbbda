// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/picture/picture_lines.h"

#include "editor/picture/ink_curves.h"

#include <algorithm>

namespace trivar {
namespace {

std::vector<gpu::Curve> curves_of(const SceneLines& lines, float wider)
{
    std::vector<gpu::Curve> out;
    for (const Ref<ObjectLines>& object : lines.objects)
        for (const ObjectLines::Layer& layer : object->layers)
            add_curves(out, layer.drawing.lines,
                       {layer.to_world, layer.to_image, object->object, wider,
                        static_cast<float>(layer.own_reach)});
    return out;
}

} // namespace

void PictureLines::give(LineScene scene, Ref<SceneLines> lines)
{
    given_of_ = std::move(scene);
    given_ = std::move(lines);
}

const std::vector<gpu::Curve>& PictureLines::operator()(const Evaluation& evaluated,
                                                        const Document& document,
                                                        const Camera& camera, float wider)
{
    LineScene scene = line_scene(evaluated, document, camera, hidden_here);
    const Ref<SceneLines> given = given_of_ == scene ? given_ : nullptr;
    if (effort == LineEffort::quick && !given)
        std::erase_if(scene.objects,
                      [](const LineScene::Object& object) { return !object.has_lines(); });
    return known_({scene, given}, [&] {
        return curves_of(given ? *given : drawer_(scene, {.effort = effort}), wider);
    });
}

void draw_on(std::vector<gpu::Instance>& instances, const LineDrawing& drawing)
{
    if (!drawing.surface) return instances.clear();
    if (!drawing.paper) return;
    for (gpu::Instance& instance : instances) {
        instance.materials = nullptr;
        instance.flat_color = drawing.paper_color;
    }
}

} // namespace trivar
