// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/document/bases.h"

namespace trivar {

std::vector<BaseUse> bases_of(const Object& object)
{
    std::vector<BaseUse> out;
    const auto add = [&](Id base, std::string_view words) {
        if (base != 0) out.push_back({base, words});
    };
    if (object.stroke)
        for (const Id on : object.stroke->onto) add(on, lies_on_words);
    if (object.splitting)
        for (const ObstacleUse& each : object.splitting->obstacles) add(each.object, "split by");
    if (object.incising)
        for (const NamedIncision& each : object.incising->cuts) add(each.blade, "opened by");
    if (!object.tiles) return out;
    add(object.tiles->base, "painted on");
    for (const MixedTile& each : object.tiles->others) add(each.object, "mixed with");
    add(object.tiles->into, "turned into");
    for (const TileMask& each : object.tiles->masks) add(each.curve, "masked by");
    return out;
}

Object with_bases(Object object, const std::function<Id(Id)>& other)
{
    if (object.tiles) {
        if (object.tiles->base != 0) object.tiles->base = other(object.tiles->base);
        std::vector<MixedTile>& others = object.tiles->others;
        for (MixedTile& each : others) each.object = other(each.object);
        std::erase_if(others, [](const MixedTile& each) { return each.object == 0; });
        if (object.tiles->into != 0) object.tiles->into = other(object.tiles->into);
        for (TileMask& each : object.tiles->masks)
            if (each.curve != 0) each.curve = other(each.curve);
    }
    if (object.splitting) {
        std::vector<ObstacleUse>& obstacles = object.splitting->obstacles;
        for (ObstacleUse& each : obstacles) each.object = other(each.object);
        std::erase_if(obstacles, [](const ObstacleUse& each) { return each.object == 0; });
        if (obstacles.empty()) object.splitting.reset();
    }
    if (object.incising)
        for (NamedIncision& each : object.incising->cuts)
            if (each.blade != 0) each.blade = other(each.blade);
    if (!object.stroke) return object;
    std::vector<Id>& onto = object.stroke->onto;
    for (Id& id : onto) id = other(id);
    std::erase(onto, 0);
    if (object.stroke->attach)
        object.stroke->attach = renumbered(*object.stroke->attach, [&](Id id) -> std::optional<Id> {
            const Id now = other(id);
            if (now == 0) return {};
            return now;
        });
    return object;
}

} // namespace trivar
