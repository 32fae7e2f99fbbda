// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/actions/placement_actions.h"

#include "editor/actions/menu.h"
#include "editor/editor.h"
#include "editor/files/kept_shapes.h"
#include "editor/files/plain_mesh.h"
#include "editor/tools/place/place_round.h"
#include "editor/tools/tiles/cover.h"

namespace trivar {
namespace {

Action asks_for_plain_mesh(const char* name, bool in_place)
{
    return {"Edit",
            name,
            {},
            [in_place](Editor& e) {
                e.memory.of<PlainMeshDialog>() = {true, usual_plain_mesh(e.session, in_place)};
            },
            {[](const Editor& e) { return laid_shape(e.session) != 0 && keeps_shapes(e.session); },
             "select a placed object first, in a scene that is kept on disk"}};
}

} // namespace

void add_placement_actions(std::vector<Action>& actions)
{
    const Menu add(actions, "Add");
    add(
        place_round_action, {}, [](Editor& e) { lay_round(e.session, *round_wish(e.session)); },
        {[](const Editor& e) {
             return !e.session.committing() && round_wish(e.session).has_value();
         },
         "select a model, and then the body that it goes round"},
        true);
    add(
        cover_action, {}, [](Editor& e) { e.session.run(*cover_wish(e.session)); },
        {[](const Editor& e) { return cover_wish(e.session).has_value(); },
         "select a tile, and then the object that it covers"},
        true);
    actions.push_back(asks_for_plain_mesh(plain_copy_action, false));
    actions.push_back(asks_for_plain_mesh(apply_shape_action, true));
}

} // namespace trivar
