// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/commands/mix_tiles.h"

#include "core/base/rejected.h"
#include "core/commands/edits.h"
#include "core/commands/field_words.h"

#include <algorithm>
#include <fmt/format.h>

namespace trivar {
namespace {

void check_can_be_mixed(const Document& document, Id layer, Id id)
{
    const Object& other = object(document, id);
    if (id == layer)
        throw Rejected("field \"others\": " + named(id, other) +
                       " is the layer itself, whose share is its weight");
    if (holds_others(other.source))
        throw Rejected(named(id, other) + " has no shape of its own; mix with an object that has");
    if (other.stroke)
        throw Rejected(named(id, other) +
                       " lies on a stroke; remove it from the stroke first, or mix with a copy");
    if (other.tiles)
        throw Rejected(named(id, other) +
                       " is a layer of tiles itself; mix with a copy of its tile");
    if (depending_on(document, {layer}).contains(id))
        throw Rejected(fmt::format("field \"others\": the shape of {} depends on {} already",
                                   named(id, other), named(document, layer)));
}

} // namespace

Document with_mix(Document document, Id layer, double weight, std::vector<MixedTile> others)
{
    if (!object(document, layer).tiles)
        throw Rejected(named(document, layer) + " is no layer of tiles; paint with it first");
    if (others.size() > most_mixed)
        throw Rejected(fmt::format("{} would be mixed with {} objects; at most {} are taken",
                                   named(document, layer), others.size(), most_mixed));
    for (auto each = others.begin(); each != others.end(); ++each) {
        check_can_be_mixed(document, layer, each->object);
        if (std::find_if(others.begin(), each, [&](const MixedTile& before) {
                return before.object == each->object;
            }) != each)
            throw Rejected("field \"others\" names " + named(document, each->object) + " twice");
    }
    return with_changed(std::move(document), layer, [&](Object& o) {
        o.tiles->weight = weight;
        o.tiles->others = std::move(others);
    });
}

Document applied(Document document, const MixTiles& command)
{
    const Document before = document;
    document = with_mix(std::move(document), command.object, command.weight, command.others);
    const std::vector<MixedTile>& mixed = object(before, command.object).tiles->others;
    for (const MixedTile& each : command.others)
        if (std::ranges::find(mixed, each.object, &MixedTile::object) == mixed.end())
            document = with_changed(std::move(document), each.object,
                                    [](Object& other) { other.hidden = true; });
    return document;
}

StepTitle title(const MixTiles& c, const StepDocuments& step)
{
    const std::string of = names_in(step.before, {c.object});
    if (c.others.empty()) return {"Do not mix the tiles of " + of, {}};
    std::vector<Id> others;
    for (const MixedTile& each : c.others) others.push_back(each.object);
    return {"Mix the tiles of " + of, "with " + names_in(step.before, others)};
}

} // namespace trivar
