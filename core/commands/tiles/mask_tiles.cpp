// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/commands/tiles/mask_tiles.h"

#include "core/base/rejected.h"
#include "core/commands/edits/edits.h"
#include "core/commands/edits/entry_tracks.h"
#include "core/commands/words/field_words.h"

#include <algorithm>
#include <fmt/format.h>

namespace trivar {
namespace {

std::size_t mask_index(const Document& document, Id id, int number)
{
    return entry_index(document, id, tiling_of(document, id).masks.size(), number, "masks");
}

std::string drives_word(const TileMask& mask)
{
    return std::string(choice_names<MaskDrives>[static_cast<std::size_t>(mask.drives)]);
}

} // namespace

void check_mask(const Document& document, Id layer, const TileMask& mask)
{
    if (mask.from == MaskFrom::image && mask.image.empty())
        throw Rejected("field \"image\" names no picture");
    if (mask.from != MaskFrom::curve || mask.curve == 0) return;
    const Object& other = object(document, mask.curve);
    if (mask.curve == layer) throw Rejected("field \"curve\": the tiles are no curve");
    if (!other.stroke && !kind_of(other).has_curves)
        throw Rejected(named(mask.curve, other) +
                       " has no curve; choose an object that lies on a stroke, or one with lines");
    if (depending_on(document, {layer}).contains(mask.curve))
        throw Rejected(fmt::format("field \"curve\": the shape of {} depends on {} already",
                                   named(mask.curve, other), named(document, layer)));
}

Document applied(Document document, const MaskTiles& command)
{
    const Tiling& tiling = tiling_of(document, command.object);
    check_mask(document, command.object, command.mask);
    if (command.number == 0 && tiling.masks.size() >= most_masks)
        throw Rejected(fmt::format("{} has {} masks already; at most {} are taken",
                                   named(document, command.object), tiling.masks.size(),
                                   most_masks));
    const std::size_t index = command.number == 0
                                  ? tiling.masks.size()
                                  : mask_index(document, command.object, command.number);
    return with_changed(std::move(document), command.object, [&](Object& o) {
        o.tiles->masks.resize(std::max(o.tiles->masks.size(), index + 1));
        o.tiles->masks[index] = command.mask;
    });
}

StepTitle title(const MaskTiles& c, const StepDocuments& step)
{
    const std::string of = names_in(step.before, {c.object}), drives = drives_word(c.mask);
    if (c.number == 0) return {fmt::format("Mask the {} of {}", drives, of), {}};
    return {fmt::format("Change mask {} of {}", c.number, of), drives};
}

Document applied(Document document, const RemoveTileMasks& command)
{
    const Tiling& tiling = tiling_of(document, command.object);
    std::vector<char> gone(tiling.masks.size(), command.numbers.empty() ? 1 : 0);
    for (const int number : command.numbers) gone[mask_index(document, command.object, number)] = 1;
    return with_changed(std::move(document), command.object, [&](Object& o) {
        std::vector<TileMask> rest;
        for (std::size_t i = 0; i < gone.size(); ++i)
            if (gone[i] == 0) rest.push_back(o.tiles->masks[i]);
        o.tiles->masks = std::move(rest);
        o.tracks = without_entries(o.tracks, "tiles.masks.", gone);
    });
}

StepTitle title(const RemoveTileMasks& c, const StepDocuments& step)
{
    const std::string of = names_in(step.before, {c.object});
    if (c.numbers.empty()) return {"Remove all masks of " + of, {}};
    if (c.numbers.size() == 1)
        return {fmt::format("Remove mask {} of {}", c.numbers.front(), of), {}};
    return {fmt::format("Remove {} masks of {}", c.numbers.size(), of), {}};
}

} // namespace trivar
