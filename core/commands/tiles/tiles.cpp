// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/commands/tiles/tiles.h"

#include "core/base/number_text.h"
#include "core/base/rejected.h"
#include "core/commands/edits/edits.h"
#include "core/commands/tiles/mix_tiles.h"
#include "core/commands/words/field_words.h"

#include <algorithm>
#include <fmt/format.h>

namespace trivar {
namespace {

std::size_t stroke_index(const Document& document, Id id, int number)
{
    return entry_index(document, id, tiling_of(document, id).strokes.size(), number, "strokes");
}

void check_can_be_tile(const Document& document, Id id, Id base)
{
    const Object& tile = object(document, id);
    if (!kind_of(tile).has_surface)
        throw Rejected(named(id, tile) + " has no shape of its own; paint with an object that has");
    if (tile.stroke)
        throw Rejected(named(id, tile) +
                       " lies on a stroke; remove it from the stroke first, or paint with a copy");
    if (!kind_of(document, base).has_surface)
        throw Rejected(named(document, base) + " has no surface; paint on an object that has one");
    if (id == base) throw Rejected("field \"base\": an object cannot be painted on itself");
    if (depending_on(document, {id}).contains(base))
        throw Rejected(fmt::format("field \"base\": the shape of {} depends on {} already",
                                   named(document, base), named(document, id)));
    if (tile.tiles && tile.tiles->base != 0 && tile.tiles->base != base)
        throw Rejected(fmt::format("{} is painted on {}; copy it to paint on something else too",
                                   named(id, tile), named(document, tile.tiles->base)));
}

// The document with more objects among the tiles of a layer.
Document mixed_with(Document document, Id layer, const std::vector<MixedTile>& more)
{
    if (more.empty()) return document;
    const Tiling& tiling = tiling_of(document, layer);
    MixTiles mix{layer, tiling.weight, tiling.others};
    mix.others.insert(mix.others.end(), more.begin(), more.end());
    return applied(std::move(document), mix);
}

// The least side of a unit cell, as a share of the tile's box.
constexpr double least_cell = 0.01;

void check_cell(std::string_view field, double from, double to)
{
    if (!(to - from >= least_cell))
        throw Rejected(fmt::format("field \"{}\" is {} but must be at least {}: the cell begins "
                                   "at {}",
                                   field, number_text(to), number_text(from + least_cell),
                                   number_text(from)));
}

// The name of a tile that may have come with the step.
std::string tile_name(Id id, const StepDocuments& step)
{
    return id == 0 ? step.made() : names_in(step.before, {id});
}

std::string_view verb_of(const TileStroke& stroke)
{
    switch (stroke.brush) {
    case TileBrush::scatter: return "Scatter";
    case TileBrush::line: return "Line up";
    case TileBrush::fill: return "Fill with";
    case TileBrush::erase: return "Erase";
    case TileBrush::comb: return "Comb";
    case TileBrush::resize: return "Resize";
    case TileBrush::raise: return "Raise";
    case TileBrush::grab: return stroke.samples.size() > 2 ? "Move tiles of" : "Move a tile of";
    case TileBrush::color: return "Colour";
    case TileBrush::morph: return "Morph";
    case TileBrush::adjust: {
        const bool one = stroke.samples.size() == 1;
        if (stroke.factor == 0) return one ? "Remove a tile of" : "Remove tiles of";
        if (stroke.factor == 1) return one ? "Turn a tile of" : "Turn tiles of";
        return one ? "Scale a tile of" : "Scale tiles of";
    }
    case TileBrush::strand: return "Lay a strand of";
    }
    return "Paint";
}

} // namespace

void check(const TileStroke& stroke)
{
    if (stroke.samples.empty()) throw Rejected("field \"samples\" is empty: the stroke is nowhere");
    if (stroke.samples.size() > most_tile_samples)
        throw Rejected(fmt::format("field \"samples\" has {} entries but at most {} are taken",
                                   with_commas(stroke.samples.size()),
                                   with_commas(most_tile_samples)));
    for (const TileSample& each : stroke.samples)
        if (const double length = glm::length(each.at.normal); !(std::abs(length - 1) < 0.01))
            throw Rejected(
                fmt::format("field \"normal\" has the length {} but must have the length 1",
                            number_text(length)));
}

Document with_tiling(Document document, Id id, Tiling tiling)
{
    check_can_be_tile(document, id, tiling.base);
    if (tiling.strokes.size() > most_tile_strokes)
        throw Rejected(fmt::format("{} would have {} strokes of tiles; at most {} are allowed",
                                   named(document, id), with_commas(tiling.strokes.size()),
                                   with_commas(most_tile_strokes)));
    return with_changed(std::move(document), id, [&](Object& o) { o.tiles = std::move(tiling); });
}

Document applied(Document document, const PaintTiles& command)
{
    check(command.stroke);
    auto [with_files, layer, others] =
        with_tile_files(std::move(document), command.object, command.others, command.files);
    Tiling fresh;
    fresh.look.overlap = command.overlap;
    Tiling tiling = object(with_files, layer).tiles.value_or(fresh);
    tiling.base = command.base;
    tiling.strokes.push_back(make_ref(command.stroke));
    return mixed_with(with_tiling(std::move(with_files), layer, std::move(tiling)), layer, others);
}

StepTitle title(const PaintTiles& c, const StepDocuments& step)
{
    return {fmt::format("{} {}", verb_of(c.stroke), tile_name(c.object, step)),
            "on " + names_in(step.before, {c.base})};
}

Document applied(Document document, const EditTileStroke& command)
{
    check(command.stroke);
    const std::size_t index = stroke_index(document, command.object, command.number);
    return with_changed(std::move(document), command.object,
                        [&](Object& o) { o.tiles->strokes[index] = make_ref(command.stroke); });
}

StepTitle title(const EditTileStroke& c, const StepDocuments& step)
{
    return {fmt::format("Change stroke {} of {}", c.number, names_in(step.before, {c.object})), {}};
}

Document applied(Document document, const RemoveTileStrokes& command)
{
    const Tiling& tiling = tiling_of(document, command.object);
    std::vector<char> gone(tiling.strokes.size(), command.numbers.empty() ? 1 : 0);
    for (const int number : command.numbers)
        gone[stroke_index(document, command.object, number)] = 1;
    return with_changed(std::move(document), command.object, [&](Object& o) {
        std::vector<Ref<TileStroke>> rest;
        for (std::size_t i = 0; i < gone.size(); ++i)
            if (!gone[i]) rest.push_back(o.tiles->strokes[i]);
        o.tiles->strokes = std::move(rest);
    });
}

StepTitle title(const RemoveTileStrokes& c, const StepDocuments& step)
{
    const std::string of = names_in(step.before, {c.object});
    if (c.numbers.empty()) return {"Remove all strokes of " + of, {}};
    if (c.numbers.size() == 1)
        return {fmt::format("Remove stroke {} of {}", c.numbers.front(), of), {}};
    return {fmt::format("Remove {} strokes of {}", c.numbers.size(), of), {}};
}

Document applied(Document document, const SetTiles& command)
{
    check_cell("cell_x1", command.look.cell_x0, command.look.cell_x1);
    check_cell("cell_y1", command.look.cell_y0, command.look.cell_y1);
    for (const Id id : distinct(document, command.objects)) tiling_of(document, id);
    return with_all_changed(std::move(document), command.objects,
                            [&](Object& o) { o.tiles->look = command.look; });
}

StepTitle title(const SetTiles& c, const StepDocuments& step)
{
    return {"Tiles of " + names_in(step.before, c.objects), {}};
}

Document applied(Document document, const ClearTiles& command)
{
    for (const Id id : distinct(document, command.objects)) tiling_of(document, id);
    return with_all_changed(std::move(document), command.objects,
                            [](Object& o) { o.tiles.reset(); });
}

Document applied(Document document, const CoverWithTiles& command)
{
    auto [with_files, layer, others] =
        with_tile_files(std::move(document), command.object, command.others, command.files);
    const std::optional<Tiling>& before = object(with_files, layer).tiles;
    if (command.cover.pattern == TilePattern::none && !before)
        throw Rejected(named(with_files, layer) +
                       " is no layer of tiles; choose a pattern to cover with");
    Tiling tiling = before.value_or(Tiling{});
    tiling.base = command.base;
    tiling.cover = command.cover;
    return mixed_with(with_tiling(std::move(with_files), layer, std::move(tiling)), layer, others);
}

StepTitle title(const CoverWithTiles& c, const StepDocuments& step)
{
    const std::string tile = tile_name(c.object, step), base = names_in(step.before, {c.base});
    if (c.cover.pattern == TilePattern::none) return {"Uncover " + base, "from " + tile};
    const auto found = step.before.objects.find(c.object);
    const bool covered = found != step.before.objects.end() && found->second->tiles &&
                         found->second->tiles->cover.pattern != TilePattern::none;
    if (covered) return {"Change the cover of " + base, "by " + tile};
    return {"Cover " + base, "with " + tile};
}

} // namespace trivar
