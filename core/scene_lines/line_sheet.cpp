// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/scene_lines/line_sheet.h"

#include <fmt/format.h>

namespace trivar {
namespace {

std::string full_name(const std::string& of, const std::string& layer)
{
    return fmt::format("{}: {}", of, layer);
}

} // namespace

std::vector<DrawingLayer> drawing_layers(const SceneLines& lines, bool named)
{
    std::vector<DrawingLayer> out;
    for (const Ref<ObjectLines>& object : lines.objects)
        for (const ObjectLines::Layer& layer : object->layers) {
            if (named && layer.drawing.lines.empty()) continue;
            out.push_back(layer.drawing);
            if (named) out.back().name = full_name(object->name, layer.drawing.name);
        }
    return out;
}

LineSheet line_sheet(const Evaluation& evaluated, const Document& document, const Camera& camera,
                     const HandEdits& edits, const Progress& progress)
{
    EditedLineIds known(edits);
    LineOptions options;
    options.ids = [&](const std::string& object, const std::string& layer) -> LineIds& {
        return known(full_name(object, layer));
    };
    options.progress = progress;
    SceneLines lines = LineDrawer()(line_scene(evaluated, document, camera), options);
    LineSheet out;
    out.sheet.layers = drawing_layers(lines);
    out.sheet.size = camera.size_px;
    if (document.render->look == "black") out.sheet.paper = glm::vec3(0);
    out.notices = std::move(lines.notices);
    return out;
}

} // namespace trivar
