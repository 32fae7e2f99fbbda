// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/session/scene_facts.h"

#include "core/commands/keying.h"

#include <algorithm>

namespace trivar {

bool belongs_to(const Document& document, Id id, Id group)
{
    while (id != group && id != 0) {
        const auto found = document.objects.find(id);
        id = found == document.objects.end() ? 0 : found->second->parent;
    }
    return id == group;
}

std::vector<Id> travelling(const Document& document)
{
    std::vector<Id> ids = in_row_order(document);
    std::erase_if(ids, [&](Id id) {
        const Object& each = object(document, id);
        return !each.stroke || each.travel.speed == 0;
    });
    return ids;
}

bool moves_in_time(const Document& document)
{
    return !travelling(document).empty() || !animated_ids(document).empty() ||
           std::ranges::any_of(document.objects,
                               [](const auto& o) { return !o.second->playing.clip.empty(); });
}

bool is_tile_layer(const Document& document, Id id)
{
    const auto found = document.objects.find(id);
    return found != document.objects.end() && found->second->tiles;
}

bool lays_tiles(TileBrush brush)
{
    return brush == TileBrush::scatter || brush == TileBrush::line || brush == TileBrush::fill ||
           brush == TileBrush::strand;
}

bool has_tiles(const Document& document)
{
    return std::ranges::any_of(document.objects,
                               [](const auto& o) { return o.second->tiles.has_value(); });
}

std::string name_of(const Document& document, Id id)
{
    const auto found = document.objects.find(id);
    return found == document.objects.end() ? std::string() : found->second->name;
}

} // namespace trivar
