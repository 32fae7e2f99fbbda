// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/actions/unwrap_actions.h"

#include "core/commands/unwrap.h"
#include "editor/editor.h"

namespace trivar {
namespace {

// Those of the selected objects that have a surface and are unwrapped, or are not.
std::vector<Id> selected_surfaces(const Editor& e, bool unwrapped)
{
    std::vector<Id> out;
    for (const Id id : e.session.selected.ids()) {
        const Object& each = object(e.session.document(), id);
        if (!holds_others(each.source) && each.unwrapping.has_value() == unwrapped)
            out.push_back(id);
    }
    return out;
}

} // namespace

void add_unwrap_actions(std::vector<Action>& actions)
{
    actions.push_back({"Tools",
                       "Unwrap",
                       {},
                       [](Editor& e) {
                           e.session.run(Unwrap{selected_surfaces(e, false), {}});
                       },
                       {[](const Editor& e) { return !selected_surfaces(e, false).empty(); },
                        "select an object with a surface that is not unwrapped yet"}});
    actions.push_back({"Tools",
                       "Clear unwrap",
                       {},
                       [](Editor& e) { e.session.run(ClearUnwrap{selected_surfaces(e, true)}); },
                       {[](const Editor& e) { return !selected_surfaces(e, true).empty(); },
                        "select an unwrapped object first"}});
}

} // namespace trivar
