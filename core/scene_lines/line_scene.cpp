// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/scene_lines/line_scene.h"

#include "core/document/drawn_lines.h"
#include "core/drawing/line_list.h"
#include "core/stages/shown_volume.h"

#include <algorithm>

namespace trivar {
namespace {

bool shows_lines(const EvaluatedObject& effects)
{
    return effects.shape && effects.shape->volume &&
           std::ranges::any_of(effects.shape->volume->levels, &ShownVolume::Level::lines);
}

} // namespace

bool LineScene::is_simple() const
{
    std::size_t surfaces = 0;
    bool lines = false, simple = true;
    for (const Object& object : objects) {
        const std::vector<Part>& parts = object.effects->parts;
        if (!parts.empty() && (!object.drawing || object.drawing->surface)) ++surfaces;
        if (!object.has_lines()) continue;
        lines = true;
        if (object.drawing)
            simple &= !object.drawing->intersections &&
                      std::ranges::none_of(parts, &Part::drawn_from_tiles);
        if (!object.volume_to_world) continue;
        const ShownVolume& volume = *object.effects->shape->volume;
        simple &= !volume.certifies() &&
                  std::ranges::none_of(volume.levels, [&](const ShownVolume::Level& level) {
                      return level.lines && shows_others(volume, level.surface);
                  });
    }
    return !lines || (simple && (surfaces == 0 || objects.size() == 1));
}

bool shows_others(const ShownVolume& volume, int surface)
{
    return std::ranges::any_of(volume.levels, [&](const ShownVolume::Level& level) {
        return level.surface >= 0 && level.surface != surface;
    });
}

LineScene line_scene(const Evaluation& evaluated, const Document& document, const Camera& camera,
                     std::span<const Id> hidden_here)
{
    LineScene out{{}, camera};
    bool any = false;
    for (const auto& [id, ref] : evaluated.objects) {
        LineScene::Object object{ref};
        if (const auto own = document.objects.find(id); own != document.objects.end()) {
            object.drawing = drawn_lines(*own->second);
            if (!own->second->stroke && shows_lines(*ref))
                object.volume_to_world = to_world(document, id);
        }
        any |= object.has_lines();
        out.objects.push_back(std::move(object));
    }
    if (!any) return {{}, camera};
    std::vector<std::string> names;
    for (const LineScene::Object& object : out.objects) {
        const auto own = document.objects.find(object.effects->id); // none: deleted since
        names.push_back(own != document.objects.end() ? own->second->name : std::string());
    }
    names = names_apart(std::move(names));
    for (std::size_t i = 0; i < names.size(); ++i) out.objects[i].name = names[i];
    std::erase_if(out.objects, [&](const LineScene::Object& object) {
        return std::ranges::binary_search(hidden_here, object.effects->id);
    });
    return out;
}

} // namespace trivar
