// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/actions/reset_actions.h"

#include "core/commands/cutting/incise.h"
#include "editor/actions/menu.h"
#include "editor/editor.h"
#include "editor/hands/motion.h"

namespace trivar {
namespace {

template <glm::dvec3 Transform::*part> void reset(Editor& e)
{
    std::vector<Id> ids;
    std::vector<Transform> transforms;
    for (const Stand& stand : stands_of(e.session.document(), e.session.selected.ids())) {
        if (stand.transform.*part == Transform{}.*part) continue;
        ids.push_back(stand.id);
        transforms.push_back(stand.transform);
        transforms.back().*part = Transform{}.*part;
    }
    if (!ids.empty()) e.session.run(arranged(ids, transforms));
}

template <glm::dvec3 Transform::*part> bool can_be_reset(const Editor& e)
{
    for (const Stand& stand : stands_of(e.session.document(), e.session.selected.ids()))
        if (stand.transform.*part != Transform{}.*part) return true;
    return false;
}

template <glm::dvec3 Transform::*part> Action reset_action(const std::string& name, int key)
{
    return {"Reset",
            name,
            {{.key = key, .alt = true}},
            reset<part>,
            {can_be_reset<part>, "select an object where it was changed first"}};
}

std::vector<Id> selected_incised(const Editor& e)
{
    std::vector<Id> out;
    for (const Id id : e.session.selected.ids())
        if (object(e.session.document(), id).incising) out.push_back(id);
    return out;
}

} // namespace

void add_reset_actions(std::vector<Action>& a)
{
    const Menu reset(a, "Reset");
    a.push_back(reset_action<&Transform::translation>("Reset position", 'G'));
    a.push_back(reset_action<&Transform::rotation_deg>("Reset rotation", 'R'));
    a.push_back(reset_action<&Transform::scale>("Reset scale", 'S'));
    reset("Clear incisions", {},
          [](Editor& e) {
              if (e.session.run(ClearIncisions{selected_incised(e)})) e.session.incision = {};
          },
          {[](const Editor& e) { return !selected_incised(e).empty(); },
           "select an object with incisions first"});
}

} // namespace trivar
