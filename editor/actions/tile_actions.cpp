// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/actions/tile_actions.h"

#include "core/commands/tiles/mix_tiles.h"
#include "core/commands/tiles/tiles.h"
#include "editor/actions/menu.h"
#include "editor/editor.h"
#include "editor/session/scene_facts.h"

#include <algorithm>

namespace trivar {
namespace {

bool layer_is_active(const Editor& e)
{
    return is_tile_layer(e.session.document(), e.session.selected);
}

void mix_tiles(Editor& e)
{
    const Id layer = e.session.selected;
    const Tiling& tiling = *object(e.session.document(), layer).tiles;
    MixTiles mixed{layer, tiling.weight, tiling.others};
    for (const Id id : e.session.selected.but_the_active())
        if (std::ranges::find(mixed.others, id, &MixedTile::object) == mixed.others.end())
            mixed.others.push_back({id, 1});
    if (e.session.run(mixed)) e.session.selected = layer;
}

void morph_tiles(Editor& e)
{
    const Id layer = e.session.selected;
    if (e.session.run(MorphTiles{layer, e.session.selected.but_the_active().front()}))
        e.session.selected = layer;
}

} // namespace

void add_tile_actions(std::vector<Action>& actions)
{
    const Menu tools(actions, "Tools");
    tools("Mix tiles", {}, mix_tiles,
          {[](const Editor& e) { return e.session.selected.size() > 1 && layer_is_active(e); },
           "select the objects first, and the layer of tiles last"});
    tools("Morph tiles", {}, morph_tiles,
          {[](const Editor& e) { return e.session.selected.size() == 2 && layer_is_active(e); },
           "select another object first, and the layer of tiles last"});
    tools("Clear tiles", {}, [](Editor& e) { e.session.run(ClearTiles{{e.session.selected}}); },
          {[](const Editor& e) { return layer_is_active(e); }, "select a layer of tiles first"});
}

} // namespace trivar
