// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/picture/line_sheet.h"

#include "core/document/drawn_lines.h"
#include "core/drawing/line_list.h"
#include "core/stages/shown_volume.h"
#include "editor/picture/object_lines.h"

#include <fmt/format.h>

namespace trivar {
namespace {

std::string full_name(const std::string& of, const std::string& layer)
{
    return fmt::format("{}: {}", of, layer);
}

void add_layers(DrawingSheet& sheet, const std::string& of, std::vector<DrawingLayer> layers)
{
    for (DrawingLayer& layer : layers) {
        if (layer.lines.empty()) continue;
        layer.name = full_name(of, layer.name);
        sheet.layers.push_back(std::move(layer));
    }
}

std::vector<DrawingLayer> volume_layers(const std::string& of, const ShownVolume& volume,
                                        const glm::dmat4& to_world, const Camera& camera,
                                        EditedLineIds& ids)
{
    const VoxelField& field = *volume.field;
    const DrawingView view = drawing_view(camera, to_world * volume.to_model, field.field().size());
    std::vector<DrawnLevel> levels = volume.drawn_levels();
    std::vector<std::string> names;
    for (const DrawnLevel& level : levels) names.push_back(level.name);
    names = names_apart(std::move(names));
    for (std::size_t i = 0; i < levels.size(); ++i) levels[i].name = names[i];
    const auto ids_of = [&](const std::string& layer) -> LineIds& {
        return ids(full_name(of, layer));
    };
    return draw_levels(field.field(), field.hulls(), levels, view, {.ids = ids_of}).layers;
}

} // namespace

DrawingSheet line_sheet(const Evaluation& evaluated, const Document& document, const Camera& camera,
                        const HandEdits& edits)
{
    DrawingSheet out;
    out.size = camera.size_px;
    if (document.render->look == "black") out.paper = glm::vec3(0);
    ObjectLines object_lines;
    EditedLineIds ids(edits);
    std::vector<std::string> names; // of objects, in their order
    for (const auto& [id, ref] : evaluated.objects)
        if (const auto found = document.objects.find(id); found != document.objects.end())
            names.push_back(found->second->name);
    names = names_apart(std::move(names));
    auto name = names.begin();
    for (const auto& [id, ref] : evaluated.objects) {
        const auto found = document.objects.find(id);
        if (found == document.objects.end()) continue;
        const Object& own = *found->second;
        const std::string& of = *name++;
        if (const std::optional<LineDrawing> drawing = drawn_lines(own))
            add_layers(out, of, object_lines.layers(*ref, *drawing, camera));
        if (ref->shape && ref->shape->volume && !own.stroke)
            add_layers(out, of,
                       volume_layers(of, *ref->shape->volume, to_world(document, id), camera, ids));
    }
    return out;
}

} // namespace trivar
