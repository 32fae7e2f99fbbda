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
}

} // namespace trivar
