// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/actions/lattice_actions.h"

#include "editor/actions/actions.h"
#include "editor/editor.h"
#include "editor/tools/lattice_round.h"

namespace trivar {

void add_lattice_actions(std::vector<Action>& actions)
{
    actions.push_back({"Add",
                       lattice_action,
                       {{.key = 'V', .shift = true}},
                       [](Editor& e) {
                           if (!put_lattice_round_selection(e.session)) return;
                           for (std::size_t i = 0; i < e.tools.size(); ++i)
                               if (e.tools[i]->page() == "lattice") e.choose_tool(i);
                       },
                       something_selected(),
                       true});
    actions.push_back({"Tools",
                       "Proportional editing",
                       {{'O'}},
                       [](Editor& e) {
                           if (const auto on = e.active_tool().proportional())
                               e.active_tool().set_proportional(!*on);
                       },
                       {[](const Editor& e) { return e.active_tool().page() == "lattice"; },
                        "choose the Lattice tool first"}});
    actions.back().on = [](const Editor& e) {
        return e.active_tool().proportional().value_or(false);
    };
}

} // namespace trivar
