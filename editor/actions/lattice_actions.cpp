// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/actions/lattice_actions.h"

#include "core/base/rejected.h"
#include "editor/actions/actions.h"
#include "editor/actions/menu.h"
#include "editor/editor.h"
#include "editor/files/kept_shapes.h"
#include "editor/hands/lattice_round.h"
#include "editor/hands/parts_tool.h"
#include "editor/session/scene_facts.h"
#include "editor/tools/tetrahedra/tetrahedra_round.h"

namespace trivar {

namespace {

// Whether neighbours go along with what the tool at work moves; null: it has no such switch.
bool* proportional_switch(const Editor& e)
{
    return e.tool_parts() ? e.tool_parts()->proportional() : nullptr;
}

// Returns the selected lattice, the active one first; 0: none.
Id selected_lattice(const Session& session)
{
    const Id active = session.selected;
    if (is_lattice(session.document(), active)) return active;
    for (const Id id : session.selected.ids())
        if (is_lattice(session.document(), id)) return id;
    return 0;
}

// Returns the selected objects beside a lattice that are not in it yet.
std::vector<Id> to_add(const Session& session, Id lattice)
{
    std::vector<Id> ids = session.selected.ids();
    std::erase_if(ids, [&](Id id) {
        return belongs_to(session.document(), id, lattice) ||
               belongs_to(session.document(), lattice, id);
    });
    return lattice == 0 ? std::vector<Id>{} : topmost(session.document(), ids);
}

// The innermost lattice that an object stands in; 0: none.
Id lattice_of(const Document& document, Id id)
{
    for (Id up = object(document, id).parent; up != 0; up = object(document, up).parent)
        if (is_lattice(document, up)) return up;
    return 0;
}

// Returns the selected objects that stand in the same lattice as the first of them that is in one.
std::vector<Id> to_take_out(const Session& session)
{
    const Document& document = session.document();
    std::vector<Id> ids = topmost(document, session.selected.ids());
    std::erase_if(ids, [&](Id id) { return lattice_of(document, id) == 0; });
    if (ids.empty()) return ids;
    const Id lattice = lattice_of(document, ids.front());
    std::erase_if(ids, [&](Id id) { return lattice_of(document, id) != lattice; });
    return ids;
}

void add_member_actions(std::vector<Action>& actions)
{
    const Menu menu(actions, "Lattice");
    menu(add_to_lattice_action, {},
         [](Editor& e) {
             const Id lattice = selected_lattice(e.session);
             const std::vector<Id> ids = to_add(e.session, lattice);
             if (e.session.run(Reorder{.objects = ids, .parent = lattice}))
                 e.session.selected = lattice;
         },
         {[](const Editor& e) { return !to_add(e.session, selected_lattice(e.session)).empty(); },
          "select a lattice and the objects that it should bend"});
    menu(take_out_of_lattice_action, {},
         [](Editor& e) {
             const std::vector<Id> ids = to_take_out(e.session);
             const Document& document = e.session.document();
             const Id lattice = lattice_of(document, ids.front());
             e.session.run(Reorder{.objects = ids, .parent = object(document, lattice).parent});
         },
         {[](const Editor& e) { return !to_take_out(e.session).empty(); },
          "select an object in a lattice first"});
    menu(back_to_rest_action, {},
         [](Editor& e) { e.session.run(Ungroup{selected_lattice(e.session)}); },
         {[](const Editor& e) {
              const Id lattice = selected_lattice(e.session);
              return lattice != 0 && !locked(e.session.document(), lattice);
          },
          "select a lattice first"});
    menu(keep_shape_action, {},
         [](Editor& e) {
             try {
                 e.session.run(kept_shapes(e.session, selected_lattice(e.session)));
             } catch (const Rejected& error) {
                 e.session.notices.say(ui::NoticeKind::error, "The shape was not kept",
                                       error.what());
             }
         },
         {[](const Editor& e) {
              const Id lattice = selected_lattice(e.session);
              return lattice != 0 && !locked(e.session.document(), lattice) &&
                     e.session.up_to_date() && keeps_shapes(e.session);
          },
          "select a lattice first, in a scene that is saved"});
}

} // namespace

void add_lattice_actions(std::vector<Action>& actions)
{
    const Menu tools(actions, "Tools");
    const Menu add(actions, "Add");
    add(
        lattice_action, {{.key = 'V', .shift = true}},
        [](Editor& e) {
            if (!put_lattice_round_selection(e.session)) return;
            e.choose_tool("Lattice");
        },
        something_selected(), true);
    add(
        tetrahedra_action, {{.key = 'Y', .shift = true}},
        [](Editor& e) {
            if (!put_tetrahedra_round_selection(e.session)) return;
            e.choose_tool("Tetrahedra");
        },
        something_selected(), true);
    add(
        fitted_tetrahedra_action, {},
        [](Editor& e) {
            if (!put_tetrahedra_round_selection(e.session, Around::fitted)) return;
            e.choose_tool("Tetrahedra");
        },
        something_selected(), true);
    tools("Proportional editing", {{'O'}},
          [](Editor& e) {
              bool& on = *proportional_switch(e);
              on = !on;
          },
          {[](const Editor& e) { return proportional_switch(e) != nullptr; },
           "choose the Lattice tool first"})
        .on = [](const Editor& e) {
        const bool* on = proportional_switch(e);
        return on && *on;
    };
    add_member_actions(actions);
}

} // namespace trivar
