// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/actions/selection_actions.h"

#include "core/commands/objects/arrange.h"
#include "editor/actions/menu.h"
#include "editor/editor.h"
#include "editor/hands/parts_tool.h"
#include "editor/hands/select.h"
#include "editor/session/scene_facts.h"

#include <algorithm>
#include <functional>

namespace trivar {
namespace {

std::vector<Id> objects_that(const Editor& e, const std::function<bool(Id)>& fits)
{
    std::vector<Id> ids;
    for (const auto& [id, each] : e.session.document().objects)
        if (fits(id)) ids.push_back(id);
    return ids;
}

// Whether a click could select the object.
bool in_reach(const Session& session, Id id)
{
    const Document& document = session.document();
    return visible(document, id) && !locked(document, id) &&
           !std::ranges::binary_search(session.hidden_here, id);
}

std::vector<Id> visible_ones(const Editor& e)
{
    return objects_that(e, [&](Id id) { return in_reach(e.session, id); });
}

// Neither among the selected ones, nor in them, nor round them.
std::vector<Id> others(const Editor& e)
{
    const Document& document = e.session.document();
    const std::vector<Id>& ids = e.session.selected.ids();
    const Members chosen(document, ids);
    return objects_that(e, [&](Id id) {
        if (!visible(document, id) || chosen.contain(id) ||
            std::ranges::binary_search(e.session.hidden_here, id))
            return false;
        for (const Id each : ids)
            if (belongs_to(document, each, id)) return false;
        return true;
    });
}

std::vector<Id> of_the_same_type(const Editor& e)
{
    const Document& document = e.session.document();
    const Object& active = object(document, e.session.selected);
    return objects_that(e, [&](Id id) {
        const Object& each = object(document, id);
        return in_reach(e.session, id) && each.source.index() == active.source.index() &&
               each.stroke.has_value() == active.stroke.has_value();
    });
}

// The active object stays the active one.
void select_keeping_active(Editor& e, const std::vector<Id>& ids)
{
    const Id active = e.session.selected;
    e.session.selected.set(ids);
    if (e.session.selected.contains(active)) e.session.selected.add({active});
}

// Shows only the selection, or everything again.
void isolate(Editor& e)
{
    std::vector<Id>& hidden_here = e.session.hidden_here;
    if (hidden_here.empty())
        hidden_here = others(e);
    else
        hidden_here.clear();
}

// Whether the tool at work has chosen among its parts: objects are not meant then.
bool choose_parts(Editor& e, PartChoice choice)
{
    return e.tool_parts() && e.tool_parts()->choose(e.session, choice);
}

} // namespace

void add_selection_actions(std::vector<Action>& a)
{
    const Menu select(a, "Select");
    select(
        "Select all", {{'A'}},
        [](Editor& e) {
            if (choose_parts(e, PartChoice::all)) return;
            select_keeping_active(e, visible_ones(e));
        },
        something_there());
    select(
        "Deselect all", {{.key = 'A', .alt = true}},
        [](Editor& e) {
            if (choose_parts(e, PartChoice::none)) return;
            e.session.selected = 0;
        },
        something_selected());
    select(
        "Invert selection", {{.key = 'I', .ctrl = true}},
        [](Editor& e) {
            if (choose_parts(e, PartChoice::others)) return;
            std::vector<Id> ids = topmost(e.session.document(), others(e));
            std::erase_if(ids, [&](Id id) { return locked(e.session.document(), id); });
            e.session.selected.set(ids);
        },
        something_there());
    select("Select more points", {{ui::key_keypad_plus}, {ui::key_equal}},
           [](Editor& e) { choose_parts(e, PartChoice::more); },
           {[](const Editor& e) { return e.tool_parts() && e.tool_parts()->proportional(); },
            "choose control points with the Lattice tool first"});
    select(
        "Select the same type", {{.key = 'G', .shift = true}},
        [](Editor& e) {
            if (choose_parts(e, PartChoice::same)) return;
            select_keeping_active(e, of_the_same_type(e));
        },
        something_selected());
    select(
        "Box select", {{'B'}},
        [](Editor& e) {
            e.choose_tool(0);
            static_cast<SelectTool&>(e.active_tool()).begin_box();
        },
        something_there());
    select(
        isolate_action, {{ui::key_slash}, {ui::key_keypad_divide}}, isolate,
        {[](const Editor& e) { return e.session.selected != 0 || !e.session.hidden_here.empty(); },
         "select an object first"},
        true);
    select(
        "Hide others", {{.key = 'H', .shift = true}},
        [](Editor& e) {
            if (const auto ids = topmost(e.session.document(), others(e)); !ids.empty())
                e.session.run(Hide{ids});
        },
        something_selected());
    select(
        "Show all", {{.key = 'H', .alt = true}},
        [](Editor& e) {
            const auto ids =
                objects_that(e, [&](Id id) { return object(e.session.document(), id).hidden; });
            if (!ids.empty()) e.session.run(Show{ids});
        },
        something_there());
}

} // namespace trivar
