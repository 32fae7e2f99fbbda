// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/actions/surface_actions.h"

#include "core/commands/objects/shade.h"
#include "core/commands/objects/unwrap.h"
#include "editor/actions/menu.h"
#include "editor/editor.h"

namespace trivar {
namespace {

// Returns the selected objects that have a surface and are `wanted`.
std::vector<Id> selected_surfaces(const Editor& e, const auto& wanted)
{
    std::vector<Id> out;
    for (const Id id : e.session.selected.ids()) {
        const Object& each = object(e.session.document(), id);
        if (kind_of(each).has_surface && wanted(each)) out.push_back(id);
    }
    return out;
}

std::vector<Id> to_unwrap(const Editor& e)
{
    return selected_surfaces(e, [](const Object& o) { return !o.unwrapping; });
}

std::vector<Id> unwrapped(const Editor& e)
{
    return selected_surfaces(e, [](const Object& o) { return o.unwrapping.has_value(); });
}

std::vector<Id> to_shade(const Editor& e, ShadingWay way)
{
    return selected_surfaces(
        e, [&](const Object& o) { return o.shading.value_or(FaceShading{}).way != way; });
}

} // namespace

void add_surface_actions(std::vector<Action>& actions)
{
    const Menu surface(actions, "Surface");
    for (const auto& [name, way] : {std::pair("Shade smooth", ShadingWay::smooth),
                                    {"Shade by angle", ShadingWay::by_angle},
                                    {"Shade flat", ShadingWay::flat},
                                    {"Clear shading", ShadingWay::own}})
        surface(name, {},
                [way = way](Editor& e) {
                    e.session.run(Shade{to_shade(e, way), {way}});
                },
                {[way = way](const Editor& e) { return !to_shade(e, way).empty(); },
                 "select an object with a surface that is not shaded so yet"});
    surface("Unwrap", {},
            [](Editor& e) {
                e.session.run(Unwrap{to_unwrap(e), {}});
            },
            {[](const Editor& e) { return !to_unwrap(e).empty(); },
             "select an object with a surface that is not unwrapped yet"});
    surface("Clear unwrap", {}, [](Editor& e) { e.session.run(ClearUnwrap{unwrapped(e)}); },
            {[](const Editor& e) { return !unwrapped(e).empty(); },
             "select an unwrapped object first"});
}

} // namespace trivar
