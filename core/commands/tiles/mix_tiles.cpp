// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/commands/tiles/mix_tiles.h"

#include "core/base/rejected.h"
#include "core/commands/edits/edits.h"
#include "core/commands/words/field_words.h"

#include <algorithm>
#include <fmt/format.h>

namespace trivar {
namespace {

// Throws Rejected where an object cannot be among the tiles of a layer, nor be what they become.
void check_can_be_tile_of(const Document& document, Id layer, Id id, std::string_view field)
{
    const Object& other = object(document, id);
    if (id == layer)
        throw Rejected(
            fmt::format("field \"{}\": {} is the layer itself", field, named(id, other)));
    if (!kind_of(other).has_surface)
        throw Rejected(named(id, other) + " has no shape of its own; choose an object that has");
    if (other.stroke)
        throw Rejected(named(id, other) +
                       " lies on a stroke; remove it from the stroke first, or choose a copy");
    if (other.tiles)
        throw Rejected(named(id, other) + " is a layer of tiles itself; choose a copy of its tile");
    if (depending_on(document, {layer}).contains(id))
        throw Rejected(fmt::format("field \"{}\": the shape of {} depends on {} already", field,
                                   named(id, other), named(document, layer)));
}

Document with_hidden(Document document, Id id)
{
    return with_changed(std::move(document), id, [](Object& other) { other.hidden = true; });
}

} // namespace

Document with_mix(Document document, Id layer, double weight, std::vector<MixedTile> others)
{
    tiling_of(document, layer);
    if (others.size() > most_mixed)
        throw Rejected(fmt::format("{} would be mixed with {} objects; at most {} are taken",
                                   named(document, layer), others.size(), most_mixed));
    for (auto each = others.begin(); each != others.end(); ++each) {
        check_can_be_tile_of(document, layer, each->object, "others");
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
    tiling_of(before, command.object);
    auto [with_files, layer, others] =
        with_tile_files(std::move(document), command.object, command.others, command.files);
    document = with_mix(std::move(with_files), layer, command.weight, others);
    const std::vector<MixedTile>& mixed = tiling_of(before, layer).others;
    for (const MixedTile& each : others)
        if (std::ranges::find(mixed, each.object, &MixedTile::object) == mixed.end())
            document = with_hidden(std::move(document), each.object);
    return document;
}

StepTitle title(const MixTiles& c, const StepDocuments& step)
{
    const std::string of = names_in(step.before, {c.object});
    if (c.others.empty() && c.files.empty()) return {"Do not mix the tiles of " + of, {}};
    std::vector<Id> others;
    for (const MixedTile& each : c.others) others.push_back(each.object);
    for (std::size_t i = 0; i < c.files.size(); ++i)
        others.push_back(step.before.next_id + static_cast<Id>(i));
    return {"Mix the tiles of " + of, "with " + names_in(step.after, others)};
}

Document with_morph(Document document, Id layer, Id into)
{
    tiling_of(document, layer);
    if (into != 0) check_can_be_tile_of(document, layer, into, "into");
    return with_changed(std::move(document), layer, [&](Object& o) { o.tiles->into = into; });
}

Document applied(Document document, const MorphTiles& command)
{
    document = with_morph(std::move(document), command.object, command.into);
    return command.into == 0 ? document : with_hidden(std::move(document), command.into);
}

StepTitle title(const MorphTiles& c, const StepDocuments& step)
{
    const std::string of = names_in(step.before, {c.object});
    if (c.into == 0) return {"Let the tiles of " + of + " stay what they are", {}};
    return {"Let the tiles of " + of, "become " + names_in(step.before, {c.into})};
}

} // namespace trivar
