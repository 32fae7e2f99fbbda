// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/picture/line_sheet.h"

#include "core/document/drawn_lines.h"
#include "core/evaluation/shown_volume.h"
#include "editor/picture/object_lines.h"

#include <fmt/format.h>

namespace trivar {
namespace {

void add_layers(DrawingSheet& sheet, const std::string& of, std::vector<DrawingLayer> layers)
{
    for (DrawingLayer& layer : layers) {
        if (layer.lines.empty()) continue;
        layer.name = fmt::format("{}: {}", of, layer.name);
        sheet.layers.push_back(std::move(layer));
    }
}

std::vector<DrawingLayer> volume_layers(const ShownVolume& volume, const glm::dmat4& to_world,
                                        const Camera& camera)
{
    const VoxelField& field = *volume.field;
    const DrawingView view = drawing_view(camera, to_world * volume.to_model, field.field().size());
    return draw_levels(field.field(), field.hulls(), volume.drawn_levels(), view).layers;
}

} // namespace

DrawingSheet line_sheet(const Evaluation& evaluated, const Document& document, const Camera& camera)
{
    DrawingSheet out;
    out.size = camera.size_px;
    if (document.render->look == "black") out.paper = glm::vec3(0);
    ObjectLines object_lines;
    for (const auto& [id, ref] : evaluated.objects) {
        const auto found = document.objects.find(id);
        if (found == document.objects.end()) continue;
        const Object& own = *found->second;
        if (const std::optional<LineDrawing> drawing = drawn_lines(own))
            add_layers(out, own.name, object_lines.layers(*ref, *drawing, camera));
        if (ref->shape && ref->shape->volume && !own.stroke)
            add_layers(out, own.name,
                       volume_layers(*ref->shape->volume, to_world(document, id), camera));
    }
    return out;
}

} // namespace trivar
