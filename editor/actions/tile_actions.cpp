// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/actions/tile_actions.h"

#include "core/commands/mix_tiles.h"
#include "core/commands/tiles.h"
#include "editor/editor.h"

#include <algorithm>

namespace trivar {
namespace {

bool is_layer(const Editor& e, Id id)
{
    const auto found = e.session.document().objects.find(id);
    return found != e.session.document().objects.end() && found->second->tiles;
}

std::vector<Id> beside_the_layer(const Editor& e)
{
    std::vector<Id> ids = e.session.selected.ids();
    ids.pop_back();
    return ids;
}

void mix_tiles(Editor& e)
{
    const Id layer = e.session.selected;
    const Tiling& tiling = *object(e.session.document(), layer).tiles;
    MixTiles mixed{layer, tiling.weight, tiling.others};
    for (const Id id : beside_the_layer(e))
        if (std::ranges::find(mixed.others, id, &MixedTile::object) == mixed.others.end())
            mixed.others.push_back({id, 1});
    if (e.session.run(mixed)) e.session.selected = layer;
}

void morph_tiles(Editor& e)
{
    const Id layer = e.session.selected;
    if (e.session.run(MorphTiles{layer, beside_the_layer(e).front()})) e.session.selected = layer;
}

} // namespace

void add_tile_actions(std::vector<Action>& actions)
{
    actions.push_back({"Tools",
                       "Mix tiles",
                       {},
                       mix_tiles,
                       {[](const Editor& e) {
                            return e.session.selected.size() > 1 && is_layer(e, e.session.selected);
                        },
                        "select the objects first, and the layer of tiles last"}});
    actions.push_back({"Tools",
                       "Morph tiles",
                       {},
                       morph_tiles,
                       {[](const Editor& e) {
                            return e.session.selected.size() == 2 &&
                                   is_layer(e, e.session.selected);
                        },
                        "select another object first, and the layer of tiles last"}});
    actions.push_back({"Tools",
                       "Clear tiles",
                       {},
                       [](Editor& e) { e.session.run(ClearTiles{{e.session.selected}}); },
                       {[](const Editor& e) { return is_layer(e, e.session.selected); },
                        "select a layer of tiles first"}});
}

} // namespace trivar
