// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/document/bases.h"

namespace trivar {

std::vector<Id> bases_of(const Object& object)
{
    std::vector<Id> out;
    if (object.stroke) out = object.stroke->onto;
    if (object.tiles && object.tiles->base != 0) out.push_back(object.tiles->base);
    return out;
}

Object with_bases(Object object, const std::function<Id(Id)>& other)
{
    if (object.tiles && object.tiles->base != 0) object.tiles->base = other(object.tiles->base);
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
