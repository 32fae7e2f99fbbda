// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/scene_lines/line_sheet.h"

#include "core/base/rejected.h"
#include "core/files/file_bytes.h"

#include <filesystem>
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
    out.edits = apply(edits, out.sheet);
    out.notices = std::move(lines.notices);
    return out;
}

HandEdits edits_to_keep(const std::string& path)
{
    if (extension_of(path) != ".svg" || !std::filesystem::exists(path)) return {};
    try {
        return hand_edits_of(read_bytes(path, most_edited_bytes)).value_or(HandEdits{});
    } catch (const Rejected& rejected) {
        const std::string why = rejected.what(); // names the file where it cannot be read at all
        throw Rejected(fmt::format("{}{}; delete it first, or give another name",
                                   why.starts_with(path) ? "" : path + ": ", why));
    }
}

} // namespace trivar
