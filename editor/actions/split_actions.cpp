// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/actions/split_actions.h"

#include "core/commands/cutting/cut.h"
#include "core/commands/cutting/split.h"
#include "editor/actions/menu.h"
#include "editor/editor.h"
#include "editor/tools/split/split.h"

namespace trivar {
namespace {

// The selection as who is parted, the active object, by which obstacles, all others. Nothing where
// it does not say that.
std::optional<Split> split_wish(const Session& session)
{
    const Id active = session.selected;
    std::optional<Split> out;
    for (const Id id : session.selected.ids()) {
        if (id == active) continue;
        std::optional<Split> one = split_at(session, {active}, id);
        if (!one) return {};
        if (!out)
            out = std::move(one);
        else
            out->splitting.obstacles.push_back({.object = id});
    }
    return out;
}

std::vector<Id> selected_parted(const Editor& e)
{
    std::vector<Id> out;
    for (const Id id : e.session.selected.ids())
        if (object(e.session.document(), id).splitting) out.push_back(id);
    return out;
}

std::vector<Id> selected_cut(const Editor& e)
{
    std::vector<Id> out;
    for (const Id id : e.session.selected.ids())
        if (object(e.session.document(), id).cutting) out.push_back(id);
    return out;
}

} // namespace

void add_split_actions(std::vector<Action>& actions)
{
    const Menu tools(actions, "Tools");
    tools("Split at obstacles", {},
          [](Editor& e) {
              if (const std::optional<Split> wish = split_wish(e.session)) e.session.run(*wish);
          },
          {[](const Editor& e) { return split_wish(e.session).has_value(); },
           "select the obstacles and, last, the object to split"});
    tools("Clear split", {}, [](Editor& e) { e.session.run(ClearSplit{selected_parted(e)}); },
          {[](const Editor& e) { return !selected_parted(e).empty(); },
           "select an object that is split first"});
    tools("Clear cuts", {}, [](Editor& e) { e.session.run(ClearCuts{selected_cut(e)}); },
          {[](const Editor& e) { return !selected_cut(e).empty(); },
           "select an object that is cut first"});
}

} // namespace trivar
